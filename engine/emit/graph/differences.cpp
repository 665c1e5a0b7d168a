// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/differences.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace resonform {

namespace {

// Is sign * n a product of even powers?
bool is_square(const Graph& graph, Graph::Node n, int sign) {
    const Graph::Entry& e = graph.at(n);
    Rational root;
    if (e.op == Graph::Op::rational) return sign * e.value >= 0 && exact_root(sign * e.value, 2, root);
    if (e.op == Graph::Op::power) return sign > 0 && e.exponent % 2 == 0;
    if (e.op != Graph::Op::multiply) return false;
    for (const Graph::Node factor : e.operands) { // a number comes first
        if (!is_square(graph, factor, sign)) return false;
        sign = 1;
    }
    return true;
}

// Of such a product.
Graph::Node square_root(Graph& graph, Graph::Node n) {
    const Graph::Entry e = graph.at(n); // a copy: the graph grows
    if (e.op == Graph::Op::rational) return graph.root(n, 2);
    if (e.op == Graph::Op::power) return graph.power(e.operands.front(), e.exponent / 2);
    std::vector<Graph::Node> roots;
    for (const Graph::Node factor : e.operands) roots.push_back(square_root(graph, factor));
    return graph.multiply(roots);
}

} // namespace

Graph::Node factored_difference(Graph& graph, Graph::Node sum) {
    const std::vector<Graph::Node> terms = graph.at(sum).operands;
    if (graph.at(sum).op != Graph::Op::add || terms.size() != 2) return sum;
    for (const std::size_t k : {0U, 1U}) {
        const Graph::Node above = terms[k], below = terms[1 - k];
        if (!is_square(graph, above, 1) || !is_square(graph, below, -1)) continue;
        const Graph::Node a = square_root(graph, above), b = square_root(graph, graph.negate(below));
        return graph.multiply({graph.add({a, graph.negate(b)}), graph.add({a, b})});
    }
    return sum;
}

Graph::Node multiplied_out(Graph& graph, Graph::Node sum) {
    if (graph.at(sum).op != Graph::Op::add) return sum;
    const auto is_sum = [&](Graph::Node n) {
        const std::vector<Graph::Node>& terms = graph.at(n).operands;
        return graph.at(n).op == Graph::Op::add && !graph.stays_one_term(n) &&
               std::any_of(terms.begin(), terms.end(),
                           [&](Graph::Node term) { return graph.at(term).op == Graph::Op::symbol; });
    };
    std::vector<Graph::Node> terms;
    const std::vector<Graph::Node> operands = graph.at(sum).operands;
    for (const Graph::Node operand : operands) {
        const Graph::Entry e = graph.at(operand); // a copy: the graph grows
        const bool multiple = e.op == Graph::Op::multiply && e.operands.size() == 2 &&
                              graph.at(e.operands[0]).op == Graph::Op::rational && is_sum(e.operands[1]);
        if (!multiple) {
            terms.push_back(operand);
            continue;
        }
        const std::vector<Graph::Node> inner = graph.at(e.operands[1]).operands;
        for (const Graph::Node term : inner) terms.push_back(graph.multiply({e.operands[0], term}));
    }
    return terms.size() == operands.size() ? sum : graph.add(std::move(terms));
}

} // namespace resonform
