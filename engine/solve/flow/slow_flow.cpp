// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/slow_flow.hpp"

#include "model/signs/sign_prover.hpp"
#include "solve/flow/passage.hpp"

#include <algorithm>

namespace resonform {

namespace {

bool depends_on_phases(const GradedField& field, const SlowFlow& flow) {
    const auto turns = [&](const Series& rate, std::optional<std::size_t> as) {
        const Polynomial all = rate.total(rate.through());
        return std::any_of(all.terms().begin(), all.terms().end(),
                           [&](const Term& t) { return !turns_as(field, t.monomial, as); });
    };
    for (std::size_t k = 0; k < flow.modes.size(); ++k)
        if (!field.modes[k].is_damped() && turns(flow.modes[k].rate, k)) return true;
    return std::any_of(flow.angles.begin(), flow.angles.end(),
                       [&](const FlowMode& angle) { return turns(angle.rate, std::nullopt); }) ||
           std::any_of(flow.slow.begin(), flow.slow.end(),
                       [&](const Series& rate) { return turns(rate, std::nullopt); });
}

// The rate of |z|^2, zbar a' + z abar'; empty if the rate only turns the phase.
Series of_modulus(const GradedField& field, const Mode& mode, const Series& rate) {
    Series result;
    for (int n = 0; n <= rate.through(); ++n) {
        const Polynomial half = field.ring->multiply(field.ring->gen(mode.zbar), rate.part(n));
        result.set(n, half + field.ring->conjugate(half));
    }
    return result;
}

} // namespace

bool SlowFlow::grows() const {
    return std::any_of(modes.begin(), modes.end(), [](const FlowMode& mode) { return mode.grows; });
}

bool SlowFlow::may_grow() const {
    return grows() ||
           std::any_of(modes.begin(), modes.end(), [](const FlowMode& mode) { return mode.either; });
}

bool SlowFlow::follows_growth() const {
    return std::any_of(modes.begin(), modes.end(),
                       [](const FlowMode& mode) { return (mode.grows || mode.either) && !mode.is_left_out; });
}

bool SlowFlow::is_projected() const {
    return std::any_of(modes.begin(), modes.end(), [](const FlowMode& mode) {
        return mode.grows && mode.is_left_out && !mode.is_at_zero;
    });
}

bool SlowFlow::at_rest() const {
    const auto is_empty = [](const Series& rate) { return !lowest_weight(rate); };
    const auto rests = [&](const FlowMode& mode) { return is_empty(mode.rate); };
    return std::all_of(modes.begin(), modes.end(), rests) &&
           std::all_of(angles.begin(), angles.end(), rests) &&
           std::all_of(slow.begin(), slow.end(), is_empty);
}

bool turns_as(const GradedField& field, const Monomial& monomial, std::optional<std::size_t> k) {
    const Ring& ring = *field.ring;
    for (std::size_t j = 0; j < field.modes.size(); ++j) {
        const Mode& mode = field.modes[j];
        if (mode.is_real()) continue;
        if (ring.exponent(monomial, mode.z) - ring.exponent(monomial, mode.zbar) != (j == k ? 1 : 0))
            return false;
    }
    return std::all_of(field.angles.begin(), field.angles.end(),
                       [&](const AngleVariable& a) { return ring.exponent(monomial, a.phase) == 0; });
}

Polynomial net_rate(const GradedField& field, const SlowFlow& flow, const Monomial& monomial) {
    const Ring& ring = *field.ring;
    Polynomial rate;
    const auto add = [&](int turns, const FlowMode& mode) {
        if (turns != 0 && mode.phase) rate = rate + Rational(turns) * flow.phases[*mode.phase];
    };
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        add(ring.exponent(monomial, field.modes[k].z) - ring.exponent(monomial, field.modes[k].zbar),
            flow.modes[k]);
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        add(ring.exponent(monomial, field.angles[k].phase), flow.angles[k]);
    return rate;
}

Polynomial net_decay(const GradedField& field, const SlowFlow& flow, const Monomial& monomial) {
    Polynomial rate;
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const std::optional<std::size_t>& decay = flow.modes[k].decay;
        if (const int times = degree_in(field, monomial, k); times != 0 && decay)
            rate = rate + Rational(times) * flow.decays[*decay];
    }
    return rate;
}

bool grows(const GradedField& field, std::size_t k) {
    return provably_positive(field.basis.modes[k].eigenvalue.re, field.system());
}

bool passes_zero(const SlowFlow& flow, const GradedField& field, const Polynomial& p) {
    for (std::size_t k = 0; k < flow.modes.size(); ++k)
        if (flow.modes[k].passes && is_multiple_of_growth(field, k, p)) return true;
    return false;
}

int degree_in(const GradedField& field, const Monomial& monomial, std::size_t k) {
    const Mode& mode = field.modes[k];
    const int degree = field.ring->exponent(monomial, mode.z);
    return mode.is_real() ? degree : degree + field.ring->exponent(monomial, mode.zbar);
}

bool has_damped_mode(const GradedField& field, const Monomial& monomial) {
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (field.modes[k].is_damped() && degree_in(field, monomial, k) > 0) return true;
    return false;
}

Polynomial mean_part(const GradedField& field, const SlowFlow& flow, const Polynomial& p) {
    std::vector<Term> terms;
    for (const Term& t : p.terms())
        if (field.ring->vanishes(net_rate(field, flow, t.monomial)) &&
            field.ring->vanishes(net_decay(field, flow, t.monomial)))
            terms.push_back(t);
    return Polynomial::from_terms(std::move(terms));
}

std::optional<int> first_oscillation(const GradedField& field, const SlowFlow& flow,
                                     const std::string& output) {
    for (const FlowOutput& o : flow.outputs)
        for (int n = 0; o.name == output && n <= o.value.through(); ++n)
            if (!(o.value.part(n) - mean_part(field, flow, o.value.part(n))).empty()) return n;
    return std::nullopt;
}

std::optional<int> lowest_weight(const Series& series) {
    for (int n = 0; n <= series.through(); ++n)
        if (!series.part(n).empty()) return n;
    return std::nullopt;
}

std::optional<int> flow_power(const GradedField& field, const SlowFlow& flow) {
    std::optional<int> power;
    const auto lower = [&](const Series& rate, int base) {
        if (const auto weight = lowest_weight(rate))
            power = std::min(power.value_or(*weight - base), *weight - base);
    };
    const bool phases_act = depends_on_phases(field, flow);
    for (std::size_t k = 0; k < flow.modes.size(); ++k) {
        if (field.modes[k].is_damped()) continue;
        const Series& rate = flow.modes[k].rate;
        lower(phases_act ? rate : of_modulus(field, field.modes[k], rate),
              field.ring->generator(field.modes[k].z).weight);
    }
    for (const FlowMode& angle : flow.angles)
        if (phases_act) lower(angle.rate, 0);
    for (const Series& slow : flow.slow) lower(slow, 0);
    return power;
}

} // namespace resonform
