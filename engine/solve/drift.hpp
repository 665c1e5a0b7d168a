// SPDX-License-Identifier: GPL-3.0-or-later
// The drift variables in normal form: Z' = sum a_kc(xi) |w|^(2k) eps^c, integrated over slow time:
//
//   z_X = C_X + r log((xi + s^(1/2))/r) - r eps^2 int_{xi_0}^{xi} (v^2 xi^2/(g s^2) + C^2/(4 s^(3/4))) d xi
//   (23)
#pragma once

#include "solve/draft.hpp"

namespace resonform {

// Fills the values of all drifts through eps^(M-1): a rate of weight n gives eps^(n-1). Each power of
// eps of each variable is integrated in closed form as a whole or left as one quadrature: its closed
// parts cost nothing under an integral that has to be tabulated anyway.
// Errors (refused): a drift rate of weight 0.
void solve_drift(Draft& draft);

} // namespace resonform
