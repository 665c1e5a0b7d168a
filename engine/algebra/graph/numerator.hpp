// SPDX-License-Identifier: GPL-3.0-or-later
// A coefficient times a product of divisors, modulo a prime: a polynomial in the leaves, known by its values.
#pragma once

#include "algebra/graph/replay.hpp"

#include <utility>
#include <vector>

namespace resonform {

// Divisors of the graph with their exponents.
using DivisorPowers = std::vector<std::pair<std::size_t, int>>;

class NumeratorValues {
public:
    // The replay has one target; the divisors are among those it inverts. All must outlive this.
    NumeratorValues(const GraphReplay& replay, const PrimeField& field)
        : replay_(&replay), modular_(replay, field) {}

    [[nodiscard]] const PrimeField& field() const { return modular_.field(); }
    // points[k]: one value for each of replay.leaves(). Errors (std::domain_error): a divisor is zero at one
    // of them, as good as impossible at random points.
    [[nodiscard]] std::vector<Residue> at(const std::vector<std::vector<Residue>>& points,
                                          const DivisorPowers& denominator);

private:
    void multiply(ModularReplay::Block& values, std::size_t divisor, int exponent) const;

    const GraphReplay* replay_;
    ModularReplay modular_;
};

// Modulo p; powers[k] of leaves are looked up by leaf(id).
Residue evaluate(const LeafPolynomial& p, const PrimeField& field, const std::vector<LeafId>& leaves,
                 const std::vector<Residue>& point);

// Denominator and degrees of a coefficient, found before it is expanded.
struct CoefficientShape {
    // Leaves that stand in a divisor, in which the numerator is split into homogeneous parts, and the others;
    // as places among replay.leaves().
    std::vector<std::size_t> inner, outer;
    DivisorPowers denominator; // that of the coefficient, without factors that cancel
    std::vector<int> parts;    // degrees in the inner leaves that occur, ascending
    int outer_degree = 0;
};

CoefficientShape shape_of(const CoefficientGraph& graph, const GraphReplay& replay, std::uint64_t seed);

} // namespace resonform
