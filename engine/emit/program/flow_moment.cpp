// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_moment.hpp"

#include "emit/display/divisor_fractions.hpp"
#include "emit/program/prune.hpp"

#include <algorithm>
#include <cstdlib>
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
    for (std::size_t k = 0; k < values.moduli.size(); ++k)
        if (values.moduli[k] >= 0) define(real.moduli()[k], values.moduli[k]);
    define_units(real.angles(), values.angles);
    for (std::size_t k = 0; k < values.slow.size(); ++k) define(real.slow()[k], values.slow[k]);
    define_roots_and_functions(lowering, program, surroundings, named);
}

namespace {

// 1, or -1 where the conjugate counts as turning forward, by the first mode or angle that turns; 0: none
// does.
int sense(const std::vector<int>& turns) {
    const auto first = std::find_if(turns.begin(), turns.end(), [](int turn) { return turn != 0; });
    return first == turns.end() ? 0 : *first > 0 ? 1 : -1;
}

// About how many products and sums it takes; a divisor is a sum of its own.
std::size_t length(const std::vector<Fraction>& list) {
    std::size_t terms = 0; // 0: too many to be multiplied out
    for (const Fraction& f : list) {
        terms += f.numerator.size();
        for (const Polynomial& divisor : f.divisors) terms += 2 + divisor.size();
    }
    return terms;
}

std::size_t length(const FlowSum& sum) {
    std::size_t terms = length(sum.re) + length(sum.im);
    for (const FlowSum::Harmonic& h : sum.harmonics)
        terms += length(h.re) + length(h.im) + (sense(h.turns) == 0 ? 0 : 4);
    return terms;
}

} // namespace

// Of a real p the conjugate of each harmonic is there as well: one of them is taken twice.
FlowSum flow_sum(const RealForm& form, const Polynomial& p, int power, bool real) {
    constexpr std::size_t longest = 20000;          // of a real form
    constexpr std::size_t short_sum = 40, much = 3; // longer sums than this, that many times
    const auto fractions = [&](const Polynomial& part, const Rational& factor) {
        return reduced_fractions(*form.ring(), factor * over_eps(form, part, power));
    };
    FlowSum by_turns, multiplied_out;
    by_turns.real = multiplied_out.real = real;
    std::size_t terms = 0; // 0: too many to be multiplied out
    if (form.length(p) <= longest) {
        const RealForm::Value parts = form(p);
        multiplied_out.re = fractions(parts.re, 1);
        if (!real) multiplied_out.im = fractions(parts.im, 1);
        terms = length(multiplied_out);
        if (terms <= short_sum) return multiplied_out;
    }
    for (const RealForm::Harmonic& h : form.harmonics(p)) {
        const int turning = sense(h.turns);
        if (real && turning < 0) continue;
        const Rational factor = real && turning > 0 ? 2 : 1;
        by_turns.harmonics.push_back(
            {h.turns, fractions(h.coefficient.re, factor), fractions(h.coefficient.im, factor)});
    }
    return terms == 0 || terms > much * length(by_turns) ? by_turns : multiplied_out;
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

// (u + i v)^turns, turns > 0
FlowMoment::Unit FlowMoment::power(std::size_t unit, int turns) {
    if (turns == 1) return units_[unit];
    if (const auto known = powers_.find({unit, turns}); known != powers_.end()) return known->second;
    const Unit result = times(power(unit, turns / 2), power(unit, turns - turns / 2));
    return powers_.emplace(std::pair{unit, turns}, result).first->second;
}

// Of the units to their turns, those of negative turns conjugate.
FlowMoment::Unit FlowMoment::product(std::vector<int> turns) {
    if (sense(turns) == 0) return {graph_.rational(1), graph_.rational(0)};
    if (sense(turns) < 0) {
        for (int& turn : turns) turn = -turn;
        const Unit other = product(std::move(turns));
        return {other.u, graph_.negate(other.v)};
    }
    if (const auto known = products_.find(turns); known != products_.end()) return known->second;
    std::vector<int> before = turns;
    std::size_t last = turns.size() - 1;
    while (turns[last] == 0) --last;
    before[last] = 0;
    Unit factor = power(last, std::abs(turns[last]));
    if (turns[last] < 0) factor.v = graph_.negate(factor.v);
    return products_[turns] = sense(before) == 0 ? factor : times(product(std::move(before)), factor);
}

// Only sums that are not multiplied out use them.
void FlowMoment::define_moduli() {
    const std::vector<GeneratorId>& ids = real_.moduli();
    for (std::size_t k = 0; k < ids.size(); ++k) {
        if (ids[k] < 0 || lowering.node(ids[k]) >= 0) continue;
        const RealForm::Pair& pair = real_.modes()[k];
        const Graph::Node modulus = graph_.add({graph_.power(units_[k].u, 2), graph_.power(units_[k].v, 2)});
        lowering.define(ids[k], modulus, lowering.varying(pair.u) || lowering.varying(pair.v));
    }
}

FlowMoment::Unit FlowMoment::sum_of_harmonics(const FlowSum& sum) {
    define_moduli();
    std::vector<Graph::Node> u, v;
    for (const FlowSum::Harmonic& h : sum.harmonics) {
        const Unit coefficient{lowering.fractions(h.re), lowering.fractions(h.im)};
        const Unit all = times(coefficient, product(h.turns));
        u.push_back(all.u);
        if (!sum.real) v.push_back(all.v);
    }
    return {graph_.add(std::move(u)), sum.real ? -1 : graph_.add(std::move(v))};
}

Graph::Node measured_from(Graph& graph, Graph::Node state, const Lowering& at, const RealForm& real,
                          const Polynomial& shift) {
    if (shift.empty()) return state;
    Lowering lowering = at;
    return graph.difference(graph.add({state, graph.negate(lowering.polynomial(real(shift).re))}));
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
