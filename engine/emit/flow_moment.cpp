// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/flow_moment.hpp"

#include "emit/prune.hpp"

#include <stdexcept>

namespace resonform {

FlowMoment::FlowMoment(Program& program, const RealForm& real, const Surroundings& surroundings,
                       const FlowValues& values, bool named)
    : lowering(program.graph, real.ring()) {
    const Ring& ring = *real.ring();
    const std::vector<bool> varies = depending(program.graph, varying_symbols(program));
    const auto define = [&](GeneratorId id, Graph::Node node) {
        lowering.define(id, node, varies[static_cast<std::size_t>(node)]);
    };
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (const auto known = surroundings.symbols.find(ring.generator(id).name);
            known != surroundings.symbols.end())
            define(id, known->second);
    const auto define_units = [&](const std::vector<RealForm::Pair>& ids, const std::vector<Unit>& units) {
        for (std::size_t k = 0; k < ids.size(); ++k) {
            define(ids[k].u, units[k].u);
            define(ids[k].v, units[k].v);
        }
    };
    define_units(real.modes(), values.modes);
    define_units(real.angles(), values.angles);
    for (std::size_t k = 0; k < values.slow.size(); ++k) define(real.slow()[k], values.slow[k]);
    define_roots(lowering, program, surroundings, named);
}

Polynomial over_eps(const RealForm& real, const Polynomial& p, int power) {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        if (real.ring()->exponent(t.monomial, real.eps()) < power)
            throw std::logic_error("a rate of a slow flow is not slow");
        terms.push_back({t.monomial - real.ring()->monomial(real.eps(), power), t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

} // namespace resonform
