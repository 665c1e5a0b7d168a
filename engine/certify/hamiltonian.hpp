// SPDX-License-Identifier: GPL-3.0-or-later
// What a certificate checks of the style hamiltonian besides the equations. With the brackets B of the normal
// form, y all modal coordinates and u = T y the variables of the file:
//
//   {q, p} = 1, other brackets of u zero     with y = w: B is the canonical structure in modes
//   {y_a, y_b} = B_ab for y = w + h(w)       the map is canonical, through M - w
//   H(u(w)) = K(w)                           through M + w, by the energy of the file
//   N_a = {w_a, K}                           through M
//   y_a = exp(L_chi) w_a                     through M (certificate_lie.hpp)
//
// (w in weights: that of the modes.) With a generator that has no kernel component they have one solution.
#pragma once

#include "certify/flow.hpp"
#include "certify/plan.hpp"

namespace resonform {

// All but the last, which takes the coordinates that are noted in the plan.
void add_canonical_checks(CertificatePlan& plan, const GradedField& field, const HamiltonianForm& form,
                          const Jets& jets, CertificateRoots& roots);

// By how much the energy has larger weights than the rates: the weight of the modes.
int weight_of_modes(const GradedField& field);

} // namespace resonform
