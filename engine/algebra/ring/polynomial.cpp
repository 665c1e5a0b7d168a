// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/polynomial.hpp"

#include "algebra/ring/fractions.hpp"
#include "algebra/ring/products.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace resonform {
namespace {

bool by_monomial(const Term& a, const Term& b) { return a.monomial < b.monomial; }

// Sorted, equal monomials added, zeros dropped.
void collect(std::vector<Term>& terms) {
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
}

// Made by whoever asks first; of threads that ask at once one is believed. (A std::once_flag costs a system
// call for every polynomial.)
template <class Form> class Later {
public:
    Later() = default;
    Later(const Later&) = delete;
    Later& operator=(const Later&) = delete;
    ~Later() { delete made_.load(std::memory_order_relaxed); }

    template <class Make> const Form& get(const Make& make) {
        if (const Form* known = made_.load(std::memory_order_acquire)) return *known;
        auto own = std::make_unique<const Form>(make());
        const Form* other = nullptr;
        if (!made_.compare_exchange_strong(other, own.get(), std::memory_order_acq_rel)) return *other;
        return *own.release();
    }

private:
    std::atomic<const Form*> made_{nullptr};
};

} // namespace

// Whichever form it was made with is there from the start.
struct Polynomial::Body {
    explicit Body(std::vector<Term> t) : made_with_terms(true), terms(std::move(t)) {}
    explicit Body(Fractions f) : made_with_terms(false), fractions(std::move(f)) {}

    bool made_with_terms;
    std::vector<Term> terms;
    Fractions fractions;
    mutable Later<std::vector<Term>> later_terms;
    mutable Later<Fractions> later_fractions;
};

Polynomial::Polynomial(const Rational& constant) : Polynomial(Monomial{}, constant) {}

Polynomial::Polynomial(const Monomial& monomial, const Rational& coefficient) {
    if (!cln::zerop(coefficient))
        body_ = std::make_shared<const Body>(std::vector<Term>{{monomial, coefficient}});
}

Polynomial Polynomial::from_terms(std::vector<Term> terms) {
    collect(terms);
    Polynomial p;
    if (!terms.empty()) p.body_ = std::make_shared<const Body>(std::move(terms));
    return p;
}

Polynomial Polynomial::from_fractions(Fractions fractions) {
    Polynomial p;
    if (fractions.size() == 0) return p;
    make_canonical(fractions);
    p.body_ = std::make_shared<const Body>(std::move(fractions));
    return p;
}

const std::vector<Term>& Polynomial::terms() const& {
    static const std::vector<Term> none;
    if (!body_) return none;
    if (body_->made_with_terms) return body_->terms;
    return body_->later_terms.get([&] { return to_terms(body_->fractions); });
}

const Fractions& Polynomial::fractions() const {
    static const Fractions none;
    if (!body_) return none;
    if (!body_->made_with_terms) return body_->fractions;
    return body_->later_fractions.get([&] { return to_fractions(body_->terms); });
}

std::size_t Polynomial::size() const {
    if (!body_) return 0;
    return body_->made_with_terms ? body_->terms.size() : body_->fractions.size();
}

bool operator==(const Polynomial& a, const Polynomial& b) {
    return a.body_ == b.body_ || a.terms() == b.terms();
}

Polynomial combination(const std::vector<std::pair<Rational, const Polynomial*>>& addends) {
    std::vector<const std::pair<Rational, const Polynomial*>*> present;
    for (const auto& addend : addends)
        if (!addend.second->empty() && !cln::zerop(addend.first)) present.push_back(&addend);
    if (present.empty()) return {};
    if (present.size() == 1 && present.front()->first == 1) return *present.front()->second;
    const Fractions one = constant_fraction(1);
    std::vector<FractionProduct> products;
    products.reserve(present.size());
    for (const auto* addend : present)
        products.push_back({&addend->second->fractions(), &one, addend->first});
    return Polynomial::from_fractions(sum_of_products(products));
}

Polynomial plain_product(const Packing& packing, const Polynomial& left, const Polynomial& right) {
    const std::vector<FractionProduct> products{{&left.fractions(), &right.fractions()}};
    require_safe(packing, products);
    return Polynomial::from_fractions(sum_of_products(products, &packing));
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    if (a.empty()) return b;
    return b.empty() ? a : combination({{1, &a}, {1, &b}});
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return b.empty() ? a : combination({{1, &a}, {-1, &b}});
}

Polynomial operator-(const Polynomial& a) { return combination({{-1, &a}}); }

Polynomial operator*(const Rational& c, const Polynomial& p) { return combination({{c, &p}}); }

Polynomial sum(const std::vector<Polynomial>& summands) {
    std::vector<std::pair<Rational, const Polynomial*>> addends;
    for (const Polynomial& p : summands) addends.emplace_back(1, &p);
    return combination(addends);
}

Polynomial divided(const Polynomial& p, const Monomial& m) {
    if (m == Monomial{}) return p;
    Fractions f = p.fractions();
    for (Monomial& monomial : f.monomials) monomial = monomial - m;
    return Polynomial::from_fractions(std::move(f));
}

} // namespace resonform
