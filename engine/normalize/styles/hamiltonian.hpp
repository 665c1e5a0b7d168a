// SPDX-License-Identifier: GPL-3.0-or-later
// Normal form of a Hamiltonian system by a Lie series: a canonical map whose generator has no resonant
// component (design 2.3). By weights, from that of the quadratic part H_2 on,
//
//   K = exp(L_chi) H:   <alpha, lambda> chi_alpha + K_alpha = R_alpha
//   map: z = exp(L_chi) w,   rates: w' = {w, K}
//
//   q'' + q + q^3 = 0, H = (p^2 + q^2)/2 + q^4/4:   K = I + 3/8 I^2 - 17/64 I^3 + ..., I = |w|^2/2
#pragma once

#include "normalize/recursion/poincare.hpp"

namespace resonform {

// The result has style "hamiltonian" and keeps K, chi and the brackets. 1 <= through <= 99.
// Errors: bad_input: a system without [hamiltonian]; refused: what brackets_of_modes refuses (poisson.hpp),
// and a force of the weight of the fast variables, eps*x in the energy.
Normalization normalize_hamiltonian(std::shared_ptr<const GradedField> field, int through,
                                    const NormalizeOptions& options = {});

} // namespace resonform
