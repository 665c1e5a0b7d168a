// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolation of a polynomial modulo p on as many points as it can have terms.
//
//   variables x, y with x-degree + y-degree <= 2:  points (x_i, y_j), i + j <= 2, six terms
//
// Exponents of each group of variables have a bounded sum. The points with indices (i, j, ...) in the same
// set determine the polynomial: divided differences along each axis give Newton's form, Horner's scheme the
// powers.
#pragma once

#include "algebra/number/modular.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

class NewtonGrid {
public:
    struct Group {
        int variables;
        int degree; // the sum of its exponents is at most this
    };
    explicit NewtonGrid(const std::vector<Group>& groups);

    [[nodiscard]] std::size_t size() const { return indices_.size(); }
    // Exponents of term k, and the indices of point k.
    [[nodiscard]] const std::vector<int>& indices(std::size_t k) const { return indices_[k]; }
    [[nodiscard]] static double size_of(const std::vector<Group>& groups); // without making it

    // Values at the points with coordinates nodes[axis] + index become coefficients.
    void interpolate(const PrimeField& field, const std::vector<Residue>& nodes,
                     std::vector<Residue>& values) const;

private:
    void append(const std::vector<Group>& groups, std::size_t group, int variable, int left,
                std::vector<int>& index);

    std::vector<std::vector<int>> indices_;
    // For each axis the lines along it: positions by ascending index, from 0 on.
    std::vector<std::vector<std::vector<std::uint32_t>>> lines_;
};

} // namespace resonform
