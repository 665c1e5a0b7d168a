// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/relation.hpp"

#include "algebra/number/error.hpp"
#include "algebra/ring/products.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

namespace resonform {
namespace {

// Relations of a ring terminate by construction (RingBuilder::freeze); nested roots of unforeseen
// shape are stopped here instead of hanging.
constexpr int most_rounds = 1000;

int floor_quotient(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

bool applies_anywhere(const Packing& packing, const Relation& relation, const Fractions& f) {
    return std::any_of(f.monomials.begin(), f.monomials.end(),
                       [&](const Monomial& m) { return relation.applies(packing, m); });
}

// value^q; q < 0 only for a value of one term.
Fractions power_of_value(const Packing& packing, const Polynomial& value, int q) {
    if (q < 0) {
        const Term& t = value.terms().front();
        return to_fractions({{packing.scaled(t.monomial, q), cln::expt(t.coefficient, Integer(q))}});
    }
    Fractions result = constant_fraction(1);
    for (int k = 0; k < q; ++k) {
        const std::vector<FractionProduct> product{{&result, &value.fractions()}};
        require_safe(packing, product);
        result = sum_of_products(product, &packing);
    }
    return result;
}

// The value is a monomial or its negative, as for i^2 = -1 and g = G^2: terms are rewritten one by one.
bool is_signed_monomial(const Polynomial& value) {
    const Fractions& f = value.fractions();
    return f.size() == 1 && f.limbs == 1 && f.magnitudes.front() == 1 && f.denominator == 1;
}

int quotient_of(const Packing& packing, const Relation& relation, const Monomial& m) {
    return relation.applies(packing, m) ? floor_quotient(packing.exponent(m, relation.lead), relation.degree)
                                        : 0;
}

Fractions apply_to_terms(const Packing& packing, const Relation& relation, Fractions f) {
    const Fractions& value = relation.value.fractions();
    for (std::size_t k = 0; k < f.size(); ++k) {
        Monomial& m = f.monomials[k];
        const int q = quotient_of(packing, relation, m);
        if (q == 0) continue;
        m = m - packing.power(relation.lead, static_cast<long>(q) * relation.degree);
        const Monomial by = packing.scaled(value.monomials.front(), q);
        packing.require_safe(m);
        packing.require_safe(by);
        m = m + by;
        if (q % 2 != 0) f.negative[k] ^= value.negative.front();
    }
    return collected(f);
}

// f = sum_q lead^(degree q) f_q  ->  sum_q value^q f_q
Fractions apply(const Packing& packing, const Relation& relation, const Fractions& f) {
    std::map<int, Fractions> groups; // f_q by q
    for (std::size_t k = 0; k < f.size(); ++k) {
        const Monomial& m = f.monomials[k];
        const int q = quotient_of(packing, relation, m);
        groups[q].append(
            q == 0 ? m : m - packing.power(relation.lead, static_cast<long>(q) * relation.degree), f, k);
    }
    std::deque<Fractions> powers; // a deque leaves them in their places
    std::vector<FractionProduct> products;
    for (const auto& [q, group] : groups) {
        powers.push_back(power_of_value(packing, relation.value, q));
        products.push_back({&group, &powers.back()});
    }
    require_safe(packing, products);
    return sum_of_products(products, &packing);
}

} // namespace

bool is_reduced(const Packing& packing, const std::vector<Relation>& relations, const Fractions& f) {
    return std::none_of(relations.begin(), relations.end(),
                        [&](const Relation& r) { return applies_anywhere(packing, r, f); });
}

Fractions rewrite(const Packing& packing, const std::vector<Relation>& relations, Fractions f) {
    for (const Monomial& m : f.monomials) packing.require_safe(m);
    for (int round = 0; round < most_rounds; ++round) {
        bool changed = false;
        for (const Relation& relation : relations) {
            if (!applies_anywhere(packing, relation, f)) continue;
            f = is_signed_monomial(relation.value) ? apply_to_terms(packing, relation, std::move(f))
                                                   : apply(packing, relation, f);
            for (const Monomial& m : f.monomials) packing.require_safe(m);
            changed = true;
        }
        if (!changed) return f;
    }
    refuse({.rule = "the relations between the roots lead to a unique form",
            .value = "rewriting does not end",
            .hint = "write nested roots as single roots of higher index",
            .place = {}});
}

} // namespace resonform
