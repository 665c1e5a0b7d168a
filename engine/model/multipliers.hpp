// SPDX-License-Identifier: GPL-3.0-or-later
// The second route to the equations of motion: d'Alembert and Lagrange with multipliers,
//   d/dt dT/dx_k' - dT/dx_k - Q_k = sum of lambda_s a_sk.
// It shares nothing with the first but the expressions of the file.
#pragma once

#include "model/exact_form.hpp"
#include "model/mechanism.hpp"

namespace resonform {

// Do these velocities of dependent coordinates and accelerations of all satisfy the constraints, the
// constraints differentiated, and for some multipliers the equations, identically?
// Errors (refused): no, or it cannot be told.
void check_by_multipliers(const Mechanism& mechanism, ExactForm& form, const GiNaC::exmap& velocities,
                          const GiNaC::exmap& accelerations);

} // namespace resonform
