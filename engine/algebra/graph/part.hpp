// SPDX-License-Identifier: GPL-3.0-or-later
// Homogeneous parts of series with coefficients in a CoefficientGraph, and their arithmetic.
#pragma once

#include "algebra/graph/coefficient_graph.hpp"
#include "algebra/graph/keyed_part.hpp"
#include "algebra/ring/ring.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace resonform {

using GraphPart = KeyedPart<OuterKey, Coefficient>;
using GraphProduct = ProductOf<GraphPart>;

class GraphArithmetic {
public:
    GraphArithmetic(std::shared_ptr<CoefficientGraph> graph, const OuterKeys& keys)
        : graph_(std::move(graph)), keys_(keys) {}

    [[nodiscard]] CoefficientGraph& graph() const { return *graph_; }
    [[nodiscard]] const std::shared_ptr<CoefficientGraph>& shared_graph() const { return graph_; }
    [[nodiscard]] const OuterKeys& keys() const { return keys_; }

    [[nodiscard]] GraphPart constant(Coefficient c, OuterKey key = 0) const;
    // Sums of products, one graph sum for each monomial. Where all factors are real, only one of two
    // conjugate monomials is computed.
    [[nodiscard]] GraphPart dot(const std::vector<GraphProduct>& products) const;
    [[nodiscard]] GraphPart
    combination(const std::vector<std::pair<Rational, const GraphPart*>>& addends) const;
    [[nodiscard]] GraphPart conjugate(const GraphPart& p) const { return conjugated(keys_, p); }
    // d/d(field of the keys): not of a phase, of a phase
    [[nodiscard]] GraphPart derivative(const GraphPart& p, int field) const;
    [[nodiscard]] GraphPart angle_derivative(const GraphPart& p, int field) const;
    // Every coefficient by a function of it (a derivation, a number times it).
    template <class Function> GraphPart each(const GraphPart& p, Function function) const {
        GraphPart result;
        for (std::size_t k = 0; k < p.size(); ++k)
            if (const Coefficient c = function(p.coefficients[k]); !c.is_zero()) result.append(p.keys[k], c);
        result.real = equals_its_conjugate(keys_, result);
        return result;
    }

    // The terms of one sum, gathered before the graph sees them: factors of equal monomials come together.
    class Gathering;

private:
    void multiply_out(const GraphProduct& product, bool half, Gathering& gathering) const;
    [[nodiscard]] GraphPart collected(Gathering& gathering, bool half) const;
    [[nodiscard]] Coefficient times(int number, Coefficient c) const;

    std::shared_ptr<CoefficientGraph> graph_;
    OuterKeys keys_;
};

} // namespace resonform
