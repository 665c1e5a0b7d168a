// SPDX-License-Identifier: GPL-3.0-or-later
// The first-order system with the states of [equilibrium] measured from there. What the equilibrium moves by
// with the slow variables enters the rates:
//
//   c = s/(s + kappa) + z:   z' = -(s + kappa)*z - (kappa/(s + kappa)^2)*s'
#pragma once

#include "model/exact/first_order_system.hpp"

namespace resonform {

// The same pointer for a system without [equilibrium], or whose states are measured from there already. The
// states keep names and symbols; State::shift is what a user's variable is more, and the residuals of the
// equations are rewritten, for the certificate.
// Errors: bad_input: a pole; refused: a velocity that changes with the equilibrium through fast variables or
// angles.
std::shared_ptr<const FirstOrderSystem> about_equilibrium(std::shared_ptr<const FirstOrderSystem> system);

} // namespace resonform
