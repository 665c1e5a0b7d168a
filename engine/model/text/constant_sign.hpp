// SPDX-License-Identifier: GPL-3.0-or-later
// Values and signs of expressions, proved by intervals with rational ends: of any size, to any accuracy.
#pragma once

#include "algebra/number/interval.hpp"

#include <ginac/ginac.h>

#include <optional>

namespace resonform {

// true: a number made of numbers, pi and functions, without symbols.   log(2), sin(1)/3
bool is_constant(const GiNaC::ex& e);

// An interval that holds the real value of e at a point (the symbols by rational numbers), each step to about
// `bits` binary digits. nullopt: no value, or none that this proves to be real (log of what may be negative,
// a divisor that may be zero), or a function known by its name only.
std::optional<Interval> enclosure(const GiNaC::ex& e, const GiNaC::exmap& point, int bits);

enum class ConstantSign { negative, positive, unknown };

// Of a constant. unknown: zero, not real, or not decided with 512 bits.
//   log(2) -> positive   cos(2) -> negative   sin(1)^2 + cos(1)^2 - 1 -> unknown
ConstantSign sign_of_constant(const GiNaC::ex& e);

} // namespace resonform
