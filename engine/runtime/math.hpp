// SPDX-License-Identifier: MIT
// Elementary functions and precision for any real type: double, long double, __float128,
// Boost.Multiprecision, Twice<...>. Generic code says
//
//   using math::sqrt;  sqrt(x)      overloads of std and __float128; others are found by their own namespace
#ifndef RESONFORM_RUNTIME_MATH
#define RESONFORM_RUNTIME_MATH

#include "runtime/float128.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace resonform::math {

using std::asinh;
using std::atan2;
using std::cos;
using std::exp;
using std::floor;
using std::hypot;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;

// Binary digits of a real type. (std::numeric_limits<__float128> is not specialised everywhere.)
template <class Real> inline constexpr int digits = std::numeric_limits<Real>::digits;
#ifdef RESONFORM_FLOAT128
template <> inline constexpr int digits<Float128> = 113;
#endif

// x^exponent by squaring; exponent >= 0.
template <class Real> constexpr Real power(Real x, int exponent) {
    Real result = Real(1);
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) result = result * x;
        x = x * x;
    }
    return result;
}

// The distance from 1 to the next number, 2^(1 - digits).
template <class Real> Real epsilon() { return power(Real(Real(1) / Real(2)), digits<Real> - 1); }

// False for NaN and infinities. (Meaningless under -ffast-math, as is every status then.)
template <class Real> bool finite(const Real& x) { return x - x == Real(0); }

template <class Real> bool is_not_a_number(const Real& x) {
    return !(x < Real(0)) && !(x == Real(0)) && !(x > Real(0));
}

template <class Real> Real not_a_number() { return Real(std::numeric_limits<double>::quiet_NaN()); }

template <class Real> Real magnitude(const Real& x) { return x < Real(0) ? Real(-x) : x; }

// The chunks of pi, each with 53 bits, add up to 260 bits in any type that is built from doubles.
template <class Real> Real pi() {
    constexpr std::array<double, 5> chunks{3.141592653589793, 1.2246467991473532e-16, -2.9947698097183397e-33,
                                           1.1124542208633653e-49, 5.672231979640316e-66};
    Real result = Real(0);
    for (std::size_t i = chunks.size(); i > 0; --i) result = result + Real(chunks[i - 1]);
    return result;
}

// The positive k-th root of x >= 0, k >= 2, from pow and one Newton step that removes its rounding.
template <class Real> Real root(const Real& x, int k) {
    if (!(x > Real(0))) return x == Real(0) ? x : not_a_number<Real>();
    const Real guess = pow(x, Real(Real(1) / Real(k)));
    return guess + (x / power(guess, k - 1) - guess) / Real(k);
}

} // namespace resonform::math

#endif
