// SPDX-License-Identifier: GPL-3.0-or-later
// The first route to the equations of motion: the energy of accelerations S = 1/2 sum m a^2, the constraints
// differentiated and put in, dS/dx'' = Q for every independent coordinate.
#pragma once

#include "model/mechanics/constraints.hpp"

namespace resonform {

struct AppellEquations {
    GiNaC::ex energy;                     // S of all accelerations
    GiNaC::exmap differentiated;          // x_d'' of dependent coordinates, by independent accelerations
    GiNaC::ex constrained;                // S of the independent ones
    std::vector<GiNaC::ex> equations;     // dS/dx'' - Q, of independent coordinates
    std::vector<GiNaC::ex> accelerations; // these solved; none where they would be too long
};

// S of a Lagrangian is the one whose derivatives are Nielsen's, dL'/dx' - 2 dL/dx.
// Errors: bad_input: a matrix of accelerations that is singular; refused: one that cannot be told.
AppellEquations appell_equations(const Motion& motion, const SolvedConstraints& constraints);

} // namespace resonform
