// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals with rational ends: what is proved about a number when only its roots are approximate.
#pragma once

#include "algebra/number/number.hpp"

namespace resonform {

// low <= x <= high.
struct Interval {
    Rational low, high;

    explicit Interval(const Rational& exact) : low(exact), high(exact) {}
    Interval(const Rational& l, const Rational& h) : low(l), high(h) {}

    [[nodiscard]] bool positive() const { return cln::plusp(low); }
    [[nodiscard]] bool excludes_zero() const { return cln::plusp(low) || cln::minusp(high); }
};

Interval operator+(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
Interval reciprocal(const Interval& a);          // a.excludes_zero()
Interval power(const Interval& a, int exponent); // exponent < 0: a.excludes_zero()
// The k-th root of a positive interval, k >= 1: ends are multiples of 2^-bits.
Interval root(const Interval& a, int k, int bits);

} // namespace resonform
