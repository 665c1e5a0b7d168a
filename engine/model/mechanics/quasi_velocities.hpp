// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of Gibbs and Appell in quasi-velocities u_k = sum of A_ki x_i' + a_k, as many as there are
// degrees of freedom:
//
//   u = x'*cos(phi) + y'*sin(phi)   ->   x' = u*cos(phi), ...;  dS/du' = sum of Q_i dx_i'/du
#pragma once

#include "model/mechanics/gibbs_appell.hpp"

namespace resonform {

struct QuasiEquations {
    GiNaC::exmap velocities;              // of independent coordinates, then of dependent ones, by u
    GiNaC::ex energy;                     // S of u'
    std::vector<GiNaC::ex> equations;     // dS/du' - its force
    std::vector<GiNaC::ex> accelerations; // u', solved; none where they would be too long
};

// Errors: bad_input: too few or too many, not linear in the velocities, dependent on each other or on the
// constraints; refused: one of these is not proved, or equations that are not those of the coordinates.
// Precondition: the mechanism has quasi-velocities.
QuasiEquations quasi_equations(const Motion& motion, const SolvedConstraints& constraints,
                               const AppellEquations& appell);

} // namespace resonform
