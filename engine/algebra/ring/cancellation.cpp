// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/cancellation.hpp"

#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/products.hpp"
#include "algebra/ring/translation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {
namespace {

using Ids = std::vector<GeneratorId>;

// Generators in p; the others.
std::pair<Ids, Ids> divided_by_occurrence(const Ring& ring, const Polynomial& p) {
    std::pair<Ids, Ids> result;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const bool inside = std::any_of(p.terms().begin(), p.terms().end(),
                                        [&](const Term& t) { return ring.exponent(t.monomial, id) != 0; });
        (inside ? result.first : result.second).push_back(id);
    }
    return result;
}

// Whether no generator divides p.
bool is_free_of_monomials(const Ring& ring, const Polynomial& p, const Ids& inside) {
    return std::all_of(inside.begin(), inside.end(),
                       [&](GeneratorId id) { return ring.lowest_exponent(p, id) == 0; });
}

// The greatest common divisor of `radicand` and all coefficients of p over the generators that `radicand`
// does not hold; nullopt: a number.
std::optional<Polynomial> common_factor(const Ring& ring, const Polynomial& p, const Polynomial& radicand) {
    const auto [inside, outside] = divided_by_occurrence(ring, radicand);
    const auto coefficients = ring.collect(p, outside);
    const bool of_one_term = std::any_of(coefficients.begin(), coefficients.end(),
                                         [](const auto& c) { return c.second.size() == 1; });
    if (of_one_term && is_free_of_monomials(ring, radicand, inside)) return std::nullopt;
    const Translation translation(ring, inside);
    std::optional<Packed> common = translation.packed(radicand);
    for (const auto& [outer, coefficient] : coefficients) {
        const auto next = common ? translation.packed(coefficient) : std::nullopt;
        if (!next) return std::nullopt;
        common = common_divisor(*common, *next);
        if (common->is_constant()) return std::nullopt;
    }
    return translation.unpacked(*common);
}

// p/divisor, where the divisor divides all coefficients of p over the generators that it does not hold; these
// may have negative exponents.
Polynomial quotient(const Ring& ring, const Polynomial& p, const Polynomial& divisor) {
    const auto [inside, outside] = divided_by_occurrence(ring, divisor);
    const Translation translation(ring, inside);
    const Packed below = *translation.packed(divisor);
    std::vector<Term> terms;
    for (const auto& [outer, coefficient] : ring.collect(p, outside)) {
        const Rational number = content(coefficient) / content(divisor);
        const Polynomial part = translation.unpacked(translation.packed(coefficient)->divided_by(below));
        for (const Term& t : part.terms()) terms.push_back({outer + t.monomial, number * t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

// With the sign of the last coefficient.
Rational signed_content(const Polynomial& p) {
    return p.terms().back().coefficient < 0 ? -content(p) : content(p);
}

// Writes whole powers of all roots out by their radicands, as numerators have it: s^2 - 4 k, where the ring
// has s^2 - 4 sqrt(k)^2.
Polynomial written_out(const Ring& ring, Polynomial p) {
    for (GeneratorId id = ring.size() - 1; id > 0; --id)
        if (ring.generator(id).kind == GeneratorKind::root) p = written_out(ring, p, id);
    return p;
}

// Cancels the common factor of the numerator and the radicand of a root below it. False: nothing cancelled.
bool cancel_once(const Ring& ring, GeneratorId root, Fraction& f) {
    const Generator& g = ring.generator(root);
    const int below = -ring.exponent(f.factor, root);
    if (below <= 0 || f.numerator.empty()) return false;
    const Polynomial radicand = written_out(ring, g.radicand);
    const auto common = common_factor(ring, f.numerator, radicand);
    if (!common) return false;
    const Polynomial rest = quotient(ring, radicand, *common);
    if (rest.size() > 1 && below < g.index) return false;
    f.factor = f.factor + ring.monomial(root, g.index);
    f.numerator = quotient(ring, f.numerator, *common);
    const Rational number = signed_content(rest);
    f.numerator = 1 / number * f.numerator;
    if (rest.size() > 1)
        f.divisors.push_back(1 / number * rest);
    else
        f.factor = f.factor - rest.terms().front().monomial;
    return true;
}

// Whether terms are known to have the same sign.
bool keeps_clear_of_zero(const Ring& ring, const Polynomial& p) {
    const auto positive = [&](const Monomial& m) {
        for (GeneratorId id = 0; id < ring.size(); ++id)
            if (ring.exponent(m, id) % 2 != 0 && !ring.generator(id).positive) return false;
        return true;
    };
    return std::all_of(p.terms().begin(), p.terms().end(), [&](const Term& t) {
        return positive(t.monomial) && (t.coefficient > 0) == (p.terms().front().coefficient > 0);
    });
}

// The generators in p, in the radicands of the roots among them, and so on.
Ids written_out_of(const Ring& ring, const Polynomial& p) {
    Ids ids = divided_by_occurrence(ring, p).first;
    for (std::size_t k = 0; k < ids.size(); ++k)
        if (const Generator& g = ring.generator(ids[k]); g.kind == GeneratorKind::root) {
            const Ids more = divided_by_occurrence(ring, g.radicand).first;
            ids.insert(ids.end(), more.begin(), more.end());
        }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

using Split = std::vector<std::pair<Monomial, Term>>; // outer and inner part, sorted by the outer one

Split split(const Ring& ring, const Polynomial& p, const Ids& inside) {
    Split terms;
    for (const Term& t : p.terms()) {
        const Monomial inner = ring.restricted(t.monomial, inside);
        terms.push_back({t.monomial - inner, {inner, t.coefficient}});
    }
    std::stable_sort(terms.begin(), terms.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return terms;
}

// Whether a group of terms with one outer part may be a multiple of the radicand: of two terms at least, and
// in no generator with a smaller difference of exponents.
bool may_hold(const Ring& ring, const Split& terms, const Ids& inside, const Polynomial& radicand) {
    const auto width = [&](auto begin, auto end, GeneratorId id, const auto& monomial) {
        int low = ring.exponent(monomial(*begin), id), high = low;
        for (auto t = begin; t != end; ++t) {
            low = std::min(low, ring.exponent(monomial(*t), id));
            high = std::max(high, ring.exponent(monomial(*t), id));
        }
        return high - low;
    };
    const auto of_term = [](const Term& t) { return t.monomial; };
    const auto of_pair = [](const auto& t) { return t.second.monomial; };
    for (auto group = terms.begin(); group != terms.end();) {
        const auto end =
            std::find_if(group, terms.end(), [&](const auto& t) { return !(t.first == group->first); });
        if (end - group > 1 && std::all_of(inside.begin(), inside.end(), [&](GeneratorId id) {
                return width(group, end, id, of_pair) >=
                       width(radicand.terms().begin(), radicand.terms().end(), id, of_term);
            }))
            return true;
        group = end;
    }
    return false;
}

// Takes the powers of one radicand out of the coefficients over the generators that it does not hold.
class PowersApart {
public:
    PowersApart(const Ring& ring, GeneratorId root, Ids inside)
        : ring_(ring), root_(root), inside_(std::move(inside)) {}

    Polynomial operator()(const Polynomial& p, const Split& terms) {
        bool found = false;
        for (auto group = terms.begin(); group != terms.end();) {
            const auto end =
                std::find_if(group, terms.end(), [&](const auto& t) { return !(t.first == group->first); });
            std::vector<Term> inner;
            for (auto t = group; t != end; ++t) inner.push_back(t->second);
            found = take_out(group->first, std::move(inner)) || found;
            group = end;
        }
        return found ? Polynomial::from_terms(std::move(result_)) : p;
    }

private:
    // Adds the group to the result, with the highest power of the radicand taken out. False: there is none.
    bool take_out(const Monomial& outer, std::vector<Term> inner) {
        int power = 0;
        Monomial beside = outer;
        if (inner.size() > 1 && divisor_) {
            const Polynomial group = Polynomial::from_terms(inner);
            std::optional<Packed> rest = translation_.packed(group);
            for (auto next = rest; rest && (next = rest->quotient_by(*divisor_)); ++power) rest = next;
            if (power > 0) {
                const Rational scale = cln::expt(number_, -power) * content(group);
                beside = outer + ring_.monomial(root_, ring_.generator(root_).index * power);
                inner = (scale * translation_.unpacked(*rest)).terms();
            }
        }
        for (const Term& t : inner) result_.push_back({beside + t.monomial, t.coefficient});
        return power > 0;
    }

    const Ring& ring_;
    GeneratorId root_;
    Ids inside_;
    Polynomial radicand_ = written_out(ring_, ring_.generator(root_).radicand);
    Rational number_ = content(radicand_);
    Translation translation_{ring_, inside_};
    std::optional<Packed> divisor_ = translation_.packed(radicand_);
    std::vector<Term> result_;
};

} // namespace

Polynomial radicands_apart(const Ring& ring, Polynomial numerator) {
    for (GeneratorId id = ring.size() - 1; id > 0 && numerator.size() > 1; --id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::root || g.radicand.size() < 2) continue;
        const Ids inside = written_out_of(ring, g.radicand);
        const Split terms = split(ring, numerator, inside);
        if (may_hold(ring, terms, inside, g.radicand) && !keeps_clear_of_zero(ring, g.radicand))
            numerator = PowersApart(ring, id, inside)(numerator, terms);
    }
    return numerator;
}

Fraction cancelled(const Ring& ring, const Monomial& factor, Polynomial numerator) {
    Fraction result{factor, std::move(numerator), {}};
    for (GeneratorId id = ring.size() - 1; id > 0; --id)
        if (ring.generator(id).kind == GeneratorKind::root && ring.generator(id).radicand.size() > 1)
            while (cancel_once(ring, id, result)) continue;
    return result;
}

Polynomial cancelled(const Ring& ring, const Polynomial& p) {
    if (ring.is_canonical()) return p;
    std::vector<Polynomial> parts;
    for (const auto& [factor, numerator] : ring.expanded_form(p)) {
        Fraction f = cancelled(ring, factor, numerator);
        if (!f.divisors.empty()) f = {factor, numerator, {}};
        parts.push_back(ring.multiply(ring.reduce(Polynomial(f.factor, 1)), ring.reduce(f.numerator)));
    }
    return sum(parts);
}

} // namespace resonform
