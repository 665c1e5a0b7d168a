// SPDX-License-Identifier: GPL-3.0-or-later
// Real values of polynomials in e^{i theta}:  sum_k a_k e^{ik theta}, a_{-k} = conj(a_k), is
//
//   a_0 + sum_{k>0} 2 Re a_k cos k theta - 2 Im a_k sin k theta
//
// with the multiple angles by the addition theorems from one cosine and sine. The factors of cos k theta and
// sin k theta are the rows of an output.
#pragma once

#include "emit/graph/graph.hpp"
#include "emit/graph/lower.hpp"
#include "emit/program/program.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// a_k of p = sum_k a_k e^{ik theta}, where `phase` is e^{i theta}.
Polynomial harmonic(const Ring& ring, GeneratorId phase, const Polynomial& p, int k);

// The amplitudes of an output, gathered from its parts by powers of eps.
class Amplitudes {
public:
    // eps^power (cosine cos k.theta + sine sin k.theta); k = 0: `cosine` alone. -1: there is no sine.
    void add(const std::vector<int>& turns, int power, Graph::Node cosine, Graph::Node sine = -1);
    // As rows, those of the mean first; an amplitude that is 0 has none.
    void append_to(Program& program, std::size_t output) const;

private:
    using Parts = std::vector<std::pair<int, Graph::Node>>;  // power of eps, its factor
    std::map<std::vector<int>, std::array<Parts, 2>> parts_; // of cosine and sine
};

class Harmonics {
public:
    Harmonics(Graph& graph, RingPtr ring, Lowering& lowering)
        : graph_(&graph), ring_(std::move(ring)), lowering_(&lowering) {}

    // The angle: the generator e^{i theta}, and the nodes of its cosine and sine.
    void set_angle(GeneratorId phase, Graph::Node cosine, Graph::Node sine);

    // The part of p with e^{ik theta}, k = 0 only or all. rows: takes the same, times eps^power, as
    // amplitudes.
    Graph::Node value(const Polynomial& p, bool oscillating = true, Amplitudes* rows = nullptr,
                      int power = 0);

    // cos k theta and sin k theta as built so far, k >= 1.
    [[nodiscard]] const std::map<int, std::pair<Graph::Node, Graph::Node>>& multiples() const {
        return multiples_;
    }

private:
    std::pair<Graph::Node, Graph::Node> multiple(int k);
    [[nodiscard]] Polynomial coefficient(const Polynomial& p, int k) const;
    [[nodiscard]] Polynomial part(const Polynomial& p, bool imaginary) const;
    [[nodiscard]] int highest(const Polynomial& p) const;

    Graph* graph_;
    RingPtr ring_;
    Lowering* lowering_;
    std::optional<GeneratorId> phase_;
    std::map<int, std::pair<Graph::Node, Graph::Node>> multiples_;
};

} // namespace resonform
