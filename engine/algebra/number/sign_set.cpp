// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/sign_set.hpp"

#include <algorithm>

namespace resonform {

namespace {

UnivariatePolynomial without_leading_zeros(UnivariatePolynomial p) {
    while (!p.empty() && cln::zerop(p.back())) p.pop_back();
    return p;
}

int sign_of(const Rational& r) { return cln::plusp(r) ? 1 : cln::minusp(r) ? -1 : 0; }

int sign_at_point(const UnivariatePolynomial& p, const Rational& x) {
    Rational value = 0;
    for (auto c = p.rbegin(); c != p.rend(); ++c) value = value * x + *c;
    return sign_of(value);
}

UnivariatePolynomial slope_of(const UnivariatePolynomial& p) {
    UnivariatePolynomial slope;
    for (std::size_t k = 1; k < p.size(); ++k) slope.push_back(static_cast<unsigned long>(k) * p[k]);
    return slope;
}

// Times a positive number, so that the coefficients are coprime integers.
UnivariatePolynomial whole_multiple(UnivariatePolynomial p) {
    Integer numerators = 0, denominators = 1;
    for (const Rational& c : p) {
        numerators = cln::gcd(numerators, cln::numerator(c));
        denominators = cln::lcm(denominators, cln::denominator(c));
    }
    if (!p.empty())
        for (Rational& c : p) c = c * denominators / numerators;
    return p;
}

struct DividedPolynomial {
    UnivariatePolynomial quotient, rest;
};

DividedPolynomial long_division(UnivariatePolynomial p, const UnivariatePolynomial& by) {
    DividedPolynomial result;
    if (p.size() >= by.size()) result.quotient.resize(p.size() - by.size() + 1);
    while (p.size() >= by.size()) {
        const std::size_t shift = p.size() - by.size();
        const Rational factor = p.back() / by.back();
        result.quotient[shift] = factor;
        for (std::size_t k = 0; k < by.size(); ++k) p[shift + k] = p[shift + k] - factor * by[k];
        p.pop_back(); // its coefficient is zero now
        p = without_leading_zeros(std::move(p));
    }
    result.rest = std::move(p);
    return result;
}

UnivariatePolynomial convolution(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
    UnivariatePolynomial product(a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k) product[i + k] = product[i + k] + a[i] * b[k];
    return product;
}

// p, p', and the negatives of what is left in turn; the last one is the common divisor of p and p'.
std::vector<UnivariatePolynomial> sturm_chain(const UnivariatePolynomial& p) {
    std::vector<UnivariatePolynomial> chain{whole_multiple(p), whole_multiple(slope_of(p))};
    while (!chain.back().empty()) {
        UnivariatePolynomial rest = whole_multiple(long_division(chain[chain.size() - 2], chain.back()).rest);
        for (Rational& c : rest) c = -c;
        chain.push_back(std::move(rest));
    }
    chain.pop_back();
    return chain;
}

// With each root once. p is no constant.
UnivariatePolynomial squarefree(const UnivariatePolynomial& p) {
    return whole_multiple(long_division(p, sturm_chain(p).back()).quotient);
}

// Points that are no roots, with one real root between neighbours, none outside.
class RootSeparation {
public:
    explicit RootSeparation(const UnivariatePolynomial& p) : p_(p), chain_(sturm_chain(p)) {
        const Rational bound = bound_of_roots();
        points_.push_back(-bound);
        separate(-bound, bound, changes_at(-bound) - changes_at(bound));
    }

    [[nodiscard]] const std::vector<Rational>& points() const { return points_; }

private:
    [[nodiscard]] Rational bound_of_roots() const {
        Rational largest = 0;
        for (const Rational& c : p_) largest = std::max(largest, cln::abs(c / p_.back()));
        return largest + 1;
    }

    [[nodiscard]] int changes_at(const Rational& x) const {
        int changes = 0, last = 0;
        for (const UnivariatePolynomial& p : chain_) {
            const int sign = sign_at_point(p, x);
            if (sign != 0 && sign == -last) ++changes;
            if (sign != 0) last = sign;
        }
        return changes;
    }

    void separate(const Rational& low, const Rational& high, int roots) {
        if (roots == 0) return;
        if (roots == 1) return points_.push_back(high);
        Rational between = (low + high) / 2;
        while (sign_at_point(p_, between) == 0) between = (low + between) / 2; // as often as there are roots
        const int below = changes_at(low) - changes_at(between);
        separate(low, between, below);
        separate(between, high, roots - below);
    }

    const UnivariatePolynomial& p_;
    std::vector<UnivariatePolynomial> chain_;
    std::vector<Rational> points_;
};

// One of the polynomials, with what its signs at roots are told by.
struct SignedPolynomial {
    UnivariatePolynomial polynomial, simple; // simple: with each root once

    // At the only root of any of them between two points.
    [[nodiscard]] int sign_between(const Rational& low, const Rational& high) const {
        return sign_at_point(simple, low) != sign_at_point(simple, high) ? 0
                                                                         : sign_at_point(polynomial, high);
    }
};

SignedPolynomial with_signs(UnivariatePolynomial p) {
    p = without_leading_zeros(std::move(p));
    UnivariatePolynomial simple = p.size() > 1 ? squarefree(p) : p;
    return {std::move(p), std::move(simple)};
}

} // namespace

SignSet signs_where(const UnivariatePolynomial& p, const std::vector<SignCondition>& conditions) {
    const SignedPolynomial asked = with_signs(p);
    std::vector<SignedPolynomial> given;
    for (const SignCondition& c : conditions) given.push_back(with_signs(c.polynomial));
    UnivariatePolynomial all{0, 1}; // has a root for sure
    if (asked.simple.size() > 1) all = convolution(all, asked.simple);
    for (const SignedPolynomial& c : given)
        if (c.simple.size() > 1) all = convolution(all, c.simple);
    all = squarefree(all);
    const std::vector<Rational> points = RootSeparation(all).points();
    SignSet found;
    const auto look = [&](const auto& sign) {
        for (std::size_t k = 0; k < given.size(); ++k)
            if (const int s = sign(given[k]); s < 0 || (s == 0 && conditions[k].strict)) return;
        found.insert(sign(asked));
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
        look([&](const SignedPolynomial& s) { return sign_at_point(s.polynomial, points[k]); });
        if (k > 0) look([&](const SignedPolynomial& s) { return s.sign_between(points[k - 1], points[k]); });
    }
    return found;
}

} // namespace resonform
