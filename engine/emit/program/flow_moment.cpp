// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_moment.hpp"

#include "emit/display/divisor_fractions.hpp"
#include "emit/program/prune.hpp"

#include <algorithm>
#include <stdexcept>

namespace resonform {

FlowMoment::FlowMoment(Program& program, const RealForm& real, const Surroundings& surroundings,
                       const FlowValues& values, bool named)
    : lowering(program.graph, real.ring()), graph_(program.graph), real_(real), units_(values.modes) {
    units_.insert(units_.end(), values.angles.begin(), values.angles.end());
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
            if (!ids[k].is_real()) define(ids[k].v, units[k].v);
        }
    };
    define_units(real.modes(), values.modes);
    define_units(real.angles(), values.angles);
    for (std::size_t k = 0; k < values.slow.size(); ++k) define(real.slow()[k], values.slow[k]);
    define_roots_and_functions(lowering, program, surroundings, named);
}

namespace {

// Whether a harmonic turns (1, or -1 where its conjugate counts as turning forward), by the first mode or
// angle that does; 0: it is real. Powers of a real mode turn nothing.
int sense(const RealForm& form, const FlowSum::Harmonic& harmonic) {
    for (std::size_t k = 0; k < harmonic.turns.size(); ++k) {
        if (k < form.modes().size() && form.modes()[k].is_real()) continue;
        if (harmonic.turns[k] != 0) return harmonic.turns[k] > 0 ? 1 : -1;
    }
    return 0;
}

} // namespace

// Of a real p the conjugate of each harmonic is there as well: one of them is taken twice.
FlowSum flow_sum(const RealForm& form, const Polynomial& p, int power, bool real) {
    constexpr std::size_t longest = 20000; // of a real form
    const auto fractions = [&](const Polynomial& part, const Rational& factor) {
        return reduced_fractions(*form.ring(), factor * over_eps(form, part, power));
    };
    FlowSum sum;
    sum.real = real;
    if (form.length(p) <= longest) {
        const RealForm::Value parts = form(p);
        sum.re = fractions(parts.re, 1);
        if (!real) sum.im = fractions(parts.im, 1);
        return sum;
    }
    for (const RealForm::Harmonic& h : form.harmonics(p)) {
        FlowSum::Harmonic harmonic;
        for (const auto& [a, b] : h.modes) {
            harmonic.turns.push_back(a - b);
            harmonic.moduli.push_back(std::min(a, b));
        }
        harmonic.turns.insert(harmonic.turns.end(), h.angles.begin(), h.angles.end());
        const int turning = sense(form, harmonic);
        if (real && turning < 0) continue;
        const Rational factor = real && turning > 0 ? 2 : 1;
        harmonic.re = fractions(h.coefficient.re, factor);
        harmonic.im = fractions(h.coefficient.im, factor);
        sum.harmonics.push_back(std::move(harmonic));
    }
    return sum;
}

FlowMoment::Unit FlowMoment::value(const FlowSum& sum) {
    if (!sum.harmonics.empty()) return sum_of_harmonics(sum);
    const Graph::Node u = lowering.fractions(sum.re);
    return {u, sum.real ? -1 : lowering.fractions(sum.im)};
}

FlowMoment::Unit FlowMoment::times(const Unit& a, const Unit& b) {
    return {graph_.add({graph_.multiply({a.u, b.u}), graph_.negate(graph_.multiply({a.v, b.v}))}),
            graph_.add({graph_.multiply({a.u, b.v}), graph_.multiply({a.v, b.u})})};
}

// (u + i v)^turns, of a negative power the conjugate.
FlowMoment::Unit FlowMoment::turned(std::size_t unit, int turns) {
    if (turns == 1) return units_[unit];
    if (const auto known = powers_.find({unit, turns}); known != powers_.end()) return known->second;
    Unit result;
    if (turns == 0)
        result = {graph_.rational(1), graph_.rational(0)};
    else if (turns < 0)
        result = {turned(unit, -turns).u, graph_.negate(turned(unit, -turns).v)};
    else
        result = times(turned(unit, turns / 2), turned(unit, turns - turns / 2));
    return powers_.emplace(std::pair{unit, turns}, result).first->second;
}

FlowMoment::Unit FlowMoment::sum_of_harmonics(const FlowSum& sum) {
    std::vector<Graph::Node> u, v;
    for (const FlowSum::Harmonic& h : sum.harmonics) {
        Unit product{lowering.fractions(h.re), lowering.fractions(h.im)};
        for (std::size_t k = 0; k < h.turns.size(); ++k) product = times(product, turned(k, h.turns[k]));
        std::vector<Graph::Node> moduli;
        for (std::size_t k = 0; k < h.moduli.size(); ++k)
            if (h.moduli[k] > 0)
                moduli.push_back(graph_.power(
                    graph_.add({graph_.power(units_[k].u, 2), graph_.power(units_[k].v, 2)}), h.moduli[k]));
        const Graph::Node modulus = graph_.multiply(moduli);
        u.push_back(graph_.multiply({product.u, modulus}));
        if (!sum.real) v.push_back(graph_.multiply({product.v, modulus}));
    }
    return {graph_.add(std::move(u)), sum.real ? -1 : graph_.add(std::move(v))};
}

Graph::Node measured_from(Graph& graph, Graph::Node state, const Lowering& at, const RealForm& real,
                          const Polynomial& shift) {
    if (shift.empty()) return state;
    Lowering lowering = at;
    return graph.whole(graph.add({state, graph.negate(lowering.polynomial(real(shift).re))}));
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
