// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary integrals of the simplest kind.
#pragma once

#include <ginac/ginac.h>

#include <optional>

namespace resonform {

// f with df/dx = e, for sums of c*(a*x + b)^n, c*f(a*x + b) with f one of sin, cos, exp, sinh, cosh, and
// powers x^n with one of these, where a, b, c are free of x and a is a number or a product. nullopt: none
// found.
std::optional<GiNaC::ex> antiderivative(const GiNaC::ex& e, const GiNaC::symbol& x);

} // namespace resonform
