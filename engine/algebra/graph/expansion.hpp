// SPDX-License-Identifier: GPL-3.0-or-later
// One coefficient of a graph as a quotient of polynomials.
//
//   inverse(a - b) - inverse(a + b)  ->  2 b / ((a - b) (a + b))
//
// The denominator is known but for factors that cancel, which values along a line show; the numerator is
// interpolated modulo primes, its homogeneous parts separately. The result is confirmed by a fresh prime and
// by one exact evaluation at a rational point.
#pragma once

#include "algebra/graph/numerator.hpp"

namespace resonform {

struct ExpandedCoefficient {
    LeafPolynomial numerator;
    DivisorPowers denominator;
    std::size_t points = 0, primes = 0; // the cost
};

struct ExpansionLimits {
    // The largest number of points for each prime; the numerator has fewer terms.
    std::size_t points = 1'000'000;
};

// Errors (refused): the limit.
ExpandedCoefficient expand(const CoefficientGraph& graph, Coefficient c, const ExpansionLimits& limits = {},
                           std::uint64_t seed = CoefficientGraph::usual_seed);

} // namespace resonform
