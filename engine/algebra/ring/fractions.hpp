// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of a polynomial over one common denominator: the form in which products are computed.
//
//   2/3 x - 5/4 y  ->  (8 x - 15 y)/12
//
// All numerators have the same number of limbs and lie side by side, so that the inner loop of a product
// meets neither fractions nor pointers. (CLN gives no access to limbs, GMP does.)
#pragma once

#include "algebra/ring/term.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace resonform {

struct Fractions {
    std::vector<Monomial> monomials;
    std::size_t limbs = 1;             // of each numerator
    std::vector<mp_limb_t> magnitudes; // size() * limbs, of each numerator the least significant first
    std::vector<std::uint8_t> negative;
    mpz_class denominator{1}; // > 0

    [[nodiscard]] std::size_t size() const { return monomials.size(); }
    [[nodiscard]] const mp_limb_t* magnitude(std::size_t k) const { return magnitudes.data() + k * limbs; }
    [[nodiscard]] std::size_t bits() const; // of the largest numerator
    // Appends a term with the numerator of term k of `from`. An empty sum takes over the number of limbs and
    // the denominator of `from`; later terms must have the same.
    void append(const Monomial& monomial, const Fractions& from, std::size_t k);
};

// factor * left * right
struct FractionProduct {
    const Fractions* left;
    const Fractions* right;
    Rational factor = 1;
};

// A number times the monomial 1.
Fractions constant_fraction(const Rational& value);

Fractions to_fractions(const std::vector<Term>& terms);
std::vector<Term> to_terms(const Fractions& f);

// Terms ascending by monomial, no common factor of all numerators and the denominator, as few limbs as
// possible. Precondition: different monomials, no zero numerator.
void make_canonical(Fractions& f);

} // namespace resonform
