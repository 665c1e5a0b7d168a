// SPDX-License-Identifier: GPL-3.0-or-later
// The constraints of a mechanism, a_si x_i' + a_s0 = 0, solved for dependent velocities.
//
//   z' = eps*(x'*y - y'*x)   ->   dependent z, independent x, y; slope (eps*y, -eps*x), rest 0
#pragma once

#include "model/mechanics/motion.hpp"

namespace resonform {

struct SolvedConstraints {
    std::vector<std::size_t> dependent, independent; // coordinates
    // x_d' = sum of slope[d][i] x_i' + rest[d], over the places in dependent and independent
    std::vector<std::vector<GiNaC::ex>> slope;
    std::vector<GiNaC::ex> rest;
    GiNaC::exmap velocities; // x_d' -> that sum
};

// Coordinates that are no fast variable or angle become dependent first, in the order of the file; divisors
// differ from zero at eps = 0.
// Errors: bad_input: dependent constraints, as many as coordinates or more; refused: a constraint that is not
// linear in the velocities (marks the term), a rank that falls at eps = 0 or cannot be told.
SolvedConstraints solve_constraints(const Motion& motion);

} // namespace resonform
