// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary functions of intervals: Taylor sums with their remainders, all ends rational.
#pragma once

#include "algebra/number/interval.hpp"
#include "algebra/ring/ring.hpp"

#include <optional>

namespace resonform {

// An interval that holds f(x) for every x of u, about `bits` binary digits wide of the best one. nullopt:
// u does not lie in the domain of f (log: u > 0), or is too large to be worth it.
// Precondition: not Function::named.
std::optional<Interval> function(Function f, const Interval& u, int bits);

} // namespace resonform
