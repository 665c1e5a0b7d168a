// SPDX-License-Identifier: GPL-3.0-or-later
// Primitives in closed form: an ansatz over the ring plus logarithms, solved exactly.
//
//   x = xi, s = xi^2 + r^2:   xi s^(-3/4)  ->  2 s^(1/4)
//                             r s^(-1/2)   ->  r log((xi + s^(1/2))/r)
//                             xi^2 s^(-2)  ->  not closed (it has an arc tangent)
#pragma once

#include "algebra/ring/ring.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace resonform {

// A logarithm whose derivative lies in the ring.
struct Logarithm {
    Polynomial argument;   // positive where the ring's roots are
    Polynomial derivative; // d/dx log(argument)
};

// log(P/P(0)) and, for P = a x^2 + b x + c with a > 0, log(2 a x + b + 2 sqrt(a P)), for every
// radicand P of a root that depends on x. Divided by its value at x = 0 where that is a unit of the
// ring: then it vanishes there.
std::vector<Logarithm> logarithms(const Ring& ring, GeneratorId x);

struct ClosedForm {
    Polynomial algebraic; // without additive constant: nothing in it is free of x (roots expanded)
    std::vector<std::pair<Polynomial, Logarithm>> logarithmic; // coefficient, logarithm
};

// F with speed dF/dx = f, F = sum_m c_m m + sum_k q_k log_k, rational c_m over a finite set of monomials
// (x f/speed and its neighbours under the derivation), q_k free of x. Nothing is divided by the speed, which
// may be zero. nullopt: not within the ansatz, which proves nothing about elementary integrability.
std::optional<ClosedForm> close_primitive(const Ring& ring, GeneratorId x, const Polynomial& f,
                                          const Polynomial& speed = Polynomial(Rational(1)));

// p/divisor if the divisor is a unit or divides p term by term of the ring: never a division by
// something that may be zero.
std::optional<Polynomial> quotient_in_ring(const Ring& ring, const Polynomial& p, const Polynomial& divisor);

} // namespace resonform
