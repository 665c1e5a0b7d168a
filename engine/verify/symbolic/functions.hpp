// SPDX-License-Identifier: GPL-3.0-or-later
// Values of elementary functions for the exact solution, by other formulas than emitted code has
// (emit/graph/from_expression.cpp), where there are some.
#pragma once

#include "algebra/number/functions.hpp"
#include "runtime/math.hpp"

#include <stdexcept>

namespace resonform {

// Precondition: f is not `named`, x is in its domain. Number: Wide, Float128.
template <class Number> Number value_of_function(Function f, const Number& x) {
    using math::asinh;
    using math::atan2;
    using math::cos;
    using math::erf;
    using math::exp;
    using math::log;
    using math::sin;
    using math::sinh;
    using math::sqrt;
    const Number one(1), two(2);
    switch (f) {
    case Function::exponential: return exp(x);
    case Function::sine: return sin(x);
    case Function::cosine: return cos(x);
    case Function::logarithm: return log(x);
    case Function::arc_tangent: return atan2(x, one);
    case Function::tangent: return Number(sin(x)) / Number(cos(x));
    case Function::hyperbolic_sine: return sinh(x);
    case Function::hyperbolic_cosine: { // 1 + 2 sinh(x/2)^2
        const Number half = sinh(Number(x / two));
        return one + two * half * half;
    }
    case Function::hyperbolic_tangent: { // s/sqrt(1 + s^2), s = sinh(x)
        const Number s = sinh(x);
        return s / Number(sqrt(Number(one + s * s)));
    }
    case Function::arc_sine: return atan2(x, Number(sqrt(Number(one - x * x))));
    case Function::arc_cosine: return atan2(Number(sqrt(Number(one - x * x))), x);
    case Function::inverse_hyperbolic_sine: return asinh(x);
    case Function::inverse_hyperbolic_cosine: return log(Number(x + sqrt(Number(x * x - one))));
    case Function::inverse_hyperbolic_tangent: return Number(log(Number((one + x) / (one - x)))) / two;
    case Function::error_function: return erf(x);
    case Function::named: break;
    }
    throw std::logic_error("value_of_function: a function without a value");
}

} // namespace resonform
