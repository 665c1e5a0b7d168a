// SPDX-License-Identifier: GPL-3.0-or-later
// The centre manifold of a normal form; a slow manifold where all other modes decay. Modes with a growth
// rate, Re lambda_s != 0, are slaved to the rest y = (w_c, e^{i theta}, zeta, eps):
//
//   w_s = 0 is invariant:  N_s(y, 0) = 0, for no divisor <alpha, lambda_c> - lambda_s vanishes
//   on it:                 z_s = h_s(y, 0),   Y = y + h(y, 0),   y' = N(y, 0)
//   fibre of a state:      all states with the same y = Y + g(Y, z_s); they approach each other as e^{Re
//   lambda_s t}
//
// through the weight of the normal form.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <vector>

namespace resonform {

struct CentreManifold {
    std::vector<bool> slaved; // by mode
    NormalForm flow;          // N(y, 0); of a slaved mode: zero
    NearIdentityMap manifold; // h(y, 0); of a slaved mode: the old variable itself
    NearIdentityMap fibres;   // g in the old variables; of a slaved mode: zero
};

// Errors (refused): no mode has a growth rate. It is known before anything is derived.
void require_slaved_modes(const GradedField& field);

// Errors (refused): that of require_slaved_modes; a term that was kept near, or a declared relation, drives a
// slaved mode.
CentreManifold centre_manifold(const Normalization& normalization);

} // namespace resonform
