// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/homological.hpp"

#include <algorithm>

namespace resonform {

std::vector<Carrier> carriers_of(const GradedField& field) {
    std::vector<Carrier> carriers;
    for (const Mode& m : field.modes) {
        const int weight = field.ring->generator(m.z).weight;
        carriers.push_back({m.z, false, weight});
        if (!m.is_real()) carriers.push_back({m.zbar, false, weight});
    }
    for (const SlowVariable& s : field.slow) carriers.push_back({s.generator, false, 0});
    for (const AngleVariable& a : field.angles) carriers.push_back({a.phase, true, 0});
    return carriers;
}

HomologicalEquation::HomologicalEquation(const GradedField& field, int mode, std::string variable,
                                         Place place)
    : field_(field), variable_(std::move(variable)), place_(std::move(place)), divisors_(field, mode),
      outer_(field.outer()), carriers_(carriers_of(field)), slopes_(carriers_.size()) {}

Polynomial HomologicalEquation::right_hand_side(int weight, const Polynomial& field_part,
                                                const Transport& transport) const {
    std::vector<std::pair<const Polynomial*, const Polynomial*>> pairs;
    for (std::size_t c = 0; c < slopes_.size(); ++c)
        for (int j = 0; j <= weight; ++j)
            if (!slopes_[c].part(j).empty() && !transport[c].part(weight - j).empty())
                pairs.emplace_back(&slopes_[c].part(j), &transport[c].part(weight - j));
    return pairs.empty() ? field_part : field_part - field_.ring->dot(pairs);
}

void HomologicalEquation::solve(int weight, const Polynomial& field_part, const Transport& transport) {
    const Ring& ring = *field_.ring;
    const Polynomial total = without_vanishing(right_hand_side(weight, field_part, transport));
    Monomial last;
    Shares shares;
    Share* share = nullptr;
    for (std::size_t k = 0; k < total.size(); ++k) {
        const Monomial& m = total.fractions().monomials[k];
        const Monomial outer = ring.restricted(m, outer_);
        if (share == nullptr || outer != last) share = &share_of(outer, weight, shares);
        last = outer;
        share->part.append(m, total.fractions(), k);
    }
    std::vector<Polynomial> kept, divided;
    divided.reserve(shares.size()); // pointers into it are kept
    std::vector<std::pair<const Polynomial*, const Polynomial*>> quotients;
    for (Share& s : shares) {
        Polynomial part = Polynomial::from_fractions(std::move(s.part));
        if (s.divisor->verdict == DivisorVerdict::removed) {
            divided.push_back(std::move(part));
            quotients.emplace_back(&divided.back(), &s.divisor->inverse);
        } else {
            kept.push_back(std::move(part));
        }
    }
    rate_.set(weight, sum(kept));
    correction_.set(weight, ring.dot(quotients));
    remember_derivatives(weight);
}

// The terms that are divided by the divisor of this monomial; a monomial that is new gets its record.
HomologicalEquation::Share& HomologicalEquation::share_of(const Monomial& outer, int weight, Shares& shares) {
    const Divisor& divisor = at_place(place_, [&]() -> const Divisor& { return divisors_.of(outer); });
    if (seen_.insert(outer).second)
        records_.push_back({variable_, outer, weight, divisor.value, divisor.verdict});
    const auto known =
        std::find_if(shares.begin(), shares.end(), [&](const Share& s) { return s.divisor == &divisor; });
    if (known != shares.end()) return *known;
    shares.push_back({&divisor, {}});
    return shares.back();
}

// Drops coefficients that vanish though they are not empty, which a canonical ring does not have.
Polynomial HomologicalEquation::without_vanishing(const Polynomial& p) const {
    const Ring& ring = *field_.ring;
    if (ring.is_canonical()) return p;
    std::vector<Polynomial> rest;
    for (const auto& [monomial, coefficient] : ring.collect(p, outer_))
        if (!ring.vanishes(coefficient)) rest.push_back(ring.multiply(Polynomial(monomial, 1), coefficient));
    return sum(rest);
}

// d_w lowers the weight by that of w; d_theta = i e^{i theta} d/d(e^{i theta}).
void HomologicalEquation::remember_derivatives(int weight) {
    const Ring& ring = *field_.ring;
    const Polynomial& c = correction_.part(weight);
    if (c.empty()) return;
    for (std::size_t k = 0; k < carriers_.size(); ++k) {
        const Carrier& carrier = carriers_[k];
        Polynomial slope = ring.derivative(c, carrier.id);
        if (carrier.angle)
            slope = ring.multiply(ring.multiply(ring.imaginary(), ring.gen(carrier.id)), slope);
        slopes_[k].set(weight - carrier.weight, std::move(slope));
    }
}

} // namespace resonform
