// SPDX-License-Identifier: GPL-3.0-or-later
// The second route to the equations of motion: d'Alembert and Lagrange with multipliers,
//   d/dt dT/dx_k' - dT/dx_k - Q_k = sum of lambda_s a_sk.
// It shares nothing with the first but the expressions of the file.
#pragma once

#include "model/mechanics/gibbs_appell.hpp"

namespace resonform {

// Do the velocities and accelerations of dependent coordinates satisfy the constraints and these
// differentiated, whatever the independent ones are? Are the equations of the first route those with
// multipliers along every direction that the constraints allow, identically, and are they satisfied by the
// accelerations that they were solved for (if they were)?
// Errors (refused): no, or it cannot be told.
void check_by_multipliers(const Mechanism& mechanism, ExactForm& form, const SolvedConstraints& constraints,
                          const AppellEquations& appell);

} // namespace resonform
