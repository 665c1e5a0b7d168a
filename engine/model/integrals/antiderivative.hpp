// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary integrals.
#pragma once

#include "model/integrals/positive_there.hpp"

#include <optional>

namespace resonform {

// f with df/dx = e, e a sum of terms of these kinds; a, b are free of x, and a is a number, a product, or a
// sum that is proved nonzero:
// - rational functions whose denominators have linear factors, and quadratic ones of a proved sign;
// - x^n (a*x + b)^r with a rational r;
// - x^n times products of exp, sin, cos of a*x + b, or of sinh, cosh;
// - rational functions of sin and cos (tan is one) of one a*x + b that are odd in one of them, or even in
//   both and integrated without arcs; the same of sinh and cosh that are odd in one;
// - x^n times log, atan of a*x + b;
// - g(w(x)) w'(x) with g one of these.
// nullopt: none found. Real where e is: log(-u) or log(u^2)/2 where u > 0 is not proved. The caller
// differentiates.
std::optional<GiNaC::ex> antiderivative(const GiNaC::ex& e, const GiNaC::symbol& x,
                                        const PositiveThere& positive);

} // namespace resonform
