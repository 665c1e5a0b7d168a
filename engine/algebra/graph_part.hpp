// SPDX-License-Identifier: GPL-3.0-or-later
// Homogeneous parts of series with coefficients in a CoefficientGraph, and their arithmetic.
#pragma once

#include "algebra/coefficient_graph.hpp"
#include "algebra/outer_keys.hpp"
#include "algebra/ring.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace resonform {

// sum_k coefficient_k * monomial_k, keys ascending, no zero. Coefficients are real: i stands in the keys.
struct GraphPart {
    std::vector<OuterKey> keys;
    std::vector<Coefficient> coefficients;
    bool real = true; // equal to its conjugate

    [[nodiscard]] bool empty() const { return keys.empty(); }
    [[nodiscard]] std::size_t size() const { return keys.size(); }
    friend bool operator==(const GraphPart&, const GraphPart&) = default;
};

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
    [[nodiscard]] GraphPart conjugate(const GraphPart& p) const;
    // d/d(field of the keys), not a phase
    [[nodiscard]] GraphPart derivative(const GraphPart& p, int field) const;
    // Every coefficient by a function of it (a derivation, a number times it).
    template <class Function> GraphPart each(const GraphPart& p, Function function) const {
        GraphPart result;
        for (std::size_t k = 0; k < p.size(); ++k)
            if (const Coefficient c = function(p.coefficients[k]); !c.is_zero()) {
                result.keys.push_back(p.keys[k]);
                result.coefficients.push_back(c);
            }
        result.real = is_real(result);
        return result;
    }

    // The terms of one sum, gathered before the graph sees them: factors of equal monomials come together.
    class Gathering;

private:
    [[nodiscard]] bool is_real(const GraphPart& p) const;
    void multiply_out(const GraphProduct& product, bool half, Gathering& gathering) const;
    [[nodiscard]] GraphPart collected(Gathering& gathering, bool half) const;
    void append_mirrored(GraphPart& half) const;

    std::shared_ptr<CoefficientGraph> graph_;
    OuterKeys keys_;
};

} // namespace resonform
