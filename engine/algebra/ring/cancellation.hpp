// SPDX-License-Identifier: GPL-3.0-or-later
// Fractions are reduced by the factors that numerator and denominator share:
//
//   (A^2 - 2 A + 1) sigma^-3,  sigma^2 = A - 1      ->   sigma
//   (a + b) D^-1,  D = (a + b)(1 - 2 a)             ->   1/(1 - 2 a)
//   (A - 1) sigma^-1,  sigma^2 = A^2 - 1            ->   as it stands: sigma is no product
#pragma once

#include "algebra/ring/ring.hpp"

#include <vector>

namespace resonform {

// Writes whole powers of the root out by its radicand:  z s^5, s^2 = k + 1  ->  z s (k + 1)^2
Polynomial written_out(const Ring& ring, const Polynomial& p, GeneratorId root);

// factor * numerator / (product of divisors)
struct Fraction {
    Monomial factor;                  // powers of generators, negative ones too
    Polynomial numerator;             // not reduced: for reading, as those of Ring::expanded_form
    std::vector<Polynomial> divisors; // denominators; primitive polynomials of two terms or more
};

// The same value, its numerator coprime to the radicand of each root with a whole power in the denominator,
// and not divisible by that of a root with any power there. Precondition: exponents of the numerator >= 0.
Fraction cancelled(const Ring& ring, const Monomial& factor, Polynomial numerator);

// The same value for evaluation. A radicand whose terms have different signs may come close to zero: its
// powers are taken out of the coefficients over the generators that it does not hold, as powers of its root.
// Written out, it would lose there as many digits as it has leading zeros.
//   (8 + 12 tau + 6 tau^2 + tau^3) z,  s^2 = 2 + tau   ->   s^6 z
Polynomial radicands_apart(const Ring& ring, Polynomial numerator);

// The same value, in a ring whose forms are not canonical with common factors cancelled as far as the ring
// holds the result.
Polynomial cancelled(const Ring& ring, const Polynomial& p);

} // namespace resonform
