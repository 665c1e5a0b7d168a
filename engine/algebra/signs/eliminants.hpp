// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomials by which a variable is eliminated: coefficients, discriminants, resultants and values, by
// FLINT.
#pragma once

#include "algebra/number/real_ball.hpp"
#include "algebra/ring/integer_polynomial.hpp"

#include <vector>

namespace resonform {

// sign * product of powers; the factors are irreducible and no numbers. sign = 0: the polynomial is zero.
struct FactoredPolynomial {
    struct Factor {
        Packed base;
        bool odd; // its power
    };
    int sign;
    std::vector<Factor> factors;
};

// All of these throw NoQuotient where FLINT gives up.
FactoredPolynomial factored(const Packed& p);
slong degree(const Packed& p, slong variable);                   // of 0: -1
std::vector<slong> variables_of(const std::vector<Packed>& all); // there is one
Packed coefficient(const Packed& p, slong variable, slong power);
Packed discriminant(const Packed& p, slong variable);
Packed resultant(const Packed& p, const Packed& q, slong variable);
// p at a value of one variable, times a positive number.
Packed value_at(const Packed& p, slong variable, const Rational& value);
int sign_of_number(const Packed& p); // precondition: p.is_constant()
// All real roots, in ascending order and apart from each other. Precondition: the polynomials are in this
// variable alone, and their product has no multiple root.
std::vector<RealBall> real_roots(const std::vector<Packed>& polynomials, slong variable);

} // namespace resonform
