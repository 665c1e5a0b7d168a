// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial over the divisors that its ring has learned, as a sum of fractions to evaluate:
//
//   u*(1/D1 + 1/D2) + v/D3   ->   (D1 D2)^-1 * u*(D1 + D2) + D3^-1 * v,   D1, D2 written out
//
// Only what has to do with divisors is put over a common denominator, and only where the numerator does not
// become much longer by it: with many divisors it would grow like the product of their lengths.
#pragma once

#include "algebra/ring.hpp"

#include <map>

namespace resonform {

// Powers of divisors -> numerator.
std::map<Monomial, Polynomial> divisor_fractions(const Ring& ring, const Polynomial& p);

} // namespace resonform
