// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of the near-identity map, through the same weight M. With y = (w, theta, zeta), Y = (z, phi,
// xi), Y = y + c(y, eps) and X = Z + l(y, eps):
//   y = Y + g(Y, eps),   g = -c(Y + g)        weight by weight: [c(Y + g)]_n needs g below weight n, and at n
//   Z = X + m(Y, eps),   m = -l(Y + g)        only where c is linear in small fast variables: these are
//                                              solved first, those of larger weight before the others
#pragma once

#include "normalize/recursion/normal_form.hpp"

namespace resonform {

// The new variable minus the old one: g and m, in which the generators stand for the old variables.
NearIdentityMap invert(const NormalForm& normal_form, const NearIdentityMap& map);

// p(Y + shift(Y)) through a weight: modes (with their conjugates), angles and driven slow variables are
// shifted; shift.drift is not looked at.
Series compose(const GradedField& field, const Series& p, const NearIdentityMap& shift, int through);

} // namespace resonform
