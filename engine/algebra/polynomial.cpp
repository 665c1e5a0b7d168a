// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/polynomial.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace resonform {
namespace {

bool by_monomial(const Term& a, const Term& b) { return a.monomial < b.monomial; }

// a + sign b, for sign = 1 or -1.
Polynomial merge(const Polynomial& a, const Polynomial& b, bool subtract) {
    const std::vector<Term>&left = a.terms(), &right = b.terms();
    std::vector<Term> out;
    out.reserve(left.size() + right.size());
    std::size_t i = 0, j = 0;
    while (i < left.size() || j < right.size()) {
        if (j == right.size() || (i < left.size() && left[i].monomial < right[j].monomial)) {
            out.push_back(left[i++]);
        } else if (i == left.size() || right[j].monomial < left[i].monomial) {
            out.push_back({right[j].monomial, subtract ? -right[j].coefficient : right[j].coefficient});
            ++j;
        } else {
            const Rational c = subtract ? left[i].coefficient - right[j].coefficient
                                        : left[i].coefficient + right[j].coefficient;
            if (!cln::zerop(c)) out.push_back({left[i].monomial, c});
            ++i, ++j;
        }
    }
    return Polynomial::from_terms(std::move(out));
}

} // namespace

Polynomial::Polynomial(const Rational& constant) : Polynomial(Monomial{}, constant) {}

Polynomial::Polynomial(const Monomial& monomial, const Rational& coefficient) {
    if (!cln::zerop(coefficient)) terms_.push_back({monomial, coefficient});
}

Polynomial Polynomial::from_terms(std::vector<Term> terms) {
    if (!std::is_sorted(terms.begin(), terms.end(), by_monomial)) {
        std::sort(terms.begin(), terms.end(), by_monomial);
    }
    std::size_t kept = 0; // terms[0 .. kept) are final but for the coefficient of the last
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (kept > 0 && terms[kept - 1].monomial == terms[i].monomial) {
            terms[kept - 1].coefficient = terms[kept - 1].coefficient + terms[i].coefficient;
            continue;
        }
        if (kept > 0 && cln::zerop(terms[kept - 1].coefficient)) --kept;
        if (kept != i) terms[kept] = std::move(terms[i]);
        ++kept;
    }
    if (kept > 0 && cln::zerop(terms[kept - 1].coefficient)) --kept;
    terms.resize(kept);
    Polynomial p;
    p.terms_ = std::move(terms);
    return p;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return merge(a, b, false);
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    if (b.empty()) return a;
    return merge(a, b, true);
}

Polynomial operator-(const Polynomial& a) { return Rational(-1) * a; }

Polynomial operator*(const Rational& c, const Polynomial& p) {
    if (cln::zerop(c)) return {};
    std::vector<Term> terms = p.terms();
    for (Term& t : terms) t.coefficient = c * t.coefficient;
    return Polynomial::from_terms(std::move(terms));
}

Polynomial sum(const std::vector<Polynomial>& summands) {
    std::vector<Term> terms;
    for (const Polynomial& p : summands) terms.insert(terms.end(), p.terms().begin(), p.terms().end());
    return Polynomial::from_terms(std::move(terms));
}

} // namespace resonform
