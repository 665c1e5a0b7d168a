// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate's checks for the style hamiltonian besides the equations. With the brackets B of the normal
// form, y all modal coordinates and u = T y the variables of the file:
//
//   {q, p} = 1, other brackets of u zero     with y = w: B is the canonical structure in modes
//   {y_a, y_b} = B_ab for y = w + h(w)       the map is canonical, through M - w
//   H(u(w)) = K(w)                           through M + w, by the energy of the file
//   N_a = {w_a, K}                           through M
//   y_a = exp(L_chi) w_a                     through M (lie.hpp)
//
// (w in weights: that of the modes.) With a generator that has no kernel component they have one solution.
#pragma once

#include "certify/flow.hpp"
#include "certify/points/plan.hpp"

namespace resonform {

// Adds all of these but the last, which reads the coordinates that are noted in the plan.
void add_canonical_checks(CertificatePlan& plan, const GradedField& field, const HamiltonianForm& form,
                          const Jets& jets, CertificateRoots& roots);

// The weight of the modes, by which the weights of the energy exceed those of the rates.
int weight_of_modes(const GradedField& field);

} // namespace resonform
