// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/harmonics.hpp"

#include <algorithm>

namespace resonform {

Polynomial harmonic(const Ring& ring, GeneratorId phase, const Polynomial& p, int k) {
    std::vector<Term> terms;
    for (const Term& t : p.terms())
        if (ring.exponent(t.monomial, phase) == k)
            terms.push_back({t.monomial - ring.monomial(phase, k), t.coefficient});
    return Polynomial::from_terms(std::move(terms));
}

void Harmonics::set_angle(GeneratorId phase, Graph::Node cosine, Graph::Node sine) {
    phase_ = phase;
    multiples_ = {{1, {cosine, sine}}};
}

int Harmonics::highest(const Polynomial& p) const {
    int k = 0;
    if (phase_)
        for (const Term& t : p.terms()) k = std::max(k, ring_->exponent(t.monomial, *phase_));
    return k;
}

Polynomial Harmonics::coefficient(const Polynomial& p, int k) const {
    if (phase_) return harmonic(*ring_, *phase_, p, k);
    return k == 0 ? p : Polynomial();
}

// Re p or Im p of a polynomial whose generators are real but for i.
Polynomial Harmonics::part(const Polynomial& p, bool imaginary) const {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        const int power = ring_->exponent(t.monomial, Ring::imaginary_unit);
        if ((power == 1) == imaginary)
            terms.push_back({t.monomial - ring_->monomial(Ring::imaginary_unit, power), t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

std::pair<Graph::Node, Graph::Node> Harmonics::multiple(int k) {
    if (const auto known = multiples_.find(k); known != multiples_.end()) return known->second;
    const auto [c, s] = multiple(k / 2);
    const auto [d, t] = multiple(k - k / 2);
    const Graph::Node cosine =
        graph_->add({graph_->multiply({c, d}), graph_->multiply({graph_->rational(-1), s, t})});
    const Graph::Node sine = graph_->add({graph_->multiply({s, d}), graph_->multiply({c, t})});
    return multiples_.emplace(k, std::pair{cosine, sine}).first->second;
}

Graph::Node Harmonics::value(const Polynomial& p, bool oscillating) {
    std::vector<Graph::Node> sum{lowering_->polynomial(part(coefficient(p, 0), false))};
    const int last = oscillating ? highest(p) : 0;
    for (int k = 1; k <= last; ++k) {
        const Polynomial a = coefficient(p, k);
        if (a.empty()) continue;
        const auto [cosine, sine] = multiple(k);
        sum.push_back(graph_->multiply({lowering_->polynomial(Rational(2) * part(a, false)), cosine}));
        sum.push_back(graph_->multiply({lowering_->polynomial(Rational(-2) * part(a, true)), sine}));
    }
    return graph_->add(std::move(sum));
}

} // namespace resonform
