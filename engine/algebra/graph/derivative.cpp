// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/derivative.hpp"

namespace resonform {

Coefficient GraphDerivation::operator()(Coefficient a, const OfLeaf& of_leaf) {
    if (a.is_zero()) return {};
    return graph_->scaled(a.factor, of_node(a.node, of_leaf));
}

Coefficient GraphDerivation::of_node(NodeId node, const OfLeaf& of_leaf) {
    if (node < known_.size() && known_[node]) return *known_[node];
    Coefficient result;
    switch (graph_->kind(node)) {
    case CoefficientGraph::Kind::leaf: result = of_leaf(graph_->index_of(node)); break;
    case CoefficientGraph::Kind::inverse: result = of_inverse(node, of_leaf); break;
    case CoefficientGraph::Kind::sum: result = of_sum(node, of_leaf); break;
    }
    if (node >= known_.size()) known_.resize(graph_->size());
    known_[node] = result;
    return result;
}

// (sum c a b)' = sum c a' b + sum c a b'
Coefficient GraphDerivation::of_sum(NodeId node, const OfLeaf& of_leaf) {
    const auto form = graph_->terms_of(node); // a copy: the graph grows meanwhile
    const std::vector<GraphTerm> terms(form.begin(), form.end());
    std::vector<GraphTerm> derived;
    RationalTable& rationals = graph_->rationals();
    const auto add = [&](RationalId factor, NodeId derivative_of, NodeId other) {
        const Coefficient d = of_node(derivative_of, of_leaf);
        if (!d.is_zero()) derived.push_back({rationals.multiply(factor, d.factor), d.node, other});
    };
    for (const GraphTerm& t : terms) {
        add(t.factor, t.left, t.right);
        add(t.factor, t.right, t.left);
    }
    return graph_->dot(derived);
}

// (1/d)' = -d' (1/d)(1/d)
Coefficient GraphDerivation::of_inverse(NodeId node, const OfLeaf& of_leaf) {
    const Coefficient change = (*this)(graph_->divisor_value(graph_->index_of(node)), of_leaf);
    const Coefficient self{RationalTable::one, node};
    return graph_->product(change.negative(), graph_->product(self, self));
}

} // namespace resonform
