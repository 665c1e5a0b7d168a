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

void Amplitudes::add(const std::vector<int>& turns, int power, Graph::Node cosine, Graph::Node sine) {
    parts_[turns][0].emplace_back(power, cosine);
    if (sine >= 0) parts_[turns][1].emplace_back(power, sine);
}

void Amplitudes::append_to(Program& program, std::size_t output) const {
    Graph& graph = program.graph;
    for (const auto& [turns, waves] : parts_)
        for (const bool sine : {false, true}) {
            std::vector<Graph::Node> sum;
            for (const auto& [power, node] : waves[sine ? 1 : 0])
                sum.push_back(graph.multiply({graph.power(program.small, power), node}));
            const Graph::Node amplitude = graph.add(std::move(sum));
            if (graph.is_rational(amplitude, 0)) continue;
            const bool mean = std::all_of(turns.begin(), turns.end(), [](int n) { return n == 0; });
            program.rows.push_back({output,
                                    mean   ? ProgramWave::one
                                    : sine ? ProgramWave::sine
                                           : ProgramWave::cosine,
                                    turns, amplitude});
        }
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

Graph::Node Harmonics::value(const Polynomial& p, bool oscillating, Amplitudes* rows, int power) {
    const std::vector<int> phases(phase_ ? 1 : 0, 0);
    std::vector<Graph::Node> sum{lowering_->polynomial(part(coefficient(p, 0), false))};
    if (rows != nullptr) rows->add(phases, power, sum.front());
    const int last = oscillating ? highest(p) : 0;
    for (int k = 1; k <= last; ++k) {
        const Polynomial a = coefficient(p, k);
        if (a.empty()) continue;
        const auto [cosine, sine] = multiple(k);
        const Graph::Node of_cosine = lowering_->polynomial(Rational(2) * part(a, false));
        const Graph::Node of_sine = lowering_->polynomial(Rational(-2) * part(a, true));
        sum.push_back(graph_->multiply({of_cosine, cosine}));
        sum.push_back(graph_->multiply({of_sine, sine}));
        if (rows != nullptr) rows->add({k}, power, of_cosine, of_sine);
    }
    return graph_->add(std::move(sum));
}

} // namespace resonform
