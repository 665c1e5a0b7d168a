// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/amplitude_phase.hpp"

#include "algebra/number/error.hpp"
#include "solve/quadrature.hpp"
#include "solve/span.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

std::vector<RateTerm> real_parts(const Ring& ring, const std::vector<RateTerm>& terms) {
    std::vector<RateTerm> result;
    for (const RateTerm& t : terms)
        if (Polynomial p = Rational(1) / 2 * (t.coefficient + ring.conjugate(t.coefficient)); !p.empty())
            result.push_back({t.k, t.c, std::move(p)});
    return result;
}

std::vector<RateTerm> imaginary_parts(const Ring& ring, const std::vector<RateTerm>& terms) {
    const Polynomial minus_half_i = Rational(-1) / 2 * ring.imaginary();
    std::vector<RateTerm> result;
    for (const RateTerm& t : terms)
        if (Polynomial p = ring.multiply(minus_half_i, t.coefficient - ring.conjugate(t.coefficient));
            !p.empty())
            result.push_back({t.k, t.c, std::move(p)});
    return result;
}

bool is_leading(const RateTerm& t) { return t.k == 0 && t.c <= 1; }

Polynomial leading_rate(const NormalForm& normal_form) {
    Polynomial rate;
    for (const RateTerm& t : real_parts(*normal_form.field->ring, oscillator_rate(normal_form))) {
        if (t.k == 0 && t.c == 0)
            refuse(Reason::too_fast,
                   {"an oscillator is undamped at weight 0",
                    normal_form.field->modes.front().name + " has a growth rate at weight 1",
                    "multiply the damping by eps",
                    {}});
        if (t.k == 0 && t.c == 1) rate = t.coefficient;
    }
    return rate;
}

// base'/base for everything whose powers the solution's ring can hold.
std::vector<std::pair<GeneratorId, Polynomial>> logarithmic_derivatives(const Ring& ring, GeneratorId x) {
    std::vector<std::pair<GeneratorId, Polynomial>> result;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        const bool root = g.kind == GeneratorKind::root;
        if (!g.positive || (!root && id != x)) continue;
        const Polynomial slope = ring.derivative(ring.gen(id), x);
        if (!slope.empty()) result.emplace_back(id, ring.multiply(slope, ring.power(ring.gen(id), -1)));
    }
    return result;
}

Polynomial strip_eps(const Draft& draft, const Polynomial& p, int power) {
    return *quotient_in_ring(draft.ring(), p, draft.ring().gen(draft.solution.eps, power));
}

// Without C: E is a function of the slow variable.
Polynomial envelope(Draft& draft, const EnvelopePlan& plan, const std::string& variable) {
    Polynomial result = draft.ring().one();
    if (!plan.rest.empty()) {
        const Polynomial exponent = draft.integrate(draft.lift(plan.rest), fmt::format("Q_{}0", variable));
        result = draft.exponential(exponent, fmt::format("E_{}", variable));
    }
    for (const EnvelopePlan::Power& power : plan.powers)
        result = draft.ring().multiply(result, draft.power_of(power.base, power.exponent));
    return result;
}

} // namespace

std::vector<Refinement> EnvelopePlan::refinements() const {
    std::vector<Refinement> result;
    for (const Power& power : powers)
        result.push_back({power.base, cln::cl_I_to_int(cln::denominator(power.exponent))});
    return result;
}

EnvelopePlan plan_envelope(const NormalForm& normal_form) {
    const GradedField& field = *normal_form.field;
    if (field.modes.empty()) return {};
    EnvelopePlan plan;
    plan.rest = leading_rate(normal_form);
    if (field.slow.empty()) return plan;
    const Ring& ring = *field.ring;
    const SlowVariable& slow = field.slow.front();
    const Polynomial speed = *quotient_in_ring(ring, slow.rate, ring.gen(field.eps));

    const auto bases = logarithmic_derivatives(ring, slow.generator);
    Span span;
    for (const auto& base : bases) span.add(ring.multiply(base.second, speed));
    const auto parts = span.decompose(plan.rest);
    if (parts.remainder.size() > plan.rest.size()) return plan; // no powers are in it
    for (std::size_t k = 0; k < bases.size(); ++k)
        if (parts.coordinates[k] != 0) plan.powers.push_back({bases[k].first, parts.coordinates[k]});
    plan.rest = parts.remainder;
    return plan;
}

bool amplitude_is_constant(const NormalForm& normal_form) {
    return normal_form.field->modes.empty() ||
           real_parts(*normal_form.field->ring, oscillator_rate(normal_form)).empty();
}

void solve_amplitude_and_phase(Draft& draft, const EnvelopePlan& plan) {
    if (draft.solution.modes.empty()) return;
    const int through = draft.solution.truncation;
    const Ring& old = *draft.normal_form().field->ring;
    const std::vector<RateTerm> rate = oscillator_rate(draft.normal_form());
    const std::string variable =
        draft.solution.system().variables[draft.solution.modes.front().variable].name;

    const Polynomial e = envelope(draft, plan, variable);
    draft.solution.modes.front().envelope = e;
    draft.solution.modes.front().factor.set(0, draft.ring().one());

    // F = 1 + eps B_1 + ...:  dF/dT = F sum Re a_kc Delta^(2k) eps^(c-1) without the leading rate
    std::vector<RateTerm> growth;
    for (RateTerm& t : real_parts(old, rate))
        if (!is_leading(t)) growth.push_back(std::move(t));
    for (int j = 1; j <= through - 2; ++j) {
        const Substitution known(draft, through);
        const Polynomial right = strip_eps(draft, known.rate_part_times_factor(growth, j + 1), j + 1);
        const Polynomial b = draft.integrate(right, fmt::format("Q_{}{}", variable, j));
        draft.solution.modes.front().factor.set(
            j, draft.ring().multiply(b, draft.ring().gen(draft.solution.eps, j)));
    }

    const std::vector<RateTerm> frequency = imaginary_parts(old, rate);
    const Substitution amplitude(draft, through);
    for (int n = 0; n < through; ++n)
        draft.solution.modes.front().phase_rate.set(n, amplitude.rate_part(frequency, n));
}

} // namespace resonform
