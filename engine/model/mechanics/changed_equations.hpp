// SPDX-License-Identifier: GPL-3.0-or-later
// Equations in new variables, as texts of a file:
//
//   phi'' = -g*sin(phi), xi' = eps*v, and phi = psi + xi^2    ->   psi'' = -2*xi'^2 - g*sin(psi + xi^2)
//
// Derivatives of the old variables are total ones. What of them is beyond the equation of a variable that
// stays (xi'') is the derivative of its rate along the motion.
#pragma once

#include "model/system/mechanism.hpp"

#include <vector>

namespace resonform {

struct Replacement {
    std::size_t variable; // of the old system
    Written value;        // in variables of the new one, parameters and eps
};

struct ChangeOfEquations {
    System before; // with its equations
    // Without equations; its variables that are not in `before` are new, as many as replacements. Those that
    // stay have the symbols of `before`, and every one has as many as the longest there.
    System after;
    std::vector<Replacement> replacements;
    GiNaC::exmap small; // eps and small parameters, each with 0
};

// One per variable of `after`, in that order; residuals are left 0. An equation without old variables has its
// own text. Errors: bad_input: a change that is not invertible, equations that cannot be solved for their
// highest derivatives, or have no value in the new variables; refused: one that is not proved invertible;
// variables that depend on each other with equations of different order; a derivative beyond the equation of
// a variable that stays, which depends on itself.
std::vector<Equation> changed_equations(const ChangeOfEquations& change);

} // namespace resonform
