// SPDX-License-Identifier: MIT
// Elementary functions and precision for any real type: double, long double, __float128,
// Boost.Multiprecision, Twice<...>. Generic code says
//
//   using math::sqrt;  sqrt(x)      overloads of std and __float128; others are found by their own namespace
#ifndef RESONFORM_RUNTIME_MATH
#define RESONFORM_RUNTIME_MATH

// Statuses are found by NaN and infinity, and double words by rounding errors: a compiler that reckons with
// neither returns wrong numbers in silence.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||                     \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "resonform: evaluators want IEEE arithmetic; compile without -Ofast, -ffast-math and its parts"
#endif

#include "runtime/float128.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <type_traits>

namespace resonform::math {

using std::asinh;
using std::atan2;
using std::cos;
using std::erf;
using std::exp;
using std::expm1;
using std::floor;
using std::hypot;
using std::log;
using std::log1p;
using std::pow;
using std::sin;
using std::sinh;
using std::sqrt;

// Binary digits of a real type, of a decimal one those that its digits are worth.
// (std::numeric_limits<__float128> is not specialised everywhere.)
template <class Real> constexpr int digits_of() {
    using Limits = std::numeric_limits<Real>;
    static_assert(Limits::digits > 0 && Limits::digits < 1000000, "a real type has a fixed number of digits");
    static_assert(Limits::has_quiet_NaN && Limits::has_infinity, "a real type has numbers that are none");
    return Limits::radix == 10 ? Limits::digits * 3321 / 1000 : Limits::digits;
}
template <class Real> inline constexpr int digits = digits_of<Real>();
#ifdef RESONFORM_FLOAT128
template <> inline constexpr int digits<Float128> = 113;
#endif

// Real, or a type of some more digits if the processor has one: for numbers whose rounding error every point
// of a table would inherit. (Doubled precision would take longer than all the rest of a construction.)
template <class Real> struct FineOf { using type = Real; };
template <> struct FineOf<double> {
    using type = std::conditional_t<digits<long double> == 64, long double, double>;
};
template <class Real> using Fine = typename FineOf<Real>::type;

template <class Number, class Real, std::size_t Size>
std::array<Number, Size> widened(const std::array<Real, Size>& values) {
    std::array<Number, Size> wide;
    for (std::size_t k = 0; k < Size; ++k) wide[k] = Number(values[k]);
    return wide;
}

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

// The least number > 0 with all its digits.
template <class Real> Real smallest() { return std::numeric_limits<Real>::min(); }
#ifdef RESONFORM_FLOAT128
template <> inline Float128 smallest<Float128>() { return power(Float128(0.5), 16382); }
#endif

// False for NaN and infinities.
// NOLINTNEXTLINE(misc-redundant-expression): inf - inf is not a number
template <class Real> bool finite(const Real& x) { return x - x == Real(0); }

template <class Real> bool is_not_a_number(const Real& x) {
    return !(x < Real(0)) && !(x == Real(0)) && !(x > Real(0));
}

template <class Real> Real not_a_number() { return Real(std::numeric_limits<double>::quiet_NaN()); }

template <class Real> Real magnitude(const Real& x) { return x < Real(0) ? Real(-x) : x; }

// a, unless b is larger; so that a number b that is none is passed over.
template <class Real> Real larger(const Real& a, const Real& b) { return a < b ? b : a; }

// NaN, if any is.
// NOLINTNEXTLINE(misc-redundant-expression): NaN differs from itself
template <class Real> Real smaller(const Real& a, const Real& b) { return b < a || !(b == b) ? b : a; }

// An exact number: 2^exponent times the sum of doubles of which each is next to what those before leave. In
// double it is correctly rounded, in wider types to half a unit of the last place.
template <class Real, class Parts = std::initializer_list<double>>
Real number(const Parts& parts, int exponent = 0) {
    Real result = Real(0);
    for (auto part = parts.end(); part != parts.begin();)
        if (--part == parts.begin() || 53 < digits<Real>) result = result + Real(*part);
    const Real base = exponent < 0 ? Real(Real(1) / Real(2)) : Real(2);
    for (int left = exponent < 0 ? -exponent : exponent, step = 0; left > 0; left -= step) {
        step = left < 512 ? left : 512;
        result = result * power(base, step);
    }
    return result;
}

// atan(1/n) by its series
template <class Real> Real arctangent_of_inverse(int n) {
    Real power = Real(Real(1) / Real(n)), sum = power;
    for (int k = 3; power > epsilon<Real>() / Real(n); k += 2) {
        power = power / Real(n * n);
        const Real term = power / Real(k);
        sum = k % 4 == 3 ? Real(sum - term) : Real(sum + term);
    }
    return sum;
}

// By chunks, each with 53 bits, that add up to 371 bits in any type that is built from doubles; of types with
// more by Machin's formula.
template <class Real> Real pi() {
    if constexpr (371 < digits<Real>)
        return Real(16) * arctangent_of_inverse<Real>(5) - Real(4) * arctangent_of_inverse<Real>(239);
    constexpr std::array<double, 7> chunks{
        3.141592653589793,     1.2246467991473532e-16, -2.9947698097183397e-33, 1.1124542208633653e-49,
        5.672231979640316e-66, 1.7449862161352486e-83, 6.02937273224954e-100};
    Real result = Real(0);
    for (std::size_t i = chunks.size(); i > 0; --i) result = result + Real(chunks[i - 1]);
    return result;
}

// 1/x; not a number where x is not finite: a power beyond the range of Real does not take its term away.
// NOLINTNEXTLINE(misc-redundant-expression): as above
template <class Real> Real per(const Real& x) { return Real(1) / x + (x - x); }

// x times a power of two: exact, in range. (Twice<...> has its own.)
template <class Real> Real scaled_by(const Real& x, double power_of_two) { return x * Real(power_of_two); }

// Zero, or of a size between 1/bound and bound.
template <class Real> bool within(const Real& x, double bound) {
    return x == Real(0) || (!(magnitude(x) > Real(bound)) && !(magnitude(x) < Real(1 / bound)));
}

// The positive k-th root of x >= 0, k >= 2, from pow and two Newton steps that remove its rounding: of a type
// that doubles another pow has half the digits.
template <class Real> Real root(const Real& x, int k) {
    if (!(x > Real(0))) return x == Real(0) ? x : not_a_number<Real>();
    Real guess = pow(x, Real(Real(1) / Real(k)));
    for (int step = 0; step < 2; ++step) guess = guess + (x / power(guess, k - 1) - guess) / Real(k);
    return guess;
}

// erf(x) = 2/sqrt(pi) exp(-x^2) sum_n 2^n x^(2n+1)/(2n+1)!!, where all terms have one sign; for types that
// have none of their own. Beyond x^2 = digits*log(2) it is 1.
template <class Real> Real erf(const Real& x) {
    const Real square = x * x;
    if (!(square < Real(0.7 * digits<Real> + 2))) return x < Real(0) ? Real(-1) : x > Real(0) ? Real(1) : x;
    Real term = x, sum = x;
    for (int n = 1; n < 8 * digits<Real> && magnitude(term) > epsilon<Real>() * magnitude(sum); ++n) {
        term = term * square * Real(2) / Real(2 * n + 1);
        sum = sum + term;
    }
    return sum * Real(exp(Real(-square))) * Real(2) / Real(sqrt(pi<Real>()));
}

} // namespace resonform::math

namespace resonform {

// The type of a lane, of numbers that are several side by side (runtime/pack.hpp).
template <class Number> struct OneOf { using type = Number; };

} // namespace resonform

#endif
