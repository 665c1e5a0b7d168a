// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals phi_mu(x) = R_mu of a file, solved together for dependent coordinates: one after the other, each
// where it is linear or has an inverse, and put into the others.
//
//   R = y + z, Q = y - z  ->  y = (Q + R)/2, z = (R - Q)/2
#pragma once

#include "model/mechanics/constraints.hpp"

namespace resonform {

struct SolvedIntegral {
    const Integral* integral;
    std::size_t dependent; // place in SolvedConstraints::dependent: the coordinate that R replaces
    GiNaC::ex value;       // of that coordinate, in constants R and coordinates that are not solved for
};

// `preferred`: the dependent coordinates, those first that are to be replaced if possible. The value of one
// under [change] is taken, and must satisfy the integrals. Errors: bad_input: more integrals than
// they determine coordinates, a change that does not invert; refused: an integral that cannot be solved (with
// the domain that is not proved).
std::vector<SolvedIntegral> solve_integrals(const SolvedConstraints& constraints, const Motion& motion,
                                            const std::vector<std::size_t>& preferred);

} // namespace resonform
