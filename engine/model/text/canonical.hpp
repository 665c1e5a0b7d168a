// SPDX-License-Identifier: GPL-3.0-or-later
// GiNaC orders the operands of sums and products by hashes that differ from run to run. Whatever walks
// over them and may refuse, choose or print does it in the order of their spelling instead.
#pragma once

#include "algebra/number/number.hpp"

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace resonform {

// An expression as the user would write it: r^2 + xi^2, (r^2 + xi^2)^(1/4), 3*g*sin(psi). Sums that are
// factors begin with a positive term: GiNaC leaves to the order of terms whether it says b - a or a - b.
std::string spell(const GiNaC::ex& e);

// The operands of any expression; those of a sum or a product sorted by their spelling. Cost: that of
// spelling e, so that a walk through all levels costs size times depth.
std::vector<GiNaC::ex> operands(const GiNaC::ex& e);

// The terms of a sum, or e alone; the factors of a product.
std::vector<GiNaC::ex> terms_of(const GiNaC::ex& e);
std::vector<GiNaC::ex> factors_of(const GiNaC::ex& e);

Rational to_rational(const GiNaC::ex& number); // precondition: a rational GiNaC number
GiNaC::ex to_ginac(const Rational& number);

// Whether e is more than a rational expression in its symbols.
bool holds_functions_or_roots(const GiNaC::ex& e);

// The sum or its negative, whichever begins with a positive term (numbers come last).
GiNaC::ex canonical_sign(const GiNaC::ex& sum);

} // namespace resonform
