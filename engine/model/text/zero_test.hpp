// SPDX-License-Identifier: GPL-3.0-or-later
// Is an expression zero for all values of its symbols? Three answers (design, section 3).
#pragma once

#include "algebra/ring/ring.hpp"

#include <ginac/ginac.h>

#include <vector>

namespace resonform {

// no: the expression differs from zero at a point with rational coordinates in (0, 2), proved by ball
// arithmetic; yes: it is zero by expanding or (if it is small) normalising; unknown: neither.
Zero vanishes(const GiNaC::ex& e);
// The answer is no; false: yes or unknown.
bool differs_from_zero(const GiNaC::ex& e);
// Where all of these are positive: sqrt(1 - 2*w + w^2) - 1 + w vanishes only for w < 1.
Zero vanishes(const GiNaC::ex& e, const std::vector<GiNaC::ex>& positive);
bool differs_from_zero(const GiNaC::ex& e, const std::vector<GiNaC::ex>& positive);

// Gives a value to each call in e of a function that is known by its name only: it may be 1 + exp(u/n), with
// n from its name. If e differs from zero for it, it does for some function.
void add_named(const GiNaC::ex& e, GiNaC::exmap& point);

} // namespace resonform
