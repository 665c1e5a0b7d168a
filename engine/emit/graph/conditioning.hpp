// SPDX-License-Identifier: GPL-3.0-or-later
// Rewriting for accuracy, and the signs of nodes.
#pragma once

#include "algebra/ring/ring.hpp"
#include "algebra/signs/sign_set.hpp"
#include "emit/graph/graph.hpp"
#include "emit/graph/lower.hpp"

#include <set>

namespace resonform {

// The signs of a node for all values of its symbols, given nodes known to be positive.
SignSet signs_of(const Graph& graph, Graph::Node n, const std::set<Graph::Node>& positive);

// log(argument), argument in the ring of `lowering`. For argument = A + R, R a square root and
// D = R^2 - A^2 > 0 constant, it is asinh(A/sqrt(D)) + log(sqrt(D)): A + R loses all digits where A -> -R,
//   log((xi + sqrt(xi^2 + r^2))/r)   ->   asinh(xi/r)
Graph::Node lower_logarithm(Graph& graph, const Ring& ring, Lowering& lowering, const Polynomial& argument,
                            const std::set<Graph::Node>& positive);

} // namespace resonform
