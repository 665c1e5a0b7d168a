// SPDX-License-Identifier: GPL-3.0-or-later
// exp(L_chi) f = f + {f, chi} + {{f, chi}, chi}/2 + ..., order by order. An order is a weight above the
// lowest one: f = f_0 + f_1 + ..., chi = chi_1 + chi_2 + ..., and {f_i, chi_j} has order i + j.
//
//   f^(0) = f,   f^(k)_n = 1/k sum_{j=1}^{n-k+1} {f^(k-1)_{n-j}, chi_j},   [exp(L_chi) f]_n = sum_k f^(k)_n
//
// chi_n occurs only in f^(1)_n, as {f_0, chi_n}: all other terms are known when chi_n is solved for.
#pragma once

#include "normalize/styles/poisson.hpp"

#include <vector>

namespace resonform {

// chi_1, chi_2, ... as they are found.
class LieGenerator {
public:
    LieGenerator(RingPtr ring, HamiltonianVector::Brackets brackets)
        : ring_(std::move(ring)), brackets_(std::move(brackets)) {}

    void append(const Polynomial& chi) { vectors_.emplace_back(*ring_, brackets_, chi); }
    [[nodiscard]] const Ring& ring() const { return *ring_; }
    [[nodiscard]] const HamiltonianVector::Brackets& brackets() const { return brackets_; }
    [[nodiscard]] const HamiltonianVector& vector(int order) const { // {y_a, chi_order}
        return vectors_[static_cast<std::size_t>(order) - 1];
    }

private:
    RingPtr ring_;
    HamiltonianVector::Brackets brackets_;
    std::vector<HamiltonianVector> vectors_;
};

class LieSeries {
public:
    // The generator must outlive the series.
    explicit LieSeries(const LieGenerator& generator) : generator_(generator) {}

    // Orders come one by one from 0. Returns [exp(L_chi) f]_n without {f_0, chi_n}, given f_n.
    Polynomial advance(const Polynomial& f);
    // Adds {f_0, chi_n}, before the next advance.
    void complete(const Polynomial& newest);
    // {f_0, chi_n} for a chi_n that has been appended to the generator.
    [[nodiscard]] Polynomial newest() const;

private:
    // The derivatives of f^(k) by the coordinates, for each order, as needed by further brackets.
    using Slopes = std::vector<std::pair<GeneratorId, Polynomial>>;
    using Iterate = std::vector<Slopes>;
    void set(std::size_t k, const Polynomial& part);
    [[nodiscard]] Polynomial bracketed(std::size_t k) const; // f^(k)_n with chi below n

    const LieGenerator& generator_;
    std::vector<Iterate> iterates_;
    int order_ = -1;
    Polynomial first_; // f^(1)_n as far as it is known
};

} // namespace resonform
