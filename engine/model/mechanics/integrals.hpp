// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of the constraints at eps = 0, where prescribed coordinates rest or move by their laws: the
// new coordinates q_{n+mu} = phi_mu(x) of a weakly nonholonomic system.
#pragma once

#include "model/mechanics/constraints.hpp"

namespace resonform {

struct Constant {
    Coordinate coordinate; // R; where a dependent coordinate is constant itself, that one
    GiNaC::ex integral;    // phi(x)
    std::size_t dependent; // place in SolvedConstraints::dependent: the coordinate that R replaces
    GiNaC::ex value;       // of that coordinate, in R and the coordinates that stay
    bool itself = false;   // R is that coordinate
};

// One for each constraint: those of the file, checked; dependent coordinates that are constant themselves;
// elementary ones found by integration, named R_y where y was dependent, and added to `motion`.
// Errors: bad_input: an integral of the file that is not constant, too many of them; refused: none is found,
// or it cannot be solved for the dependent coordinate.
std::vector<Constant> find_constants(const SolvedConstraints& constraints, Motion& motion);

} // namespace resonform
