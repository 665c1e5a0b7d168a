// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of a graph over a real type, by the names that emitted code calls.
#pragma once

#include "emit/graph/graph.hpp"
#include "runtime/scaled.hpp"
#include "runtime/twice.hpp"

namespace resonform {

// f(x), or f(x, y) of atan2 and hypot. Precondition: op is one of sin ... sqrt_sum_squares.
template <class Number> Number graph_function(Graph::Op op, const Number& x, const Number& y) {
    using namespace resonform::math;
    switch (op) {
    case Graph::Op::sin: return sin(x);
    case Graph::Op::cos: return cos(x);
    case Graph::Op::log: return log(x);
    case Graph::Op::log1p: return log1p(x);
    case Graph::Op::exp: return exp(x);
    case Graph::Op::expm1: return expm1(x);
    case Graph::Op::asinh: return asinh(x);
    case Graph::Op::sinh: return sinh(x);
    case Graph::Op::erf: return erf(x);
    case Graph::Op::atan2: return atan2(x, y);
    default: return hypot(x, y);
    }
}

} // namespace resonform
