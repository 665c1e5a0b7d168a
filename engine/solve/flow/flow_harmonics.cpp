// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/flow_harmonics.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace resonform {

namespace {

// Powers of e^{i theta}, and of e^chi.
struct Powers {
    std::vector<int> turns, decays;
    bool operator==(const Powers&) const = default;
};

Powers powers_of(const GradedField& field, const SlowFlow& flow, const Monomial& monomial) {
    const Ring& ring = *field.ring;
    Powers powers{std::vector<int>(flow.phases.size(), 0), std::vector<int>(flow.decays.size(), 0)};
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        if (const auto& phase = flow.modes[k].phase)
            powers.turns[*phase] +=
                ring.exponent(monomial, field.modes[k].z) - ring.exponent(monomial, field.modes[k].zbar);
        if (const auto& decay = flow.modes[k].decay) powers.decays[*decay] += degree_in(field, monomial, k);
    }
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        powers.turns[*flow.angles[k].phase] += ring.exponent(monomial, field.angles[k].phase);
    return powers;
}

int size_of(const Powers& powers) {
    int sum = 0;
    for (const int n : powers.turns) sum += std::abs(n);
    return std::accumulate(powers.decays.begin(), powers.decays.end(), sum);
}

// Which sums of frequencies vanish. Sums and differences of a thousand harmonics are few up to a factor.
class Frequencies {
public:
    Frequencies(const Ring& ring, const SlowFlow& flow) : ring_(ring), flow_(flow) {}

    // sum_p k_p theta_p' = 0
    [[nodiscard]] bool cancel(std::vector<int> k) {
        int factor = 0;
        for (const int n : k) factor = std::gcd(factor, n);
        if (factor == 0) return true;
        if (*std::find_if(k.begin(), k.end(), [](int n) { return n != 0; }) < 0) factor = -factor;
        for (int& n : k) n /= factor;
        const auto known = known_.find(k);
        return known != known_.end() ? known->second
                                     : known_.emplace(k, ring_.vanishes(rate_of(k))).first->second;
    }

private:
    [[nodiscard]] Polynomial rate_of(const std::vector<int>& k) const {
        Polynomial rate;
        for (std::size_t p = 0; p < k.size(); ++p)
            if (k[p] != 0) rate = rate + Rational(k[p]) * flow_.phases[p];
        return rate;
    }

    const Ring& ring_;
    const SlowFlow& flow_;
    std::map<std::vector<int>, bool> known_;
};

// a + sign b
std::vector<int> sum_of(std::vector<int> a, const std::vector<int>& b, int sign) {
    for (std::size_t p = 0; p < a.size(); ++p) a[p] += sign * b[p];
    return a;
}

struct Found {
    Powers powers;
    std::vector<Term> terms;
};

// The harmonic of the same rate among those found; false: neither it nor its conjugate is there.
bool join(Frequencies& frequencies, std::vector<Found>& found, const Powers& powers,
          const std::vector<Term>& terms) {
    for (Found& known : found) {
        if (known.powers.decays != powers.decays) continue;
        if (frequencies.cancel(sum_of(known.powers.turns, powers.turns, -1))) {
            known.terms.insert(known.terms.end(), terms.begin(), terms.end());
            return true;
        }
        if (frequencies.cancel(sum_of(known.powers.turns, powers.turns, 1))) return true;
    }
    return false;
}

bool is_zero(const std::vector<int>& powers) {
    return std::all_of(powers.begin(), powers.end(), [](int n) { return n == 0; });
}

} // namespace

bool FlowHarmonic::turns_not() const { return is_zero(turns); }

bool FlowHarmonic::lasts() const { return is_zero(decays); }

std::vector<FlowHarmonic> flow_harmonics(const GradedField& field, const SlowFlow& flow,
                                         const Polynomial& p) {
    Frequencies frequencies(*field.ring, flow);
    const auto order = [](const Powers& a, const Powers& b) { // k before -k
        return std::tuple(size_of(a), b.turns, b.decays) < std::tuple(size_of(b), a.turns, a.decays);
    };
    std::map<Powers, std::vector<Term>, decltype(order)> sorted(order);
    for (const Term& t : p.terms()) sorted[powers_of(field, flow, t.monomial)].push_back(t);
    std::vector<Found> found;
    const auto without_turns = [&](const Powers& powers) -> Found& {
        const Powers none{std::vector<int>(powers.turns.size(), 0), powers.decays};
        for (Found& known : found)
            if (known.powers == none) return known;
        return *found.insert(is_zero(none.decays) ? found.begin() : found.end(), {none, {}});
    };
    for (auto& [powers, terms] : sorted) {
        if (frequencies.cancel(powers.turns)) {
            Found& still = without_turns(powers);
            still.terms.insert(still.terms.end(), terms.begin(), terms.end());
        } else if (!join(frequencies, found, powers, terms)) {
            found.push_back({powers, std::move(terms)});
        }
    }
    std::vector<FlowHarmonic> result;
    for (Found& f : found)
        result.push_back({f.powers.turns, f.powers.decays, Polynomial::from_terms(std::move(f.terms))});
    return result;
}

} // namespace resonform
