// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/homological.hpp"

namespace resonform {

HomologicalEquation::HomologicalEquation(const GradedField& field, int mode, std::string variable)
    : field_(field), variable_(std::move(variable)), divisors_(field, mode), by_mode_(field.modes.size()),
      by_conjugate_(field.modes.size()), by_slow_(field.slow.size()) {
    for (const Mode& m : field.modes) {
        outer_.push_back(m.z);
        outer_.push_back(m.zbar);
    }
    outer_.push_back(field.eps);
}

Polynomial HomologicalEquation::right_hand_side(int weight, const Polynomial& field_part,
                                                const Transport& transport) const {
    std::vector<std::pair<const Polynomial*, const Polynomial*>> pairs;
    const auto add = [&](const Series& derivative, const Series& rate) {
        for (int j = 0; j <= weight; ++j)
            if (!derivative.part(j).empty() && !rate.part(weight - j).empty())
                pairs.emplace_back(&derivative.part(j), &rate.part(weight - j));
    };
    for (std::size_t m = 0; m < by_mode_.size(); ++m) {
        add(by_mode_[m], transport.mode[m]);
        add(by_conjugate_[m], transport.conjugate[m]);
    }
    for (std::size_t s = 0; s < by_slow_.size(); ++s) add(by_slow_[s], transport.slow[s]);
    return pairs.empty() ? field_part : field_part - field_.ring->dot(pairs);
}

void HomologicalEquation::solve(int weight, const Polynomial& field_part, const Transport& transport) {
    const Ring& ring = *field_.ring;
    std::vector<Polynomial> kept, removed;
    for (const auto& [monomial, coefficient] :
         ring.collect(right_hand_side(weight, field_part, transport), outer_)) {
        if (ring.vanishes(coefficient)) continue;
        const Divisor& divisor = divisors_.of(monomial);
        records_.push_back({variable_, monomial, weight, divisor.value, divisor.verdict});
        const Polynomial outer(monomial, 1);
        if (divisor.verdict == DivisorVerdict::removed) {
            removed.push_back(ring.multiply(outer, ring.multiply(coefficient, divisor.inverse)));
        } else {
            kept.push_back(ring.multiply(outer, coefficient));
        }
    }
    rate_.set(weight, sum(kept));
    correction_.set(weight, sum(removed));
    remember_derivatives(weight);
}

// d_w lowers the weight by one, d_zeta keeps it.
void HomologicalEquation::remember_derivatives(int weight) {
    const Ring& ring = *field_.ring;
    const Polynomial& c = correction_.part(weight);
    if (c.empty()) return;
    for (std::size_t m = 0; m < by_mode_.size(); ++m) {
        by_mode_[m].set(weight - 1, ring.derivative(c, field_.modes[m].z));
        by_conjugate_[m].set(weight - 1, ring.derivative(c, field_.modes[m].zbar));
    }
    for (std::size_t s = 0; s < by_slow_.size(); ++s)
        by_slow_[s].set(weight, ring.derivative(c, field_.slow[s].generator));
}

} // namespace resonform
