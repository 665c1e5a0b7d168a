// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/choose_relation.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/products.hpp"

#include <algorithm>
#include <cstddef>

namespace resonform {
namespace {

bool holds(const Ring& ring, const Polynomial& p, GeneratorId id) {
    return std::any_of(p.terms().begin(), p.terms().end(),
                       [&](const Term& t) { return ring.exponent(t.monomial, id) != 0; });
}

bool is_lead(const std::vector<Relation>& relations, GeneratorId id) {
    return std::any_of(relations.begin(), relations.end(), [id](const Relation& r) { return r.lead == id; });
}

// Whether m is invertible, the generator `except` left out (-1: none).
bool invertible_but(const Ring& ring, const Monomial& m, GeneratorId except) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (id != except && ring.exponent(m, id) != 0 && !ring.generator(id).invertible) return false;
    }
    return true;
}

// sigma^index = coefficient * monomial.
struct Binomial {
    int index;
    Rational coefficient;
    Monomial monomial;
};

// Takes the largest root of both sides that exists: sigma^4 = 4 r^2 becomes sigma^2 = 2 r (r > 0).
Binomial simplest(const Ring& ring, const Binomial& b) {
    const std::vector<int> exponents = ring.exponents(b.monomial);
    for (int f = b.index; f > 1; --f) {
        if (b.index % f != 0) continue;
        bool divisible = true;
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const int e = exponents[static_cast<std::size_t>(id)];
            divisible = divisible && (e == 0 || (e % f == 0 && ring.generator(id).positive));
        }
        Rational root;
        if (!divisible || !cln::plusp(b.coefficient) || !exact_root(b.coefficient, f, root)) continue;
        std::vector<int> reduced = exponents;
        for (int& e : reduced) e /= f;
        return {b.index / f, root, ring.monomial(reduced)};
    }
    return b;
}

// The generator that sigma^index = coefficient * monomial eliminates, or -1: its exponent is positive, all
// others are invertible. The lowest exponent is preferred, then a generator that is no root.
GeneratorId eliminated_by(const Ring& ring, const std::vector<Relation>& before, const Binomial& b) {
    GeneratorId best = -1;
    int best_cost = 0;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const int e = ring.exponent(b.monomial, id);
        if (e <= 0 || is_lead(before, id) || !invertible_but(ring, b.monomial, id)) continue;
        const int cost = 2 * (e - 1) + (ring.generator(id).kind == GeneratorKind::root ? 1 : 0);
        if (best < 0 || cost < best_cost) best = id, best_cost = cost;
    }
    return best;
}

std::optional<Relation> of_one_term(const Ring& ring, const std::vector<Relation>& before, GeneratorId root,
                                    const Term& radicand) {
    if (radicand.monomial == Monomial{} && !cln::plusp(radicand.coefficient)) {
        refuse({.rule = "a root is taken of what is positive",
                .value = "a root of " + to_string(radicand.coefficient),
                .hint = "check the sign under the root",
                .place = {}});
    }
    const Binomial b = simplest(ring, {ring.generator(root).index, radicand.coefficient, radicand.monomial});
    Relation relation;
    relation.total = true;
    relation.lead = root;
    relation.degree = b.index;
    relation.value = Polynomial(b.monomial, b.coefficient);
    // A root of index 1 of a symbol not declared to be non-zero replaces that symbol, and is invertible.
    const bool known_unit = b.index == 1 && invertible_but(ring, b.monomial, -1);
    if (known_unit || b.monomial == Monomial{}) return relation;
    const GeneratorId x = eliminated_by(ring, before, b);
    if (x < 0) {
        relation.total = false;
        return relation;
    }
    relation.lead = x;
    relation.degree = ring.exponent(b.monomial, x);
    const Monomial others = b.monomial - ring.monomial(x, relation.degree);
    relation.value = Polynomial(ring.monomial(root, b.index) - others, cln::recip(b.coefficient));
    return relation;
}

// radicand = c x^d + lower in x, with c one term and a unit: the terms by their degree in x.
struct Leading {
    int degree = 0;
    Term coefficient;
};

std::optional<Leading> leading_in(const Ring& ring, const Polynomial& radicand, GeneratorId x) {
    Leading top;
    int count = 0;
    for (const Term& t : radicand.terms()) {
        const int e = ring.exponent(t.monomial, x);
        if (e > top.degree) {
            top = {e, {t.monomial - ring.monomial(x, e), t.coefficient}};
            count = 1;
        } else if (e == top.degree) {
            ++count;
        }
    }
    if (top.degree == 0 || count != 1 || !invertible_but(ring, top.coefficient.monomial, -1))
        return std::nullopt;
    return top;
}

// Whether rewriting p can bring x in: p holds the lead of a rule whose value holds x, and so on. The
// rules in use have no cycle but a lead in its own value (`from`), so this ends.
bool leads_to(const Ring& ring, const std::vector<Relation>& relations, const Polynomial& p, GeneratorId x,
              const Relation* from = nullptr) {
    return std::any_of(relations.begin(), relations.end(), [&](const Relation& r) {
        if (r.total || &r == from || !holds(ring, p, r.lead)) return false;
        return holds(ring, r.value, x) || leads_to(ring, relations, r.value, x, &r);
    });
}

// x^d -> (sigma^k - lower)/c.
Relation solved_for(const Ring& ring, GeneratorId x, const Leading& top, const Polynomial& power,
                    const Polynomial& radicand) {
    const Monomial removed = ring.monomial(x, top.degree) + top.coefficient.monomial;
    const Polynomial lower = radicand - Polynomial(removed, top.coefficient.coefficient);
    const Polynomial reciprocal(ring.packing().scaled(top.coefficient.monomial, -1),
                                cln::recip(top.coefficient.coefficient));
    const Polynomial difference = power - lower;
    Relation relation;
    relation.lead = x;
    relation.degree = top.degree;
    relation.value = plain_product(ring.packing(), difference, reciprocal);
    return relation;
}

// sigma^k -> radicand; power is sigma^k as the earlier rules write it, perhaps rho^(2k).
std::optional<Relation> expanding(const Ring& ring, const std::vector<Relation>& before,
                                  const Polynomial& power, const Polynomial& radicand) {
    if (power.size() != 1) return std::nullopt;
    const Term& t = power.terms().front();
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const int e = ring.exponent(t.monomial, id);
        if (e <= 0 || ring.monomial(id, e) != t.monomial || is_lead(before, id)) continue;
        Relation relation;
        relation.lead = id;
        relation.degree = e;
        relation.value = cln::recip(t.coefficient) * radicand;
        return relation;
    }
    return std::nullopt;
}

} // namespace

std::optional<Relation> choose_relation(const Ring& ring, const std::vector<Relation>& before,
                                        GeneratorId id) {
    const Polynomial radicand = ring.reduce(ring.generator(id).radicand);
    if (radicand.empty()) {
        refuse({.rule = "a root is not taken of zero",
                .value = ring.generator(id).name,
                .hint = "check the expression under the root",
                .place = {}});
    }
    if (radicand.size() == 1) return of_one_term(ring, before, id, radicand.terms().front());

    const Polynomial power =
        ring.reduce(Polynomial(ring.monomial(id, ring.generator(id).index), Rational(1)));
    for (const GeneratorKind kind :
         {GeneratorKind::slow, GeneratorKind::parameter, GeneratorKind::function}) {
        for (GeneratorId x = 0; x < ring.size(); ++x) {
            const Generator& g = ring.generator(x);
            if (g.kind != kind || g.invertible || is_lead(before, x)) continue;
            if (leads_to(ring, before, radicand, x)) continue;
            const std::optional<Leading> top = leading_in(ring, radicand, x);
            if (top) return solved_for(ring, x, *top, power, radicand);
        }
    }
    return expanding(ring, before, power, radicand);
}

std::optional<Relation> solve_for_one_of(const Ring& ring, const std::vector<Relation>& before,
                                         const Polynomial& p, const std::vector<GeneratorId>& candidates) {
    for (const bool invertible : {false, true}) {
        for (const GeneratorId x : candidates) {
            if (ring.generator(x).invertible != invertible || is_lead(before, x)) continue;
            if (leads_to(ring, before, p, x)) continue;
            if (const std::optional<Leading> top = leading_in(ring, p, x))
                return solved_for(ring, x, *top, Polynomial(), p);
        }
    }
    return std::nullopt;
}

} // namespace resonform
