// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/substitution.hpp"

#include <algorithm>
#include <stdexcept>

namespace resonform {

namespace {

// Terms by the powers of w, wbar and eps; every one must be w^(k + extra) wbar^k.
std::vector<RateTerm> rate_terms(const GradedField& field, const Series& rate, int through, int extra) {
    const Ring& ring = *field.ring;
    std::vector<GeneratorId> outer;
    for (const Mode& mode : field.modes) outer.insert(outer.end(), {mode.z, mode.zbar});
    outer.push_back(field.eps);
    std::vector<RateTerm> terms;
    for (int n = 0; n <= through; ++n)
        for (const auto& [monomial, coefficient] : ring.collect(rate.part(n), outer)) {
            int a = extra, b = 0;
            if (!field.modes.empty()) {
                a = ring.exponent(monomial, field.modes.front().z);
                b = ring.exponent(monomial, field.modes.front().zbar);
            }
            if (a != b + extra) throw std::logic_error("the normal form holds a term that is not resonant");
            terms.push_back({b, ring.exponent(monomial, field.eps), coefficient});
        }
    return terms;
}

} // namespace

std::vector<RateTerm> oscillator_rate(const NormalForm& normal_form) {
    return rate_terms(*normal_form.field, normal_form.mode.front(), normal_form.through, 1);
}

std::vector<RateTerm> drift_rate(const NormalForm& normal_form, std::size_t drift) {
    return rate_terms(*normal_form.field, normal_form.drift[drift], normal_form.through, 0);
}

Substitution::Substitution(const Draft& draft, int through) : draft_(draft), through_(through) {
    const Ring& ring = draft.ring();
    factor_.set(0, ring.one());
    powers_.push_back(factor_);
    if (draft.solution.modes.empty()) return;
    const ModeSolution& mode = draft.solution.modes.front();
    factor_ = mode.factor;
    const Polynomial leading =
        ring.multiply(ring.gen(draft.solution.eps), ring.multiply(ring.gen(mode.amplitude), mode.envelope));
    Series amplitude;
    for (int n = 0; n < through; ++n) amplitude.set(n + 1, ring.multiply(leading, factor_.part(n)));
    for (int m = 1; m <= through; ++m) powers_.push_back(multiply(ring, powers_.back(), amplitude, through));
}

const Series& Substitution::amplitude_power(int m) const { return powers_.at(static_cast<std::size_t>(m)); }

Polynomial Substitution::rate_part(const std::vector<RateTerm>& terms, int weight) const {
    const Ring& ring = draft_.ring();
    std::vector<Polynomial> parts;
    for (const RateTerm& term : terms) {
        if (2 * term.k + term.c > weight) continue;
        const Polynomial coefficient =
            ring.multiply(draft_.lift(term.coefficient), ring.gen(draft_.solution.eps, term.c));
        parts.push_back(ring.multiply(coefficient, amplitude_power(2 * term.k).part(weight - term.c)));
    }
    return sum(parts);
}

Polynomial Substitution::rate_part_times_factor(const std::vector<RateTerm>& terms, int weight) const {
    std::vector<Polynomial> parts;
    for (int n = 0; n <= weight; ++n)
        parts.push_back(draft_.ring().multiply(rate_part(terms, n), factor_.part(weight - n)));
    return sum(parts);
}

Series Substitution::operator()(const Polynomial& p) const {
    const GradedField& field = *draft_.normal_form().field;
    const Ring& old = *field.ring;
    const Ring& ring = draft_.ring();
    std::vector<GeneratorId> outer;
    for (const Mode& mode : field.modes) outer.insert(outer.end(), {mode.z, mode.zbar});
    std::vector<std::vector<Polynomial>> parts(static_cast<std::size_t>(through_) + 1);
    for (const auto& [monomial, coefficient] : old.collect(p, outer)) {
        int a = 0, b = 0;
        Polynomial lead = draft_.lift(coefficient);
        if (!field.modes.empty()) {
            a = old.exponent(monomial, field.modes.front().z);
            b = old.exponent(monomial, field.modes.front().zbar);
            lead = ring.multiply(lead, ring.gen(draft_.solution.modes.front().phase, a - b));
        }
        if (a + b > through_) continue;
        const Series& amplitude = amplitude_power(a + b);
        const std::vector<Polynomial> by_eps = ring.by_weight(lead, through_);
        for (std::size_t c = 0; c < by_eps.size(); ++c)
            for (std::size_t n = c; n < parts.size(); ++n)
                parts[n].push_back(ring.multiply(by_eps[c], amplitude.part(static_cast<int>(n - c))));
    }
    Series result;
    for (std::size_t n = 0; n < parts.size(); ++n) result.set(static_cast<int>(n), sum(parts[n]));
    return result;
}

} // namespace resonform
