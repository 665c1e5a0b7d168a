// SPDX-License-Identifier: GPL-3.0-or-later
// A real number known to lie in [middle - radius, middle + radius], of any precision (Arb's arb_t).
#pragma once

#include "algebra/number/number.hpp"

#include <arb.h>

#include <cstdint>
#include <string>
#include <utility>

namespace resonform {

class RealBall {
public:
    RealBall() { arb_init(value_); } // exactly 0
    explicit RealBall(std::int64_t number) : RealBall() { arb_set_si(value_, number); }
    RealBall(const Rational& number, std::int64_t bits);
    RealBall(const RealBall& other) : RealBall() { arb_set(value_, other.value_); }
    RealBall(RealBall&& other) noexcept : RealBall() { arb_swap(value_, other.value_); }
    RealBall& operator=(const RealBall& other) {
        if (this != &other) arb_set(value_, other.value_);
        return *this;
    }
    RealBall& operator=(RealBall&& other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~RealBall() { arb_clear(value_); }

    [[nodiscard]] arb_ptr get() { return value_; }
    [[nodiscard]] arb_srcptr get() const { return value_; }

    [[nodiscard]] RealBall negative() const {
        RealBall result;
        arb_neg(result.value_, value_);
        return result;
    }
    [[nodiscard]] bool is_zero() const { return arb_is_zero(value_) != 0; } // exactly
    [[nodiscard]] bool contains_zero() const { return arb_contains_zero(value_) != 0; }
    [[nodiscard]] bool is_positive() const { return arb_is_positive(value_) != 0; } // all of it
    [[nodiscard]] bool is_finite() const { return arb_is_finite(value_) != 0; }
    [[nodiscard]] int sign() const { return arb_sgn_nonzero(value_); } // 0: zero is in it
    // Are there numbers in both?
    [[nodiscard]] bool overlaps(const RealBall& other) const {
        return arb_overlaps(value_, other.value_) != 0;
    }
    // The same middle and the same radius.
    friend bool operator==(const RealBall& a, const RealBall& b) {
        return arb_equal(a.value_, b.value_) != 0;
    }

private:
    arb_t value_;
};

Rational middle(const RealBall& ball); // exactly
double nearest_double(const RealBall& ball);
// The middle, rounded to `digits` significant decimal digits.
Rational rounded(const RealBall& ball, int digits);
// How many bits of the middle are known: radius < 2^-n |middle|, and n <= 0 where zero is in the ball.
std::int64_t accurate_bits(const RealBall& ball);
// The smallest e with |x| <= 2^e, or 1 more; far below all others for 0.
std::int64_t binary_exponent(const RealBall& ball);

} // namespace resonform
