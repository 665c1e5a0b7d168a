// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/transgression.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

bool is_former_constant(const Variable& variable) {
    return variable.role == Role::slow || variable.role == Role::drift;
}

// Drops the first nonzero part after `leading` and all later parts; parts beyond `known` count as nonzero.
Series cut_behind(const Series& series, int leading, int known) {
    int through = std::min(leading, known);
    while (through < known && series.part(through + 1).empty()) ++through;
    Series result;
    for (int n = 0; n <= through; ++n) result.set(n, series.part(n));
    return result;
}

// The first weight above `base` with a nonzero part, else `known`.
int first_motion(const Series& series, int base, int known) {
    int n = base + 1;
    while (n < known && series.part(n).empty()) ++n;
    return std::min(n, known);
}

// Part 0 of a drift contains its constant C_X; anything else in part 0 is motion of order 0.
Series leading_drift(const Solution& solution, const DriftSolution& drift) {
    const bool moves = drift.value.part(0) != solution.ring->gen(drift.constant);
    const int leading = moves ? 0 : first_motion(drift.value, 0, solution.order);
    return cut_behind(drift.value, leading, solution.order);
}

bool contains(const Ring& ring, const Polynomial& p, GeneratorId id) {
    return std::any_of(p.terms().begin(), p.terms().end(),
                       [&](const Term& term) { return ring.exponent(term.monomial, id) != 0; });
}

// Primitives that occur in the drifts or in other needed primitives.
std::vector<Primitive> needed_primitives(const Solution& law) {
    std::vector<Primitive> kept;
    for (auto p = law.primitives.rbegin(); p != law.primitives.rend(); ++p) {
        const auto held = [&](const Polynomial& value) { return contains(*law.ring, value, p->id); };
        const bool needed =
            std::any_of(law.drift.begin(), law.drift.end(),
                        [&](const DriftSolution& d) { return held(d.value.total(d.value.through())); }) ||
            std::any_of(kept.begin(), kept.end(), [&](const Primitive& k) { return held(k.argument); });
        if (needed) kept.insert(kept.begin(), *p);
    }
    return kept;
}

void keep_leading_drifts(Solution& law) {
    for (DriftSolution& drift : law.drift) drift.value = leading_drift(law, drift);
    law.primitives = needed_primitives(law);
    law.outputs.clear();
    law.state.clear();
}

// In the time 1/eps an amplitude changes by its own size through rates one weight above its own, an angle
// through rates of weight 1.
SlowFlow leading_flow(const Solution& solution) {
    const GradedField& field = *solution.normalization->normal_form.field;
    const int known = solution.truncation;
    SlowFlow flow = *solution.flow;
    const auto cut = [&](Series& rate, int leading) { rate = cut_behind(rate, leading, known); };
    for (std::size_t k = 0; k < flow.modes.size(); ++k)
        cut(flow.modes[k].rate, field.ring->generator(field.modes[k].z).weight + 1);
    for (FlowMode& angle : flow.angles) cut(angle.rate, 1);
    for (Series& slow : flow.slow) cut(slow, first_motion(slow, 0, known));
    for (Series& drift : flow.drift) cut(drift, first_motion(drift, 0, known));
    flow.outputs.clear();
    flow.state.clear();
    return flow;
}

} // namespace

bool has_former_constants(const System& system) {
    return std::any_of(system.variables.begin(), system.variables.end(), is_former_constant);
}

Transgression transgression(const Solution& solution) {
    Transgression result{solution, {}, drift_path(solution)};
    if (solution.flow)
        result.law.flow = std::make_shared<const SlowFlow>(leading_flow(solution));
    else
        keep_leading_drifts(result.law);
    const std::vector<Variable>& variables = solution.system().variables;
    for (std::size_t v = 0; v < variables.size(); ++v)
        if (is_former_constant(variables[v]))
            result.constants.push_back({v, first_oscillation(solution, variables[v].name)});
    return result;
}

} // namespace resonform
