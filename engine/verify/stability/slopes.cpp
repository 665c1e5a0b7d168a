// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/slopes.hpp"

#include "runtime/math.hpp"
#include "runtime/scaled.hpp"
#include "verify/run/spline.hpp"

#include <cstddef>

namespace resonform {

namespace {

using Values = std::vector<Wide>;

const Wide& value_at(const Values& values, Graph::Node n) { return values[static_cast<std::size_t>(n)]; }

// Of a function of one variable or two, by its k-th.
Wide slope_of_function(const Graph::Entry& e, const Values& values, const Wide& value, std::size_t k) {
    const Wide &x = value_at(values, e.operands.front()), &y = value_at(values, e.operands.back());
    switch (e.op) {
    case Graph::Op::sin: return cos(x);
    case Graph::Op::cos: return -sin(x);
    case Graph::Op::log: return 1 / x;
    case Graph::Op::log1p: return 1 / Wide(1 + x);
    case Graph::Op::exp: return value;
    case Graph::Op::expm1: return value + 1;
    case Graph::Op::asinh: return 1 / sqrt(Wide(1 + x * x));
    case Graph::Op::sinh: return cosh(x);
    case Graph::Op::erf: return 2 / sqrt(math::pi<Wide>()) * exp(Wide(-x * x));
    case Graph::Op::atan2: return (k == 0 ? y : Wide(-x)) / (x * x + y * y);
    case Graph::Op::spline: return spline(spline_of(*e.data), e.exponent + 1, x);
    default: return (k == 0 ? x : y) / value; // hypot
    }
}

// d node/d its k-th operand
Wide slope(const Graph& graph, Graph::Node n, const Values& values, std::size_t k) {
    const Graph::Entry& e = graph.at(n);
    const Wide &value = value_at(values, n), &x = value_at(values, e.operands[k]);
    switch (e.op) {
    case Graph::Op::add: return 1;
    case Graph::Op::doubled: return 0; // how its operand is rounded does not reach it
    case Graph::Op::multiply: {
        Wide others = 1;
        for (std::size_t j = 0; j < e.operands.size(); ++j)
            if (j != k) others *= value_at(values, e.operands[j]);
        return others;
    }
    case Graph::Op::power:
        return e.exponent < 0 ? Wide(e.exponent * value / x)
                              : Wide(e.exponent * math::power(x, e.exponent - 1));
    case Graph::Op::root: return value / (e.exponent * x);
    default: return slope_of_function(e, values, value, k);
    }
}

} // namespace

std::vector<Wide> slopes_of_output(const Graph& graph, Graph::Node output, const std::vector<Wide>& values) {
    std::vector<Wide> slopes(graph.size(), Wide(0));
    slopes[static_cast<std::size_t>(output)] = 1;
    for (Graph::Node n = output; n >= 0; --n) {
        const Wide& own = slopes[static_cast<std::size_t>(n)];
        if (own == 0) continue;
        for (std::size_t k = 0; k < graph.at(n).operands.size(); ++k) {
            const Wide passed = own * slope(graph, n, values, k);
            if (isfinite(passed)) slopes[static_cast<std::size_t>(graph.at(n).operands[k])] += passed;
        }
    }
    return slopes;
}

} // namespace resonform
