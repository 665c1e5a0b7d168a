// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/slow_rate.hpp"

#include "algebra/ring/fractions.hpp"

#include <algorithm>
#include <cln/rational.h>
#include <cstddef>
#include <map>
#include <utility>

namespace resonform {

namespace {

bool eps_stands_only_in(const System& system, std::size_t variable) {
    for (std::size_t i = 0; i < system.equations.size(); ++i)
        if (i != variable && system.equations[i].residual.has(system.eps)) return false;
    return true;
}

} // namespace

std::optional<SlowRate> only_rate_with_eps(const GradedField& field) {
    const Ring& ring = *field.ring;
    for (const SlowVariable& slow : field.slow) {
        if (slow.rate.size() != 1 || !eps_stands_only_in(field.system(), slow.variable)) continue;
        const Term& term = slow.rate.terms().front();
        SlowRate rate;
        rate.variable = slow.name;
        rate.coefficient = term.coefficient;
        rate.eps_power = ring.exponent(term.monomial, field.eps);
        for (GeneratorId id = 0; id < ring.size(); ++id)
            if (const int exponent = ring.exponent(term.monomial, id); id != field.eps && exponent != 0)
                rate.powers.emplace_back(ring.generator(id).name, exponent);
        return rate;
    }
    return std::nullopt;
}

SeriesWriter::SeriesWriter(RingPtr ring, GeneratorId eps, std::vector<GeneratorId> outer,
                           std::optional<SlowRate> rate, const std::vector<Polynomial>& all)
    : ring_(std::move(ring)), eps_(eps), outer_(std::move(outer)), rate_(std::move(rate)) {
    if (!rate_) return;
    const auto fits = [this](const Monomial& m) { return divided(m).has_value(); };
    if (!std::all_of(all.begin(), all.end(), [&](const Polynomial& p) {
            const std::vector<Monomial>& monomials = p.fractions().monomials;
            return std::all_of(monomials.begin(), monomials.end(), fits);
        }))
        rate_.reset();
}

std::optional<Monomial> SeriesWriter::divided(const Monomial& m) const {
    if (ring_->exponent(m, eps_) % rate_->eps_power != 0) return std::nullopt;
    std::vector<int> exponents = ring_->exponents(m);
    for (const auto& [name, exponent] : rate_->powers) {
        const std::optional<GeneratorId> id = ring_->find(name);
        if (!id) return std::nullopt;
        int& left = exponents[static_cast<std::size_t>(*id)];
        left -= exponent * times(m);
        if (left < 0 && !ring_->generator(*id).invertible) return std::nullopt;
    }
    return ring_->monomial(exponents);
}

Polynomial SeriesWriter::divided(const Polynomial& p) const {
    std::map<int, Fractions> by_times;
    const Fractions& f = p.fractions();
    for (std::size_t k = 0; k < f.size(); ++k)
        by_times[times(f.monomials[k])].append(divided(f.monomials[k]).value(), f, k);
    std::vector<Polynomial> parts;
    for (auto& [times, part] : by_times)
        parts.push_back(1 / cln::expt(rate_->coefficient, times) *
                        Polynomial::from_fractions(std::move(part)));
    return sum(parts);
}

DisplaySum SeriesWriter::operator()(const Polynomial& p) const { return (*this)(p, {}); }

DisplaySum SeriesWriter::operator()(const Polynomial& p, Substitutes substitutes) const {
    if (!rate_) return display_collected(*ring_, p, outer_, substitutes);
    substitutes.emplace(eps_, symbol_factor(rate_->variable + "'", Rational(1) / rate_->eps_power));
    return display_collected(*ring_, divided(p), outer_, substitutes);
}

} // namespace resonform
