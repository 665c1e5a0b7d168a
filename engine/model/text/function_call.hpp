// SPDX-License-Identifier: GPL-3.0-or-later
// The elementary functions of algebra/number/functions.hpp as expressions.
#pragma once

#include "algebra/number/functions.hpp"

#include <ginac/ginac.h>

#include <optional>

namespace resonform {

// nullopt: e is no call of one of the table; it may be omega(tau).
std::optional<Function> function_of(const GiNaC::ex& e);

// f(u), with its value where the library knows it; acos(u) as pi/2 - asin(u), so that pi cancels where it
// can. Errors: GiNaC's of a pole.
GiNaC::ex call(Function f, const GiNaC::ex& u);

// The expression that must be >= 0 for f(u) to be real, and > 0 for it to have a slope: 1 - u^2 of asin.
GiNaC::ex asked_of(const GiNaC::ex& u, Function f);

} // namespace resonform
