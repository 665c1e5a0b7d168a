// SPDX-License-Identifier: GPL-3.0-or-later
// A (Laurent) polynomial in the generators of a Ring with rational coefficients. It is passive data;
// everything that needs the meaning of the exponents (products, relations, derivatives) is asked of
// the Ring.
#pragma once

#include "algebra/number/number.hpp"
#include "algebra/ring/term.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace resonform {

struct Fractions;
class Packing;

// Invariant: terms strictly ascending by monomial key, no zero coefficient. Copies share their content.
// It is held as terms, or as fractions over a common denominator, or both: each is made from the other
// when it is first asked for, which several threads may do at once.
class Polynomial {
public:
    Polynomial() = default;
    explicit Polynomial(const Rational& constant); // the monomial with all exponents zero
    Polynomial(const Monomial& monomial, const Rational& coefficient);

    // Takes terms in any order, adds equal monomials, drops zeros. No relation is applied.
    static Polynomial from_terms(std::vector<Term> terms);
    // Takes different monomials in any order, no zero numerator.
    static Polynomial from_fractions(Fractions fractions);

    [[nodiscard]] const std::vector<Term>& terms() const&;
    [[nodiscard]] std::vector<Term> terms() && { return std::as_const(*this).terms(); } // safe in a range-for
    [[nodiscard]] const Fractions& fractions() const;                                   // canonical
    [[nodiscard]] bool empty() const { return body_ == nullptr; }
    [[nodiscard]] std::size_t size() const;

    friend bool operator==(const Polynomial& a, const Polynomial& b);

private:
    struct Body;
    std::shared_ptr<const Body> body_; // null: zero
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a);
Polynomial operator*(const Rational& c, const Polynomial& p);

// The sum of many polynomials, collected once.
Polynomial sum(const std::vector<Polynomial>& summands);
// sum_k c_k p_k
Polynomial combination(const std::vector<std::pair<Rational, const Polynomial*>>& addends);
// left * right, checked; no relation is applied.
Polynomial plain_product(const Packing& packing, const Polynomial& left, const Polynomial& right);

// p/m; exponents are not checked.
Polynomial divided(const Polynomial& p, const Monomial& m);

// The largest number of which all coefficients are whole multiples.
Rational content(const Polynomial& p);

} // namespace resonform
