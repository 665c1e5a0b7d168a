// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/cancellation.hpp"

#include "algebra/ring/integer_polynomial.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/products.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {
namespace {

using Ids = std::vector<GeneratorId>;

// Polynomials in some generators of a ring as those of FLINT, and back.
class Translation {
public:
    Translation(const Ring& ring, Ids ids) : ring_(ring), ids_(std::move(ids)), context_(ids_.size()) {}

    // Of p times the common denominator of its coefficients; nullopt: an exponent is negative.
    [[nodiscard]] std::optional<Packed> packed(const Polynomial& p) const {
        Packed result(context_);
        const Rational scale(denominator(p));
        std::vector<ulong> exponents(ids_.size());
        for (const Term& t : p.terms()) {
            for (std::size_t k = 0; k < ids_.size(); ++k) {
                const int exponent = ring_.exponent(t.monomial, ids_[k]);
                if (exponent < 0) return std::nullopt;
                exponents[k] = static_cast<ulong>(exponent);
            }
            Whole coefficient(cln::numerator(scale * t.coefficient));
            fmpz_mpoly_push_term_fmpz_ui(result.get(), coefficient.get(), exponents.data(), context_.get());
        }
        fmpz_mpoly_sort_terms(result.get(), context_.get());
        return result;
    }

    [[nodiscard]] Polynomial unpacked(const Packed& p) const {
        std::vector<Term> terms;
        std::vector<ulong> exponents(ids_.size());
        Whole coefficient;
        for (slong n = 0; n < p.terms(); ++n) {
            fmpz_mpoly_get_term_exp_ui(exponents.data(), p.get(), n, context_.get());
            fmpz_mpoly_get_term_coeff_fmpz(coefficient.get(), p.get(), n, context_.get());
            Monomial monomial;
            for (std::size_t k = 0; k < ids_.size(); ++k)
                monomial = monomial + ring_.monomial(ids_[k], static_cast<int>(exponents[k]));
            terms.push_back({monomial, coefficient.value()});
        }
        return Polynomial::from_terms(std::move(terms));
    }

    static Integer denominator(const Polynomial& p) {
        Integer result = 1;
        for (const Term& t : p.terms()) result = cln::lcm(result, cln::denominator(t.coefficient));
        return result;
    }

private:
    const Ring& ring_;
    Ids ids_;
    PolynomialContext context_;
};

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

// The greatest common divisor of `radicand` and of what stands in p beside each monomial in other generators;
// nullopt: a number.
std::optional<Polynomial> common_factor(const Ring& ring, const Polynomial& p, const Polynomial& radicand) {
    const auto [inside, outside] = divided_by_occurrence(ring, radicand);
    const Translation translation(ring, inside);
    std::optional<Packed> common = translation.packed(radicand);
    for (const auto& [outer, coefficient] : ring.collect(p, outside)) {
        const auto next = common ? translation.packed(coefficient) : std::nullopt;
        if (!next) return std::nullopt;
        common = common_divisor(*common, *next);
        if (common->is_constant()) return std::nullopt;
    }
    return translation.unpacked(*common);
}

// p/divisor, where the divisor has whole coefficients and divides what stands in p beside each monomial in
// other generators; these may have negative exponents.
Polynomial quotient(const Ring& ring, const Polynomial& p, const Polynomial& divisor) {
    const auto [inside, outside] = divided_by_occurrence(ring, divisor);
    const Translation translation(ring, inside);
    const Packed below = *translation.packed(divisor);
    std::vector<Term> terms;
    for (const auto& [outer, coefficient] : ring.collect(p, outside)) {
        const Rational number = Rational(1) / Translation::denominator(coefficient);
        const Polynomial part = translation.unpacked(translation.packed(coefficient)->divided_by(below));
        for (const Term& t : part.terms()) terms.push_back({outer + t.monomial, number * t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

// The number of which all coefficients are coprime whole multiples, with the sign of the last one.
Rational content(const Polynomial& p) {
    Integer numerators = 0;
    for (const Term& t : p.terms()) numerators = cln::gcd(numerators, cln::numerator(t.coefficient));
    const Rational size = Rational(numerators) / Translation::denominator(p);
    return p.terms().back().coefficient < 0 ? -size : size;
}

// With what roots are roots of in place of their whole powers, as numerators have it: s^2 - 4 k, where the
// ring has s^2 - 4 sqrt(k)^2.
Polynomial written_out(const Ring& ring, Polynomial p) {
    for (GeneratorId id = ring.size() - 1; id > 0; --id) {
        const Generator& g = ring.generator(id);
        const auto whole = [&](const Term& t) { return ring.exponent(t.monomial, id) >= g.index; };
        if (g.kind != GeneratorKind::root || std::none_of(p.terms().begin(), p.terms().end(), whole))
            continue;
        std::vector<Polynomial> parts;
        for (auto& [power, part] : ring.collect(p, {id})) {
            int exponent = ring.exponent(power, id);
            for (; exponent >= g.index; exponent -= g.index)
                part = plain_product(ring.packing(), part, g.radicand);
            parts.push_back(plain_product(ring.packing(), part, Polynomial(ring.monomial(id, exponent), 1)));
        }
        p = sum(parts);
    }
    return p;
}

// Takes what numerator and the radicand of a root below it have in common out of both. False: nothing.
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
    const Rational number = content(rest);
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

// Generators in p, and in what those of them that are roots are roots of.
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

// Takes the powers of one radicand out of what stands beside each monomial in other generators.
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
    // Adds the group to the result, the radicand to its highest power out of it. False: as it was.
    bool take_out(const Monomial& outer, std::vector<Term> inner) {
        int power = 0;
        Monomial beside = outer;
        if (inner.size() > 1 && divisor_) {
            const Polynomial group = Polynomial::from_terms(inner);
            std::optional<Packed> rest = translation_.packed(group);
            for (auto next = rest; rest && (next = rest->quotient_by(*divisor_)); ++power) rest = next;
            if (power > 0) {
                const Rational scale = cln::expt(number_, -power) / Translation::denominator(group);
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
    std::optional<Packed> divisor_ = translation_.packed(1 / number_ * radicand_);
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
