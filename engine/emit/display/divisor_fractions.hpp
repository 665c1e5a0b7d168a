// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial over the divisors that its ring has learned, as a sum of fractions to evaluate:
//
//   u*(1/D1 + 1/D2) + v/D3   ->   (D1 D2)^-1 * u*(D1 + D2) + D3^-1 * v,   D1, D2 written out
//
// Only terms with divisors are put over a common denominator, and only where the numerator does not become
// much longer by it: with many divisors it would grow like the product of their lengths. Common
// factors of numerator and denominator are cancelled.
#pragma once

#include "algebra/ring/cancellation.hpp"

#include <vector>

namespace resonform {

// Their factors are powers of divisors.
std::vector<Fraction> divisor_fractions(const Ring& ring, const Polynomial& p);

// The same with roots and monomials factored out, common factors cancelled and radicands apart: emitted code
// is made from these.
std::vector<Fraction> reduced_fractions(const Ring& ring, const Polynomial& p);

} // namespace resonform
