// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/flow_harmonics.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace resonform {

namespace {

using Turns = std::vector<int>;

Turns turns_of(const GradedField& field, const SlowFlow& flow, const Monomial& monomial) {
    const Ring& ring = *field.ring;
    Turns turns(flow.phases.size(), 0);
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (const auto& phase = flow.modes[k].phase)
            turns[*phase] +=
                ring.exponent(monomial, field.modes[k].z) - ring.exponent(monomial, field.modes[k].zbar);
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        turns[*flow.angles[k].phase] += ring.exponent(monomial, field.angles[k].phase);
    return turns;
}

int size_of(const Turns& turns) {
    int sum = 0;
    for (const int n : turns) sum += std::abs(n);
    return sum;
}

Polynomial rate_of(const SlowFlow& flow, const Turns& turns) {
    Polynomial rate;
    for (std::size_t p = 0; p < turns.size(); ++p)
        if (turns[p] != 0) rate = rate + Rational(turns[p]) * flow.phases[p];
    return rate;
}

// A harmonic with the rate of its angle, which its conjugate has with the other sign.
struct Found {
    Turns turns;
    Polynomial rate;
    std::vector<Term> terms;
};

// The harmonic of the same rate among those found; false: neither it nor its conjugate is there.
bool join(const Ring& ring, std::vector<Found>& found, const Polynomial& rate,
          const std::vector<Term>& terms) {
    for (Found& known : found) {
        if (ring.vanishes(known.rate - rate)) {
            known.terms.insert(known.terms.end(), terms.begin(), terms.end());
            return true;
        }
        if (ring.vanishes(known.rate + rate)) return true;
    }
    return false;
}

} // namespace

std::vector<FlowHarmonic> flow_harmonics(const GradedField& field, const SlowFlow& flow,
                                         const Polynomial& p) {
    const Ring& ring = *field.ring;
    std::map<Turns, std::vector<Term>> by_turns;
    for (const Term& t : p.terms()) by_turns[turns_of(field, flow, t.monomial)].push_back(t);
    std::vector<std::pair<Turns, std::vector<Term>>> sorted(by_turns.begin(), by_turns.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return std::pair(size_of(a.first), b.first) < std::pair(size_of(b.first), a.first); // k before -k
    });
    std::vector<Found> found;
    for (auto& [turns, terms] : sorted) {
        Polynomial rate = rate_of(flow, turns);
        if (ring.vanishes(rate)) {
            const Turns none(turns.size(), 0);
            if (found.empty() || found.front().turns != none) found.insert(found.begin(), {none, {}, {}});
            found.front().terms.insert(found.front().terms.end(), terms.begin(), terms.end());
        } else if (!join(ring, found, rate, terms)) {
            found.push_back({turns, std::move(rate), std::move(terms)});
        }
    }
    std::vector<FlowHarmonic> result;
    for (Found& f : found) result.push_back({f.turns, Polynomial::from_terms(std::move(f.terms))});
    return result;
}

} // namespace resonform
