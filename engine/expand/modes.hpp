// SPDX-License-Identifier: GPL-3.0-or-later
// The linear part of the fast variables: which of them are oscillators, and with what frequency.
#pragma once

#include "expand/coefficient_ring.hpp"

namespace resonform {

// psi'' = -omega_squared(xi) psi + (higher weight).
struct Oscillator {
    std::size_t variable;
    GiNaC::ex omega_squared;
};

// Checks the weight-0 Jacobian of one fast variable. Only the vanishing symbols of `coefficients` are
// used; it need not be frozen.
// Errors: bad_input: order other than 2, a force at the origin, linear part absent, division by an
// expression that is zero; refused: damping or coupling at weight 0, omega^2 not provably positive.
Oscillator find_oscillator(const FirstOrderSystem& system, std::size_t variable,
                           const CoefficientRing& coefficients);

} // namespace resonform
