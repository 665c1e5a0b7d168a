// SPDX-License-Identifier: GPL-3.0-or-later
// A (Laurent) polynomial in the generators of a Ring with rational coefficients. It is passive data;
// everything that needs the meaning of the exponents (products, relations, derivatives) is asked of
// the Ring.
#pragma once

#include "algebra/monomial.hpp"
#include "algebra/number.hpp"

#include <utility>
#include <vector>

namespace resonform {

struct Term {
    Monomial monomial;
    Rational coefficient;

    friend bool operator==(const Term& a, const Term& b) {
        return a.monomial == b.monomial && a.coefficient == b.coefficient;
    }
};

// Invariant: terms strictly ascending by monomial key, no zero coefficient.
class Polynomial {
public:
    Polynomial() = default;
    explicit Polynomial(const Rational& constant); // the monomial with all exponents zero
    Polynomial(const Monomial& monomial, const Rational& coefficient);

    // Takes terms in any order, adds equal monomials, drops zeros. No relation is applied.
    static Polynomial from_terms(std::vector<Term> terms);

    [[nodiscard]] const std::vector<Term>& terms() const& { return terms_; }
    [[nodiscard]] std::vector<Term> terms() && { return std::move(terms_); } // safe in a range-for
    [[nodiscard]] bool empty() const { return terms_.empty(); }
    [[nodiscard]] std::size_t size() const { return terms_.size(); }

    friend bool operator==(const Polynomial&, const Polynomial&) = default;

private:
    std::vector<Term> terms_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a);
Polynomial operator*(const Rational& c, const Polynomial& p);

// The sum of many polynomials, collected once.
Polynomial sum(const std::vector<Polynomial>& summands);

} // namespace resonform
