// SPDX-License-Identifier: GPL-3.0-or-later
// Degree and height of the coefficients of a graph, and so the probability that one of its decisions is
// wrong.
//
// With D the product of all divisors and L the common denominator of all numbers, a node is
// (integer polynomial in leaves) / (D^r L^l); r, l, a bound for the degree above D^r and for the logarithm of
// the sum of the coefficients' absolute values follow from its operands.
#pragma once

#include "algebra/graph/coefficient_graph.hpp"

namespace resonform {

struct GraphBounds {
    int degree = 0;  // of the numerator of a difference of two coefficients, over their common denominator
    double bits = 0; // of its largest coefficient
    // The probability that any of the graph's decisions by value is wrong: two coefficients differ by a
    // numerator that is not zero, which vanishes at a random point with probability degree/p (Schwartz;
    // Zippel), or modulo a random prime, at all points.
    double error_probability = 0;
};

GraphBounds bounds_of(const CoefficientGraph& graph);

} // namespace resonform
