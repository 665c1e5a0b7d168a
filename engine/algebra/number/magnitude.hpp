// SPDX-License-Identifier: GPL-3.0-or-later
// An upper bound for the size of a number, with an exponent of any size (Arb's mag_t): where numbers are of
// the size 1e80 their powers are no doubles.
#pragma once

#include "algebra/number/complex_ball.hpp"

#include <mag.h>

namespace resonform {

class Magnitude {
public:
    Magnitude() { mag_init(value_); } // 0
    explicit Magnitude(const ComplexBall& c) : Magnitude() { acb_get_mag(value_, c.get()); }
    Magnitude(const Magnitude& other) : Magnitude() { mag_set(value_, other.value_); }
    Magnitude(Magnitude&& other) noexcept : Magnitude() { mag_swap(value_, other.value_); }
    Magnitude& operator=(const Magnitude& other) {
        if (this != &other) mag_set(value_, other.value_);
        return *this;
    }
    Magnitude& operator=(Magnitude&& other) noexcept {
        mag_swap(value_, other.value_);
        return *this;
    }
    ~Magnitude() { mag_clear(value_); }

    void add(const Magnitude& a) { mag_add(value_, value_, a.value_); }
    void add_product(const Magnitude& a, const Magnitude& b) { mag_addmul(value_, a.value_, b.value_); }
    [[nodiscard]] bool is_zero() const { return mag_is_zero(value_) != 0; }
    [[nodiscard]] bool is_finite() const { return mag_is_finite(value_) != 0; }
    [[nodiscard]] RealBall number() const {
        RealBall result;
        arf_set_mag(arb_midref(result.get()), value_);
        return result;
    }

private:
    mag_t value_;
};

} // namespace resonform
