// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/relation.hpp"

#include "algebra/accumulator.hpp"
#include "algebra/error.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace resonform {
namespace {

// Relations of a ring terminate by construction (RingBuilder::freeze); nested roots of unforeseen
// shape are stopped here instead of hanging.
constexpr int most_rounds = 1000;

int floor_quotient(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

// lead^e = lead^(e mod degree) value^(e div degree), for a value of one term.
void apply_monomial(const Packing& packing, const Relation& relation, std::vector<Term>& terms) {
    const Term& value = relation.value.terms().front();
    for (Term& t : terms) {
        if (!relation.applies(packing, t.monomial)) continue;
        const int q = floor_quotient(packing.exponent(t.monomial, relation.lead), relation.degree);
        t.monomial = t.monomial - packing.power(relation.lead, static_cast<long>(q) * relation.degree) +
                     packing.scaled(value.monomial, q);
        packing.require_safe(t.monomial);
        t.coefficient = t.coefficient * cln::expt(value.coefficient, Integer(q));
    }
}

// From the highest power of lead downwards: lead^e -> lead^(e - degree) value, equal terms collected
// before they are rewritten, so that each power is expanded once.
void apply_polynomial(const Packing& packing, const Relation& relation, std::vector<Term>& terms) {
    std::map<int, Accumulator> high; // exponent of lead -> terms
    Accumulator low;
    const auto place = [&](const Monomial& m, const Rational& c) {
        packing.require_safe(m);
        const int e = packing.exponent(m, relation.lead);
        (e < relation.degree ? low : high[e]).add(m, c);
    };
    for (const Term& t : terms) place(t.monomial, t.coefficient);
    const Monomial removed = packing.power(relation.lead, relation.degree);
    while (!high.empty()) {
        const auto top = std::prev(high.end());
        const std::vector<Term> rewritten = top->second.take();
        high.erase(top);
        for (const Term& t : rewritten) {
            if (cln::zerop(t.coefficient)) continue;
            for (const Term& v : relation.value.terms()) {
                place(t.monomial - removed + v.monomial, t.coefficient * v.coefficient);
            }
        }
    }
    terms = low.take();
}

// Whether the relation applied to any term.
bool apply(const Packing& packing, const Relation& relation, std::vector<Term>& terms) {
    const bool needed = std::any_of(terms.begin(), terms.end(),
                                    [&](const Term& t) { return relation.applies(packing, t.monomial); });
    if (!needed) return false;
    if (relation.total) {
        apply_monomial(packing, relation, terms);
    } else {
        apply_polynomial(packing, relation, terms);
    }
    return true;
}

} // namespace

std::vector<Term> rewrite(const Packing& packing, const std::vector<Relation>& relations,
                          std::vector<Term> terms) {
    for (const Term& t : terms) packing.require_safe(t.monomial);
    for (int round = 0; round < most_rounds; ++round) {
        bool changed = false;
        for (const Relation& relation : relations) changed = apply(packing, relation, terms) || changed;
        if (!changed) return terms;
    }
    refuse({.rule = "the relations between the roots lead to a unique form",
            .value = "rewriting does not end",
            .mend = "write nested roots as single roots of higher index",
            .place = {}});
}

} // namespace resonform
