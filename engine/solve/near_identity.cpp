// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/near_identity.hpp"

#include "model/exact/first_order_system.hpp"

#include <algorithm>

namespace resonform {

namespace {

std::vector<std::size_t> modes_in(const GradedField& field, const Polynomial& p, std::size_t itself) {
    std::vector<std::size_t> modes;
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const auto has = [&](const Term& t) {
            return field.ring->exponent(t.monomial, field.modes[k].z) != 0 ||
                   field.ring->exponent(t.monomial, field.modes[k].zbar) != 0;
        };
        if (k == itself || std::any_of(p.terms().begin(), p.terms().end(), has)) modes.push_back(k);
    }
    return modes;
}

// The coefficients of the products of angles in the terms without a mode.
std::vector<Polynomial> harmonics_without_modes(const GradedField& field, const Polynomial& p) {
    std::vector<GeneratorId> modes, angles;
    for (const Mode& mode : field.modes) modes.insert(modes.end(), {mode.z, mode.zbar});
    for (const AngleVariable& angle : field.angles) angles.push_back(angle.phase);
    std::vector<Polynomial> coefficients;
    for (const auto& [product, rest] : field.ring->collect(p, modes))
        if (product == Monomial())
            for (const auto& [turns, coefficient] : field.ring->collect(rest, angles))
                coefficients.push_back(coefficient);
    return coefficients;
}

} // namespace

bool feels_what_is_forced(const FirstOrderSystem& equations) {
    const auto is_fast = [&](const State& s) {
        return equations.system->variables[s.variable].role == Role::fast;
    };
    const auto bends = [&](const State& rated, const State& by) {
        const GiNaC::ex slope = rated.rate.diff(by.symbol);
        return std::any_of(equations.states.begin(), equations.states.end(),
                           [&](const State& s) { return is_fast(s) && slope.has(s.symbol); });
    };
    return std::any_of(equations.states.begin(), equations.states.end(), [&](const State& rated) {
        return std::any_of(equations.states.begin(), equations.states.end(),
                           [&](const State& by) { return is_fast(by) && bends(rated, by); });
    });
}

std::vector<MovedVariable> moved_variables(const Solution& solution) {
    using Of = MovedVariable::Kind;
    const GradedField& field = *solution.normalization->normal_form.field;
    const NearIdentityMap& map = solution.normalization->map;
    const bool bends = feels_what_is_forced(*field.first_order);
    std::vector<MovedVariable> moved;
    const auto add = [&](Of kind, const std::vector<Series>& list, const auto& variables) {
        for (std::size_t k = 0; k < variables.size(); ++k) {
            Polynomial added = list[k].total(solution.truncation);
            if (added.empty()) continue;
            moved.push_back({kind,
                             k,
                             field.system().variables[variables[k].variable].name,
                             kind == Of::mode ? field.ring->generator(field.modes[k].z).weight : 0,
                             &list[k],
                             std::move(added),
                             {},
                             {}});
            MovedVariable& v = moved.back();
            if (kind == Of::mode) v.modes = modes_in(field, v.added, k);
            if (kind == Of::drift || (kind == Of::mode && !bends)) continue;
            v.forced = harmonics_without_modes(field, v.added);
        }
    };
    add(Of::mode, map.mode, field.modes);
    add(Of::slow, map.slow, field.slow);
    add(Of::angle, map.angle, field.angles);
    add(Of::drift, map.drift, field.drift);
    return moved;
}

} // namespace resonform
