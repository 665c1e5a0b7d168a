// SPDX-License-Identifier: GPL-3.0-or-later
// Modes of a linear part that is not semisimple: z' = (lambda + n) z with couplings n between modes of one
// eigenvalue only,
//
//   z_j' = lambda_j z_j + sum_k n_jk z_k,   n_jk rational numbers, n nilpotent          (design 2.2)
//   x' = b y, y' = 0:  z1 = x, z2 = b y, n_12 = 1
//
// Modes are scaled so that n is 1 along a spanning tree of the couplings, from the first mode on: the inner
// product that selects the normal form is that of these modes (docs/design/12_styles.md).
#pragma once

#include "expand/modes/mode_blocks.hpp"
#include "expand/modes/modes.hpp"

namespace resonform {

// A mode of a block by itself.
struct LoneMode {
    ModeShape shape; // column and row over all fast states, zero outside the block
    std::size_t block;
    std::string name; // of its pivot, for messages
    Place place;      // of the equation of its pivot
};

// a: the linear part; from_driver: indices of all modes, each before those that it drives.
// Preconditions: modes of one block do not drive each other, except in a chain (`chained[block]`).
// Errors (refused): it is not proved whether eigenvalues or couplings vanish; couplings that cannot be
// scaled to numbers.
std::vector<ModeShape> jordan_modes(const Matrix& a, const std::vector<LoneMode>& modes,
                                    const std::vector<std::size_t>& from_driver,
                                    const std::vector<bool>& chained);

// Whether a is zero for all values of its symbols; a number is its real and its imaginary part.
Zero vanishes(const Complex& a);

} // namespace resonform
