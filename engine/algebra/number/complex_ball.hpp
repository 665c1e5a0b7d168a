// SPDX-License-Identifier: GPL-3.0-or-later
// A complex number known to lie in a rectangle (Arb's acb_t).
#pragma once

#include "algebra/number/real_ball.hpp"

#include <acb.h>

namespace resonform {

class ComplexBall {
public:
    ComplexBall() { acb_init(value_); } // exactly 0
    explicit ComplexBall(std::int64_t number) : ComplexBall() { acb_set_si(value_, number); }
    ComplexBall(const RealBall& re, const RealBall& im) : ComplexBall() {
        acb_set_arb_arb(value_, re.get(), im.get());
    }
    ComplexBall(const ComplexBall& other) : ComplexBall() { acb_set(value_, other.value_); }
    ComplexBall(ComplexBall&& other) noexcept : ComplexBall() { acb_swap(value_, other.value_); }
    ComplexBall& operator=(const ComplexBall& other) {
        if (this != &other) acb_set(value_, other.value_);
        return *this;
    }
    ComplexBall& operator=(ComplexBall&& other) noexcept {
        acb_swap(value_, other.value_);
        return *this;
    }
    ~ComplexBall() { acb_clear(value_); }

    [[nodiscard]] acb_ptr get() { return value_; }
    [[nodiscard]] acb_srcptr get() const { return value_; }
    [[nodiscard]] RealBall re() const { return copy(acb_realref(value_)); }
    [[nodiscard]] RealBall im() const { return copy(acb_imagref(value_)); }

    [[nodiscard]] ComplexBall conjugate() const {
        ComplexBall result;
        acb_conj(result.value_, value_);
        return result;
    }
    [[nodiscard]] ComplexBall negative() const {
        ComplexBall result;
        acb_neg(result.value_, value_);
        return result;
    }
    [[nodiscard]] bool is_zero() const { return acb_is_zero(value_) != 0; } // exactly
    [[nodiscard]] bool contains_zero() const { return acb_contains_zero(value_) != 0; }
    // Are there numbers in both?
    [[nodiscard]] bool overlaps(const ComplexBall& other) const {
        return acb_overlaps(value_, other.value_) != 0;
    }

private:
    static RealBall copy(arb_srcptr part) {
        RealBall result;
        arb_set(result.get(), part);
        return result;
    }

    acb_t value_;
};

inline ComplexBall plus(const ComplexBall& a, const ComplexBall& b, std::int64_t bits) {
    ComplexBall result;
    acb_add(result.get(), a.get(), b.get(), bits);
    return result;
}

inline ComplexBall times(const ComplexBall& a, const ComplexBall& b, std::int64_t bits) {
    ComplexBall result;
    acb_mul(result.get(), a.get(), b.get(), bits);
    return result;
}

// Everything (not finite) where b may be zero.
inline ComplexBall over(const ComplexBall& a, const ComplexBall& b, std::int64_t bits) {
    ComplexBall result;
    acb_div(result.get(), a.get(), b.get(), bits);
    return result;
}

} // namespace resonform
