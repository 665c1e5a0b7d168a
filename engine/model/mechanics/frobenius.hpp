// SPDX-License-Identifier: GPL-3.0-or-later
// Are constraints x_d' = sum B_di x_i' + b_d integrable? With the fields X_i = d/dx_i + sum B_di d/dx_d and
// X_0 = sum s' d/ds + sum b_d d/dx_d, over the prescribed s, they are where the terms X_i(B_dk) - X_k(B_di),
// X_i(b_d) - X_0(B_di) vanish.
#pragma once

#include "model/mechanics/constraints.hpp"

namespace resonform {

// Requires it at eps = 0, where prescribed coordinates rest or move by their laws, s' = V.
// Errors (refused): a term that does not vanish, or cannot be told to; a velocity that is left at eps = 0
// although nothing prescribed moves.
void require_integrable_unperturbed(const SolvedConstraints& constraints, const Motion& motion);

// Whether they are for every eps, by the laws of prescribed coordinates (holonomic). False: not proved.
bool integrable_for_every_eps(const SolvedConstraints& constraints, const Motion& motion);

} // namespace resonform
