// SPDX-License-Identifier: GPL-3.0-or-later
// Values and signs of expressions, proved by balls: of any size, to any accuracy.
#pragma once

#include "algebra/number/real_ball.hpp"

#include <ginac/ginac.h>

#include <optional>

namespace resonform {

// true: a number made of numbers, pi and functions, without symbols.   log(2), sin(1)/3
bool is_constant(const GiNaC::ex& e);

// A ball that holds the real value of e at a point, each step to about `bits` binary digits. The point gives
// symbols their values, and calls of functions that are known by their names only. nullopt: no value, or none
// that this proves to be real (log of a number that may be negative, a divisor that may be zero), or a power
// or function of a size beyond 2^(+-2^20).
std::optional<RealBall> enclose(const GiNaC::ex& e, const GiNaC::exmap& point, std::int64_t bits);
// With 64, 128, 256, 512 bits, until its sign is known.
std::optional<RealBall> enclose(const GiNaC::ex& e, const GiNaC::exmap& point = {});

enum class ConstantSign { negative, positive, unknown };

// Of a constant. unknown: zero, not real, or not decided with 512 bits.
//   log(2) -> positive   cos(2) -> negative   sin(1)^2 + cos(1)^2 - 1 -> unknown
ConstantSign sign_of_constant(const GiNaC::ex& e);

} // namespace resonform
