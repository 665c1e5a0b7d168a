// SPDX-License-Identifier: GPL-3.0-or-later
// Modes whose growth rate has no declared sign, and those that may pass through Re lambda = 0:
//
//   z' = lambda(zeta) z + eps g(zeta) + ...,   lambda = mu + i omega,   mu < 0 at the start, mu > 0 later
//
// z stays as small as it has become until the exponent chi = int mu dt, counted from the start, has come back
// to 0 (delayed loss of stability). What drives the mode departs earlier if the motion gets past the buffer
// point, the complex time T* at which lambda = 0. There the phase of int exp(-chi - i theta) g dt is
// stationary: it leaves behind
//
//   |g| sqrt(2 pi/|lambda'|) e^B,   B = Re int_{T*}^T lambda dt = Re lambda^2/(2 lambda')
//
// and B is exact where lambda is linear in time and g has no singularity of its own. Only there is a mode
// followed through mu = 0; elsewhere the sign of its start is kept.
#pragma once

#include "expand/expansion/graded_field.hpp"

namespace resonform {

// Whether the sign of Re lambda is proved neither way by what the system declares.
bool has_either_sign(const GradedField& field, std::size_t k);

// Whether Re lambda of mode k may vanish along the motion without harm: Im lambda != 0, and either Re lambda
// is a constant, or the mode is alone (no other mode, no angle), lambda is linear in slow variables, these
// move evenly and undriven, and the equations are polynomials in them.
bool may_pass_zero(const GradedField& field, std::size_t k);

// Whether p holds a slow variable.
bool moves_slowly(const GradedField& field, const Polynomial& p);

// dp/dt along slow variables that are not driven.
Polynomial slope_in_time(const GradedField& field, const Polynomial& p);

// Whether they differ by a rational factor.
bool are_proportional(const Polynomial& p, const Polynomial& q);

// Whether p is a multiple of Re lambda of mode k: the divisor of |z|^2 and its like, which are gone where it
// vanishes.
bool is_multiple_of_growth(const GradedField& field, std::size_t k, const Polynomial& p);

} // namespace resonform
