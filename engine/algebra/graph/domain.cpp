// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/domain.hpp"

#include "algebra/number/error.hpp"
#include "algebra/ring/polynomial.hpp"

#include <algorithm>

namespace resonform {

namespace {

[[noreturn]] void refuse_algebraic(const Ring& ring, const Generator& g) {
    bool slow = false; // numbers do not depend on it
    for (GeneratorId id = 0; id < ring.size(); ++id)
        slow = slow || ring.generator(id).kind == GeneratorKind::slow;
    refuse(
        {"coefficients in a graph are rational functions of independent symbols",
         g.kind == GeneratorKind::root && g.radicand.terms().size() > 1 ? "a root whose radicand is a sum"
                                                                        : g.name,
         slow ? "leave out --coefficients graph"
              : "leave out --coefficients graph, make it a parameter of its own, or, with a value for every "
                "parameter, take numbers: --digits 30",
         {}});
}

} // namespace

GraphDomain::GraphDomain(RingPtr ring, int largest, std::uint64_t seed)
    : state_(std::make_shared<State>(State{OuterMonomials<OuterKey>(std::move(ring), largest)})),
      arithmetic_(std::make_shared<CoefficientGraph>(seed), state_->monomials.keys()) {}

GraphPart GraphDomain::constant(const Polynomial& p) const {
    std::vector<Part> parts;
    for (const auto& [monomial, polynomial] : ring()->collect(p, state_->monomials.outer()))
        parts.push_back(arithmetic_.constant(coefficient(polynomial), key(monomial)));
    std::vector<std::pair<Rational, const Part*>> addends;
    for (const Part& part : parts) addends.emplace_back(1, &part);
    return combination(addends);
}

Coefficient GraphDomain::coefficient(const Polynomial& p) const {
    const Ring& ring = *this->ring();
    std::vector<GraphTerm> terms;
    for (const Term& t : p.terms()) {
        Coefficient product = graph().number(t.coefficient);
        for (GeneratorId id = 1; id < ring.size(); ++id)
            if (const int exponent = ring.exponent(t.monomial, id); exponent != 0)
                product = graph().product(product, power(id, exponent));
        terms.push_back({product.factor, product.node, CoefficientGraph::one_node});
    }
    return graph().dot(terms);
}

// A root of index 1 is a quotient, unless a relation eliminates another generator in favour of it.
Coefficient GraphDomain::power(GeneratorId id, int exponent) const {
    const Ring& ring = *this->ring();
    const Generator& g = ring.generator(id);
    LeafPolynomial value;
    if (g.kind == GeneratorKind::root && g.index == 1 && ring.reduce(g.radicand) != ring.gen(id))
        value = leaf_polynomial(ring.reduce(g.radicand));
    else
        value = LeafPolynomial::leaf(leaf(id));
    return graph().power(exponent < 0 ? graph().inverse(value) : graph().polynomial(value),
                         std::abs(exponent));
}

// 1/(m q) with a monomial m such that q has no negative exponent
Coefficient GraphDomain::reciprocal(const Polynomial& p) const {
    const Ring& ring = *this->ring();
    Monomial common;
    Coefficient inverse = graph().number(1);
    for (GeneratorId id = 1; id < ring.size(); ++id) {
        const int least = ring.lowest_exponent(p, id);
        if (least >= 0) continue;
        common = common + ring.monomial(id, least);
        inverse = graph().product(inverse, power(id, -least));
    }
    return graph().product(inverse, graph().inverse(leaf_polynomial(divided(p, common))));
}

LeafId GraphDomain::leaf(GeneratorId id) const {
    const auto known = state_->leaves.find(id);
    if (known != state_->leaves.end()) return known->second;
    const Generator& g = ring()->generator(id);
    if (ring()->is_algebraic(id)) refuse_algebraic(*ring(), g);
    const LeafId leaf = graph().add_leaf(g.name);
    state_->leaves.emplace(id, leaf);
    state_->generators.push_back(id);
    return leaf;
}

std::optional<LeafId> GraphDomain::leaf_of(GeneratorId id) const {
    const auto known = state_->leaves.find(id);
    return known == state_->leaves.end() ? std::nullopt : std::optional(known->second);
}

LeafPolynomial GraphDomain::leaf_polynomial(const Polynomial& p) const {
    const Ring& ring = *this->ring();
    LeafPolynomial result;
    for (const Term& t : p.terms()) {
        std::map<LeafId, int> powers;
        for (GeneratorId id = 0; id < ring.size(); ++id)
            if (const int exponent = ring.exponent(t.monomial, id); exponent != 0)
                powers[leaf(id)] = exponent;
        result.add(LeafPowers(powers.begin(), powers.end()), t.coefficient);
    }
    return result;
}

Polynomial GraphDomain::polynomial(const LeafPolynomial& p) const {
    std::vector<Term> terms;
    for (const auto& [powers, coefficient] : p.terms()) {
        Monomial m;
        for (const auto& [leaf, exponent] : powers)
            m = m + ring()->monomial(state_->generators[leaf], exponent);
        terms.push_back({m, coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

GraphPart GraphDomain::angle_derivative(const Part& p, GeneratorId phase) const {
    return arithmetic_.angle_derivative(p, state_->monomials.field(phase));
}

GraphPart GraphDomain::derivative(const Part& p, GeneratorId id) const {
    if (const int field = state_->monomials.field(id); field >= 0) return arithmetic_.derivative(p, field);
    GraphDerivation& derivation = state_->derivations.try_emplace(id, graph()).first->second;
    const Ring& ring = *this->ring();
    const auto of_leaf = [&](LeafId leaf) {
        return coefficient(ring.derivative(ring.gen(state_->generators[leaf]), id));
    };
    return arithmetic_.each(p, [&](Coefficient c) { return derivation(c, of_leaf); });
}

} // namespace resonform
