// SPDX-License-Identifier: GPL-3.0-or-later
// Rational expressions as quotients of coprime polynomials, by FLINT: GiNaC's normal() is too slow here (200
// s for three links), FLINT's gcd is not.
#pragma once

#include "algebra/ring/integer_polynomial.hpp"

#include <ginac/ginac.h>

#include <optional>
#include <vector>

namespace resonform {

// symbol^index = value, a polynomial with integer coefficients.
struct PowerRelation {
    GiNaC::symbol symbol;
    int index;
    GiNaC::ex value;
};

struct PolynomialQuotient {
    GiNaC::ex numerator, denominator; // expanded, with integer coefficients
};

// A rational expression in the symbols as a quotient, lowered by the relations, the last ones first (a value
// holds earlier symbols). A denominator of 0 is left to the caller. nullopt: e is not rational in the
// symbols, or too large.
std::optional<PolynomialQuotient> polynomial_quotient(const GiNaC::ex& e,
                                                      const std::vector<GiNaC::symbol>& symbols,
                                                      const std::vector<PowerRelation>& relations);

// The same in FLINT's form, of a context whose variables are the symbols and pi. Throws NoQuotient.
struct PackedQuotient {
    Packed above, below;
};
PackedQuotient packed_quotient(const GiNaC::ex& e, const std::vector<GiNaC::symbol>& symbols,
                               const std::vector<PowerRelation>& relations, const PolynomialContext& context);

// Is its numerator zero by the relations? Common factors are left, so that this is cheaper. nullopt: as
// above, or the denominator is zero.
std::optional<bool> quotient_is_zero(const GiNaC::ex& e, const std::vector<GiNaC::symbol>& symbols,
                                     const std::vector<PowerRelation>& relations);

} // namespace resonform
