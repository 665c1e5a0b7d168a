// SPDX-License-Identifier: GPL-3.0-or-later
// A small polynomial in the leaves of a CoefficientGraph: a divisor, or an expanded coefficient's numerator.
//
//   -4 w1^2 w2 + 6 w1 w2^2  =  -2  *  w1 w2  *  (2 w1 - 3 w2)      (content, monomial, primitive part)
#pragma once

#include "algebra/number/number.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace resonform {

using LeafId = std::uint32_t;
using LeafPowers = std::vector<std::pair<LeafId, int>>; // ascending leaves, exponents > 0

class LeafPolynomial {
public:
    LeafPolynomial() = default;
    static LeafPolynomial leaf(LeafId id) { return LeafPolynomial(LeafPowers{{id, 1}}, 1); }
    LeafPolynomial(LeafPowers powers, const Rational& coefficient) { add(std::move(powers), coefficient); }

    void add(LeafPowers powers, const Rational& coefficient);
    [[nodiscard]] const std::map<LeafPowers, Rational>& terms() const { return terms_; }
    [[nodiscard]] bool empty() const { return terms_.empty(); }
    [[nodiscard]] int degree() const; // total, of the zero polynomial 0

    // this = content * monomial * primitive; primitive has integer coefficients without common factor, its
    // first term (in the order of terms()) is positive, and no leaf divides it.
    struct Parts;
    [[nodiscard]] Parts parts() const; // not of zero

    // For any type of numbers: power(leaf, exponent) and number(coefficient) give its values.
    template <class Value, class Power, class Number>
    [[nodiscard]] Value evaluate(Power power, Number number) const {
        Value total = number(Rational(0));
        for (const auto& [powers, coefficient] : terms_) {
            Value product = number(coefficient);
            for (const auto& [id, exponent] : powers) product = product * power(id, exponent);
            total = total + product;
        }
        return total;
    }

    friend bool operator==(const LeafPolynomial&, const LeafPolynomial&) = default;
    friend bool operator<(const LeafPolynomial& a, const LeafPolynomial& b) { return a.terms_ < b.terms_; }

private:
    std::map<LeafPowers, Rational> terms_; // no zero
};

struct LeafPolynomial::Parts {
    Rational content;
    LeafPowers monomial;
    LeafPolynomial primitive;
};

} // namespace resonform
