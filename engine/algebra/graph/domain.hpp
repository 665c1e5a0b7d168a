// SPDX-License-Identifier: GPL-3.0-or-later
// The graph as a domain of coefficients for the series of a ring: fast variables, eps and phases stand in
// keys, parameters, slow variables and roots are leaves.
//
//   ring: z1, z2, eps, w1, w2      part:  w1^2/(w1 + w2) z1 z2  ->  {key(z1 z2): node}
#pragma once

#include "algebra/graph/derivative.hpp"
#include "algebra/graph/keyed_part.hpp"
#include "algebra/graph/outer_monomials.hpp"
#include "algebra/graph/part.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace resonform {

// Copies share one graph.
class GraphDomain {
public:
    using Part = GraphPart;

    // Series have exponents up to `largest`. Errors (refused): a monomial does not fit into a word.
    GraphDomain(RingPtr ring, int largest, std::uint64_t seed = CoefficientGraph::usual_seed);

    [[nodiscard]] CoefficientGraph& graph() const { return arithmetic_.graph(); }
    [[nodiscard]] const GraphArithmetic& arithmetic() const { return arithmetic_; }
    [[nodiscard]] const RingPtr& ring() const { return state_->monomials.ring(); }

    // --- as every domain -----------------------------------------------------------------------
    // Errors (refused): a coefficient that is no rational function of independent symbols.
    [[nodiscard]] Part constant(const Polynomial& p) const;
    [[nodiscard]] Part one() const { return arithmetic_.constant(graph().number(1)); }
    [[nodiscard]] bool is_zero(const Part& p) const { return p.empty(); }
    [[nodiscard]] Part reduce(Part p) const { return p; }
    [[nodiscard]] Part dot(const std::vector<ProductOf<Part>>& products) const {
        return arithmetic_.dot(products);
    }
    [[nodiscard]] Part combination(const std::vector<std::pair<Rational, const Part*>>& addends) const {
        return arithmetic_.combination(addends);
    }
    [[nodiscard]] std::optional<Part> inverse(const Part& p) const;
    [[nodiscard]] std::optional<Part> rational_power(const Part& p, const Rational& exponent) const;
    [[nodiscard]] Part conjugate(const Part& p) const { return arithmetic_.conjugate(p); }
    // d/d(id) of a fast, small or slow generator.
    [[nodiscard]] Part derivative(const Part& p, GeneratorId id) const;
    [[nodiscard]] Part angle_derivative(const Part& p, GeneratorId phase) const;
    [[nodiscard]] Part without_vanishing(Part p, const std::vector<GeneratorId>& /*outer*/) const {
        return p;
    }
    template <class ShareOf>
    [[nodiscard]] std::vector<Part> split(const Part& p, const std::vector<GeneratorId>& outer,
                                          ShareOf share_of) const;

    // --- between ring and graph ----------------------------------------------------------------
    [[nodiscard]] OuterKey key(const Monomial& m) const { return state_->monomials.key(m); }
    [[nodiscard]] Monomial monomial(OuterKey key) const { return state_->monomials.monomial(key); }
    [[nodiscard]] Coefficient coefficient(const Polynomial& p) const;        // real, without outer generators
    [[nodiscard]] Coefficient reciprocal(const Polynomial& p) const;         // likewise, not zero
    [[nodiscard]] LeafPolynomial leaf_polynomial(const Polynomial& p) const; // exponents >= 0
    [[nodiscard]] Polynomial polynomial(const LeafPolynomial& p) const;      // back in the ring
    [[nodiscard]] std::optional<LeafId> leaf_of(GeneratorId id) const;       // if it has become one

private:
    struct State {
        OuterMonomials<OuterKey> monomials;
        std::map<GeneratorId, LeafId> leaves = {};
        std::vector<GeneratorId> generators = {};                // by leaf
        std::map<GeneratorId, GraphDerivation> derivations = {}; // by slow variable
    };
    [[nodiscard]] LeafId leaf(GeneratorId id) const;
    [[nodiscard]] Coefficient power(GeneratorId id, int exponent) const;

    std::shared_ptr<State> state_;
    GraphArithmetic arithmetic_;
};

template <class ShareOf>
std::vector<GraphPart> GraphDomain::split(const Part& p, const std::vector<GeneratorId>& outer,
                                          ShareOf share_of) const {
    return shares_of(p, [&](OuterKey key) { return share_of(ring()->restricted(monomial(key), outer)); });
}

} // namespace resonform
