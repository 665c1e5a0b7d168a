// SPDX-License-Identifier: GPL-3.0-or-later
// The real types of verification and the elementary functions over them:
//
//   double, long double      hardware
//   Float128                 113 bits, libquadmath
//   DoubleDouble             106 bits in two doubles, libqd: six times faster than Float128, so it
//                            is the arithmetic of reference integrations
//
// Numbers pass from one type to another as unevaluated sums of three doubles.
#pragma once

#include "algebra/number/functions.hpp"
#include "algebra/number/number.hpp"
#include "runtime/math.hpp"

#include <qd/dd_real.h>
#include <quadmath.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace resonform {

using DoubleDouble = dd_real;

using Parts = std::array<double, 3>; // leading part first; their sum is the number

// Exact for every type here (159 bits), unless the lower parts underflow.
template <class Real> Parts to_parts(const Real& x) {
    Parts parts{};
    Real rest = x;
    for (double& part : parts) {
        part = static_cast<double>(rest);
        if (!std::isfinite(part)) break;
        rest -= part;
    }
    return parts;
}
template <> inline Parts to_parts(const DoubleDouble& x) { return {x.x[0], x.x[1], 0.0}; }

// The leading double of an exact number, of the remainder, and of the next remainder. Errors: refused, beyond
// 1e308 or below 1e-270 (but 0).
Parts to_parts(const Rational& value);

template <class Real> Real from_parts(const Parts& p) { return Real(p[2]) + Real(p[1]) + Real(p[0]); }

template <class To, class From> To convert(const From& x) { return from_parts<To>(to_parts(x)); }
template <class To, class From> std::vector<To> convert_all(const std::vector<From>& values) {
    std::vector<To> out;
    out.reserve(values.size());
    for (const From& value : values) out.push_back(convert<To>(value));
    return out;
}
template <class Real> Real from_rational(const Rational& value) { return from_parts<Real>(to_parts(value)); }
template <class Real> double to_double_value(const Real& x) { return to_parts(x)[0]; }

// epsilon: spacing of numbers at 1, divided by 2 (unit roundoff); digits: decimal digits carried.
template <class Real> struct RealTraits {
    static constexpr int digits = std::numeric_limits<Real>::digits10;
    static double roundoff() { return static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2; }
};
template <> struct RealTraits<Float128> {
    static constexpr int digits = 33;
    static double roundoff() { return 0x1p-113; }
};
template <> struct RealTraits<DoubleDouble> {
    static constexpr int digits = 31;
    static double roundoff() { return 0x1p-104; }
};

// Elementary functions by type: Math<Real>::sin(x).
template <class Real> struct Math {
    static Real sqrt(Real x) { return std::sqrt(x); }
    static Real exp(Real x) { return std::exp(x); }
    static Real log(Real x) { return std::log(x); }
    static Real sin(Real x) { return std::sin(x); }
    static Real cos(Real x) { return std::cos(x); }
    static Real tan(Real x) { return std::tan(x); }
    static Real sinh(Real x) { return std::sinh(x); }
    static Real cosh(Real x) { return std::cosh(x); }
    static Real tanh(Real x) { return std::tanh(x); }
    static Real asin(Real x) { return std::asin(x); }
    static Real acos(Real x) { return std::acos(x); }
    static Real atan(Real x) { return std::atan(x); }
    static Real asinh(Real x) { return std::asinh(x); }
    static Real acosh(Real x) { return std::acosh(x); }
    static Real atanh(Real x) { return std::atanh(x); }
    static Real erf(Real x) { return std::erf(x); }
    static Real pow(Real x, Real y) { return std::pow(x, y); }
};

template <> struct Math<Float128> {
    static Float128 sqrt(Float128 x) { return sqrtq(x); }
    static Float128 exp(Float128 x) { return expq(x); }
    static Float128 log(Float128 x) { return logq(x); }
    static Float128 sin(Float128 x) { return sinq(x); }
    static Float128 cos(Float128 x) { return cosq(x); }
    static Float128 tan(Float128 x) { return tanq(x); }
    static Float128 sinh(Float128 x) { return sinhq(x); }
    static Float128 cosh(Float128 x) { return coshq(x); }
    static Float128 tanh(Float128 x) { return tanhq(x); }
    static Float128 asin(Float128 x) { return asinq(x); }
    static Float128 acos(Float128 x) { return acosq(x); }
    static Float128 atan(Float128 x) { return atanq(x); }
    static Float128 asinh(Float128 x) { return asinhq(x); }
    static Float128 acosh(Float128 x) { return acoshq(x); }
    static Float128 atanh(Float128 x) { return atanhq(x); }
    static Float128 erf(Float128 x) { return erfq(x); }
    static Float128 pow(Float128 x, Float128 y) { return powq(x, y); }
};

template <> struct Math<DoubleDouble> {
    static DoubleDouble sqrt(const DoubleDouble& x) { return ::sqrt(x); }
    static DoubleDouble exp(const DoubleDouble& x) { return ::exp(x); }
    static DoubleDouble log(const DoubleDouble& x) { return ::log(x); }
    static DoubleDouble sin(const DoubleDouble& x) { return ::sin(x); }
    static DoubleDouble cos(const DoubleDouble& x) { return ::cos(x); }
    static DoubleDouble tan(const DoubleDouble& x) { return ::tan(x); }
    static DoubleDouble sinh(const DoubleDouble& x) { return ::sinh(x); }
    static DoubleDouble cosh(const DoubleDouble& x) { return ::cosh(x); }
    static DoubleDouble tanh(const DoubleDouble& x) { return ::tanh(x); }
    static DoubleDouble asin(const DoubleDouble& x) { return ::asin(x); }
    static DoubleDouble acos(const DoubleDouble& x) { return ::acos(x); }
    static DoubleDouble atan(const DoubleDouble& x) { return ::atan(x); }
    static DoubleDouble asinh(const DoubleDouble& x) { return ::asinh(x); }
    static DoubleDouble acosh(const DoubleDouble& x) { return ::acosh(x); }
    static DoubleDouble atanh(const DoubleDouble& x) { return ::atanh(x); }
    static DoubleDouble erf(const DoubleDouble& x) { return math::erf(x); }
    static DoubleDouble pow(const DoubleDouble& x, const DoubleDouble& y) { return ::exp(y * ::log(x)); }
};

// Of the functions that are known by their slope (algebra/number/functions.hpp).
template <class Real> Real value_of(Function f, const Real& x) {
    using M = Math<Real>;
    switch (f) {
    case Function::logarithm: return M::log(x);
    case Function::arc_sine: return M::asin(x);
    case Function::arc_cosine: return M::acos(x);
    case Function::arc_tangent: return M::atan(x);
    case Function::inverse_hyperbolic_sine: return M::asinh(x);
    case Function::inverse_hyperbolic_cosine: return M::acosh(x);
    case Function::inverse_hyperbolic_tangent: return M::atanh(x);
    default: return M::erf(x);
    }
}

} // namespace resonform
