// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals of rational functions by partial fractions.
#pragma once

#include "model/integrals/positive_there.hpp"

#include <optional>

namespace resonform {

// Whether e may be a divisor: a sum must be proved nonzero; a product is trusted, as in the file.
bool may_divide(const GiNaC::ex& e, const PositiveThere& positive);

// log|u|, by the sign that is proved: log(u), log(-u), else log(u^2)/2.
GiNaC::ex log_of_size(const GiNaC::ex& u, const PositiveThere& positive);

// f with df/dx = e for a rational function of x. nullopt: none, or a factor of the denominator of degree > 2,
// or a quadratic one whose discriminant has no proved sign.
std::optional<GiNaC::ex> integral_of_rational(const GiNaC::ex& e, const GiNaC::symbol& x,
                                              const PositiveThere& positive);

} // namespace resonform
