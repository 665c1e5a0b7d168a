// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/quadratures.hpp"

#include "emit/display/identifier.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

// One table for equal integrands; names are made unique.
Graph::Node Quadratures::table(const std::string& name, Graph::Node integrand) {
    for (const ProgramTable& table : program_.tables)
        if (table.integrand == integrand) return table.value;
    const auto taken = [&](const std::string& candidate) {
        return std::any_of(program_.tables.begin(), program_.tables.end(),
                           [&](const ProgramTable& table) { return table.name == candidate; });
    };
    std::string unique = name;
    for (int k = 2; taken(unique); ++k) unique = fmt::format("{}_{}", name, k);
    const Graph::Node value = program_.graph.symbol("table " + unique); // a space: no parameter has this name
    program_.tables.push_back({unique, integrand, value});
    return value;
}

Graph::Node Quadratures::value(const Primitive& primitive, Lowering& lowering) {
    const Graph::Node integrand = lowering.polynomial(primitive.argument);
    integrands_[primitive.id] =
        primitive.over_slow_time ? integrand : program_.graph.multiply({clock_rate_, integrand});
    return table(identifier(primitive.name), integrands_[primitive.id]);
}

Graph::Node Quadratures::without_tables(const Polynomial& p, const Lowering& lowering) const {
    Lowering at_rate = lowering;
    for (const auto& [id, integrand] : integrands_)
        at_rate.define(id, program_.graph.multiply({program_.slow_time, integrand}), true);
    return at_rate.polynomial(p);
}

// The quadrature of a monomial quadrature * constants, nullptr for every other monomial.
const Primitive* Quadratures::only_quadrature(const Monomial& m, const Moment& call) const {
    const Primitive* found = nullptr;
    for (GeneratorId id = 0; id < solution_.ring->size(); ++id) {
        const int exponent = solution_.ring->exponent(m, id);
        const GeneratorKind kind = solution_.ring->generator(id).kind;
        const bool constant = !call.lowering.varying(id) && kind != GeneratorKind::phase;
        if (exponent == 0 || constant) continue;
        const auto primitive = std::find_if(solution_.primitives.begin(), solution_.primitives.end(),
                                            [&](const Primitive& p) { return p.id == id; });
        const bool quadrature =
            primitive != solution_.primitives.end() && primitive->kind == PrimitiveKind::quadrature;
        if (found != nullptr || exponent != 1 || !quadrature) return nullptr;
        found = &*primitive;
    }
    return found;
}

std::pair<Polynomial, Graph::Node> Quadratures::extract(const Polynomial& p, Moment& call,
                                                        const std::string& name) {
    std::vector<Term> rest;
    std::map<GeneratorId, std::vector<Term>> coefficients;
    for (const Term& t : p.terms()) {
        const Primitive* primitive = only_quadrature(t.monomial, call);
        if (primitive == nullptr)
            rest.push_back(t);
        else
            coefficients[primitive->id].push_back(
                {t.monomial - solution_.ring->monomial(primitive->id), t.coefficient});
    }
    std::vector<Graph::Node> integrand;
    for (auto& [id, terms] : coefficients) {
        const Graph::Node coefficient = call.lowering.polynomial(Polynomial::from_terms(std::move(terms)));
        integrand.push_back(program_.graph.multiply({coefficient, integrands_.at(id)}));
    }
    const Graph::Node value = integrand.empty()
                                  ? program_.graph.rational(0)
                                  : table("Q_" + name, program_.graph.add(std::move(integrand)));
    return {Polynomial::from_terms(std::move(rest)), value};
}

} // namespace resonform
