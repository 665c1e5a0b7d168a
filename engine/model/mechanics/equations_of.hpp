// SPDX-License-Identifier: GPL-3.0-or-later
// From a mechanism to the equations of an ordinary system.
#pragma once

#include "model/mechanics/mechanical_equations.hpp"

namespace resonform {

// Constraints, their constants, the equations of Gibbs and Appell, the same by multipliers, and the change of
// variables. `system` has parameters, variables (three symbols in each jet) and domain.
// Errors: those of every step.
MechanicalEquations equations_of(const Mechanism& mechanism, const System& system);

} // namespace resonform
