// SPDX-License-Identifier: GPL-3.0-or-later
// Reciprocals and powers in the graph. The operand is expanded into a quotient first: it is the leading part
// of a series, and short.
#include "algebra/graph/domain.hpp"
#include "algebra/graph/expansion.hpp"

namespace resonform {

namespace {

// 1/c
Coefficient reciprocal_of(CoefficientGraph& graph, Coefficient c) {
    const ExpandedCoefficient quotient = expand(graph, c);
    Coefficient result = graph.inverse(quotient.numerator);
    for (const auto& [divisor, times] : quotient.denominator)
        result = graph.product(result, graph.power(graph.divisor_value(divisor), times));
    return result;
}

} // namespace

// 1/(a + i b) = (a - i b)/(a^2 + b^2)
std::optional<GraphPart> GraphDomain::inverse(const Part& p) const {
    if (p.empty() || p.keys.back() > OuterKeys::imaginary) return std::nullopt;
    Coefficient norm;
    for (const Coefficient c : p.coefficients) norm = graph().sum(norm, graph().product(c, c));
    const Coefficient inverse = reciprocal_of(graph(), norm);
    GraphPart result{p.keys, {}, p.real};
    for (std::size_t k = 0; k < p.size(); ++k) {
        const Coefficient c = graph().product(p.coefficients[k], inverse);
        result.coefficients.push_back(OuterKeys::has_i(p.keys[k]) ? c.negative() : c);
    }
    return result;
}

std::optional<GraphPart> GraphDomain::rational_power(const Part& p, const Rational& exponent) const {
    if (p == one()) return p;
    if (p.size() != 1 || p.keys.front() != 0) return std::nullopt;
    const ExpandedCoefficient quotient = expand(graph(), p.coefficients.front());
    Polynomial below = ring()->one();
    for (const auto& [divisor, times] : quotient.denominator)
        below = ring()->multiply(below, ring()->power(polynomial(graph().divisor(divisor)), times));
    const auto inverse = ring()->inverse(below);
    if (!inverse) return std::nullopt;
    const auto power =
        ring()->rational_power(ring()->multiply(polynomial(quotient.numerator), *inverse), exponent);
    return power ? std::optional(constant(*power)) : std::nullopt;
}

} // namespace resonform
