// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals with sines and cosines: products become sums, quotients rational functions.
#pragma once

#include "model/integrals/positive_there.hpp"

#include <optional>

namespace resonform {

// The derivative of a linear function of x; nullopt: it is none, or its slope might be zero.
std::optional<GiNaC::ex> slope_of(const GiNaC::ex& linear, const GiNaC::symbol& x,
                                  const PositiveThere& positive);

// Of x^n times powers of exp(u), sin(v), cos(w), or of sinh(v), cosh(w), with linear u, v, w.
std::optional<GiNaC::ex> integral_of_circular_product(const GiNaC::ex& product, const GiNaC::symbol& x,
                                                      const PositiveThere& positive);

// Of a rational function of sin and cos, or of sinh and cosh, of one linear argument: by t = cos, t = sin or
// t = tan. An arc of t = tan would jump where the integrand does not, and is none.
std::optional<GiNaC::ex> integral_by_substitution(const GiNaC::ex& e, const GiNaC::symbol& x,
                                                  const PositiveThere& positive);

} // namespace resonform
