// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that hold the values of functions, generators and polynomials at a point.
//
//   s - 1, s = 2^(1/2)   ->   0.41421356237309504880 +- 1e-19, with 64 bits
#pragma once

#include "algebra/number/complex_ball.hpp"
#include "algebra/ring/ring.hpp"

#include <functional>
#include <optional>

namespace resonform {

// The values of the generators other than i.
using BallOf = std::function<const RealBall&(GeneratorId)>;

// All of these are not finite where x does not lie in the domain of f, or a divisor may be zero.
// Precondition: not Function::named.
RealBall enclose(Function f, const RealBall& x, std::int64_t bits);
ComplexBall enclose(const Ring& ring, const Polynomial& p, const BallOf& value_of, std::int64_t bits);
// Of pi, a root, or an elementary function; nullopt: g is none of these, or a root whose radicand may be
// negative or zero.
std::optional<RealBall> enclose(const Ring& ring, const Generator& g, const BallOf& value_of,
                                std::int64_t bits);

} // namespace resonform
