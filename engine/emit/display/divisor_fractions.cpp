// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/divisor_fractions.hpp"

#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/products.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using Ids = std::vector<GeneratorId>;
using TermsOver = std::map<Monomial, std::vector<Term>>;

bool is_root(const Ring& ring, GeneratorId id) { return ring.generator(id).kind == GeneratorKind::root; }

// The newest first: its radicand may hold the others.
Ids divisors_in(const Ring& ring, const Polynomial& p) {
    Ids ids;
    for (GeneratorId id = ring.size() - 1; id > 0; --id)
        if (is_root(ring, id) && ring.generator(id).index == 1 &&
            std::any_of(p.terms().begin(), p.terms().end(),
                        [&](const Term& t) { return ring.exponent(t.monomial, id) != 0; }))
            ids.push_back(id);
    return ids;
}

// Generators whose powers never meet when radicands are written out.
Ids outside_of_radicands(const Ring& ring) {
    std::vector<bool> inside(static_cast<std::size_t>(ring.size()), false);
    for (GeneratorId root = 0; root < ring.size(); ++root)
        if (is_root(ring, root))
            for (const Term& t : ring.generator(root).radicand.terms())
                for (GeneratorId id = 0; id < root; ++id)
                    if (ring.exponent(t.monomial, id) != 0) inside[static_cast<std::size_t>(id)] = true;
    Ids ids;
    for (GeneratorId id = 1; id < ring.size(); ++id)
        if (!is_root(ring, id) && !inside[static_cast<std::size_t>(id)]) ids.push_back(id);
    return ids;
}

// p = divisor^lowest * numerator; nullopt: of more terms than `most`.
std::optional<std::pair<Monomial, Polynomial>> over_lowest_power(const Ring& ring, const Polynomial& p,
                                                                 GeneratorId divisor, std::size_t most) {
    std::map<int, std::vector<Term>, std::greater<>> by_power;
    for (const Term& t : p.terms()) {
        const int e = ring.exponent(t.monomial, divisor);
        by_power[e].push_back({t.monomial - ring.monomial(divisor, e), t.coefficient});
    }
    Polynomial numerator;
    int power = by_power.begin()->first;
    for (auto& [e, terms] : by_power) {
        for (; power > e; --power) {
            numerator = plain_product(ring.packing(), numerator, ring.generator(divisor).radicand);
            if (numerator.size() > most) return std::nullopt;
        }
        numerator = numerator + Polynomial::from_terms(std::move(terms));
    }
    return std::pair(ring.monomial(divisor, power), std::move(numerator));
}

std::optional<Fraction> fraction(const Ring& ring, const Polynomial& p, const Ids& divisors) {
    const std::size_t most = 2 * p.size() + 8;
    std::pair<Monomial, Polynomial> result{{}, p};
    for (const GeneratorId divisor : divisors) {
        auto next = over_lowest_power(ring, result.second, divisor, most);
        if (!next) return std::nullopt;
        result = {result.first + next->first, std::move(next->second)};
        if (result.second.empty()) break;
    }
    return cancelled(ring, result.first, std::move(result.second));
}

void add(TermsOver& sum, const Monomial& over, const Polynomial& numerator, const Monomial& times) {
    for (const Term& t : numerator.terms()) sum[over].push_back({t.monomial + times, t.coefficient});
}

void add_term_by_term(const Ring& ring, const Polynomial& p, const Ids& divisors, const Monomial& times,
                      TermsOver& sum) {
    for (const Term& t : p.terms()) {
        const Monomial over = ring.restricted(t.monomial, divisors);
        sum[over].push_back({t.monomial - over + times, t.coefficient});
    }
}

} // namespace

std::vector<Fraction> divisor_fractions(const Ring& ring, const Polynomial& p) {
    const Ids divisors = divisors_in(ring, p);
    if (divisors.empty()) return {{{}, p, {}}};
    TermsOver sum;
    std::vector<Fraction> result;
    for (const auto& [outer, coefficient] : ring.collect(p, outside_of_radicands(ring))) {
        auto one = fraction(ring, coefficient, divisors);
        if (!one) {
            add_term_by_term(ring, coefficient, divisors, outer, sum);
        } else if (one->divisors.empty()) {
            add(sum, one->factor, one->numerator, outer);
        } else {
            one->factor = one->factor + outer;
            result.push_back(std::move(*one));
        }
    }
    for (auto& [over, terms] : sum) result.push_back({over, Polynomial::from_terms(std::move(terms)), {}});
    return result;
}

std::vector<Fraction> reduced_fractions(const Ring& ring, const Polynomial& p) {
    std::vector<Fraction> reduced;
    for (const Fraction& part : divisor_fractions(ring, p))
        for (const auto& [outer, above] : ring.expanded_form(part.numerator)) {
            Fraction f = cancelled(ring, outer, above);
            f.factor = f.factor + part.factor;
            f.divisors.insert(f.divisors.end(), part.divisors.begin(), part.divisors.end());
            f.numerator = radicands_apart(ring, std::move(f.numerator));
            reduced.push_back(std::move(f));
        }
    return reduced;
}

} // namespace resonform
