// SPDX-License-Identifier: GPL-3.0-or-later
// Derivations on a CoefficientGraph, each node's derivative made once: the graph of all derivatives of an
// order grows linearly with the order.
//
//   w a leaf with w' = v (another leaf):   (w a + 1/w)' = v a + w a' - v (1/w)(1/w)
#pragma once

#include "algebra/graph/coefficient_graph.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace resonform {

class GraphDerivation {
public:
    // The derivative of a leaf; the same in every call. It is called once for each leaf that occurs. A leaf
    // that is a function known by name gets a new leaf for its derivative.
    using OfLeaf = std::function<Coefficient(LeafId)>;

    explicit GraphDerivation(CoefficientGraph& graph) : graph_(&graph) {}

    Coefficient operator()(Coefficient a, const OfLeaf& of_leaf);

private:
    Coefficient of_node(NodeId node, const OfLeaf& of_leaf);
    Coefficient of_sum(NodeId node, const OfLeaf& of_leaf);
    Coefficient of_inverse(NodeId node, const OfLeaf& of_leaf);

    CoefficientGraph* graph_;
    std::vector<std::optional<Coefficient>> known_; // by node
};

} // namespace resonform
