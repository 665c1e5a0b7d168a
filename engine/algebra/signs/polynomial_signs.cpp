// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/signs/polynomial_signs.hpp"

#include "algebra/signs/eliminants.hpp"
#include "algebra/signs/open_cells.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr slong most_terms_of_factor = 60; // of an irreducible polynomial whose sign is asked

// The signs of a + b r with r >= 0, by those of a, b, r^2 and a^2 - b^2 r^2.
SignSet signs_of_sum(const SignSet& a, const SignSet& b, const SignSet& square, const SignSet& norm) {
    SignSet result;
    for (const int s : {-1, 0, 1})
        for (const int t : {-1, 0, 1})
            for (const int larger : {-1, 0, 1}) { // of a and b r
                if (!a.has(s) || !b.has(t) || !norm.has(larger)) continue;
                if (square.zero && larger == s * s) result.insert(s);
                if (square.positive && (s * t == 0 ? larger == s * s - t * t : true))
                    result.insert(s == t || larger > 0 ? s : larger < 0 ? t : 0);
            }
    return result;
}

} // namespace

PolynomialSigns::PolynomialSigns(const std::vector<Packed>& positive, std::vector<SquareRoot> roots)
    : roots_(std::move(roots)) {
    std::vector<FactoredPolynomial> open;
    for (const Packed& p : positive) {
        open.push_back(factored(p));
        Condition condition{Packed(p.context(), open.back().sign), {}};
        for (const auto& factor : open.back().factors) {
            if (factor.odd) condition.polynomial = condition.polynomial * factor.base;
            condition.factors.push_back(factor.base);
            learned(factor.base) = {true, false, true};
        }
        conditions_.push_back(std::move(condition));
    }
    for (std::size_t round = 0; round < open.size(); ++round)
        for (const FactoredPolynomial& condition : open) learn(condition);
}

SignSet& PolynomialSigns::learned(const Packed& q) {
    const auto found =
        std::find_if(learned_.begin(), learned_.end(), [&](const auto& known) { return known.first == q; });
    return found != learned_.end() ? found->second : learned_.emplace_back(q, SignSet::all()).second;
}

// If the sign of only one factor is unknown, it follows from the others.
void PolynomialSigns::learn(const FactoredPolynomial& condition) {
    SignSet others = SignSet::of(condition.sign);
    SignSet* open = nullptr;
    for (const auto& factor : condition.factors) {
        if (!factor.odd) continue;
        SignSet& signs = learned(factor.base);
        if (!signs.is_known() && open != nullptr) return;
        if (signs.is_known())
            others = others * signs;
        else
            open = &signs;
    }
    if (open != nullptr) *open = others;
}

SignSet PolynomialSigns::of(const Packed& p) {
    for (const Condition& c : conditions_) {
        if (c.polynomial.is_constant() && sign_of_number(c.polynomial) <= 0) return {};
        if (c.polynomial.is_constant() || p.is_zero()) continue;
        if (const auto rest = p.quotient_by(c.polynomial)) return of(*rest);
    }
    const FactoredPolynomial f = factored(p);
    SignSet known = SignSet::of(f.sign), open = SignSet::of(1);
    std::vector<Packed> factors;
    Packed together(p.context(), 1);
    for (const auto& factor : f.factors) {
        const SignSet signs = factor.odd ? of_factor(factor.base) : of_factor(factor.base).square();
        if (signs.is_known() || !factor.odd) {
            known = known * signs;
            continue;
        }
        open = open * signs;
        factors.push_back(factor.base);
        together = together * factor.base;
    }
    if (factors.size() > 1) { // (x - 1)*(x + 1) where x^2 - 2 > 0
        const SignSet joint = decide(together, factors, {open.negative, false, open.positive});
        if (!joint.empty()) open = {joint.negative, open.zero, joint.positive};
    }
    return known * open;
}

SignSet PolynomialSigns::of_factor(const Packed& q) {
    const auto found =
        std::find_if(decided_.begin(), decided_.end(), [&](const auto& known) { return known.first == q; });
    if (found != decided_.end()) return found->second;
    SignSet signs = learned(q);
    if (!signs.is_known()) signs = decide(q, {q}, signs);
    const auto root = std::find_if(roots_.rbegin(), roots_.rend(),
                                   [&](const SquareRoot& r) { return degree(q, r.variable) > 0; });
    const auto narrow = [&](const SignSet& by_other_means) {
        if (const SignSet both = signs & by_other_means; !both.empty()) signs = both; // else: no domain
    };
    if (!signs.is_known() && root != roots_.rend()) narrow(by_root(q, *root));
    if (!signs.is_known() && q.terms() > 1) narrow(by_fewer_variables(q));
    decided_.emplace_back(q, signs);
    return signs;
}

// x^2 - 2*x*y + y^2 + p*q where p*q > 0 is larger than without its last term. Left out are terms of one sign
// with a variable that no term of the other or of unknown sign has.
SignSet PolynomialSigns::by_fewer_variables(const Packed& q) {
    for (const int s : {-1, 1}) {
        std::vector<Packed> helpful;
        Packed rest(q.context());
        for (slong k = 0; k < q.terms(); ++k) {
            Packed term(q.context());
            fmpz_mpoly_get_term(term.get(), q.get(), k, q.context().get());
            const auto holds = [&](const SquareRoot& r) { return degree(term, r.variable) > 0; };
            if (std::any_of(roots_.begin(), roots_.end(), holds) || of(term).has(-s))
                rest = rest + term;
            else
                helpful.push_back(std::move(term));
        }
        const std::vector<slong> kept = variables_of({rest});
        SignSet left_out = SignSet::of(0);
        for (const Packed& term : helpful) {
            const std::vector<slong> own = variables_of({term});
            if (std::includes(kept.begin(), kept.end(), own.begin(), own.end()))
                rest = rest + term;
            else
                left_out = left_out + of(term);
        }
        if (rest == q) continue;
        if (const SignSet signs = of(rest); !signs.has(-s)) return signs + left_out;
    }
    return SignSet::all();
}

// q = a + b r with even powers of r in a and b.
SignSet PolynomialSigns::by_root(const Packed& q, const SquareRoot& root) {
    if (!of(root.below).is_positive()) return SignSet::all();
    Packed a(q.context()), b(q.context());
    const slong highest = degree(q, root.variable);
    for (slong k = 0; k <= highest; ++k) {
        const Packed part = coefficient(q, root.variable, k) * root.above.raised(static_cast<ulong>(k / 2)) *
                            root.below.raised(static_cast<ulong>(highest / 2 - k / 2));
        (k % 2 == 0 ? a : b) = (k % 2 == 0 ? a : b) + part;
    }
    const Packed norm = a * a * root.below + (b * b * root.above).negative();
    if (norm.terms() > most_terms_of_factor) return SignSet::all();
    return signs_of_sum(of(a), of(b), of(root.above), of(norm));
}

// By the conditions on its own variables, then by all that are linked with them. q is a product of `own`.
SignSet PolynomialSigns::decide(const Packed& q, const std::vector<Packed>& own, SignSet signs) {
    if (q.terms() > most_terms_of_factor) return signs;
    std::size_t before = conditions_.size() + 1;
    for (const bool through_others : {false, true}) {
        std::vector<Packed> conditions, factors = own;
        for (const Condition* condition : linked_with(q, through_others)) {
            conditions.push_back(condition->polynomial);
            factors.insert(factors.end(), condition->factors.begin(), condition->factors.end());
        }
        if (conditions.size() == before) break;
        before = conditions.size();
        auto on_cells = signs_on_open_cells(q, conditions, factors);
        if (!on_cells || on_cells->empty()) break;
        if (signs.zero && !on_cells->zero) on_cells->zero = !vanishes_only_where_it_changes(q);
        signs = signs & *on_cells;
        if (signs.is_known()) break;
    }
    return signs;
}

std::vector<const PolynomialSigns::Condition*> PolynomialSigns::linked_with(const Packed& q,
                                                                            bool through_others) const {
    std::vector<slong> reached = variables_of({q});
    const auto is_linked = [&](const std::vector<slong>& own) {
        const auto is_reached = [&](slong v) {
            return std::find(reached.begin(), reached.end(), v) != reached.end();
        };
        return through_others ? std::any_of(own.begin(), own.end(), is_reached)
                              : std::all_of(own.begin(), own.end(), is_reached);
    };
    std::vector<const Condition*> result;
    for (std::size_t before = 1; before != result.size();) {
        before = result.size();
        for (const Condition& c : conditions_) {
            if (c.factors.empty() || std::find(result.begin(), result.end(), &c) != result.end()) continue;
            const std::vector<slong> own = variables_of(c.factors);
            if (!is_linked(own)) continue;
            result.push_back(&c);
            reached.insert(reached.end(), own.begin(), own.end());
        }
    }
    return result;
}

// At a zero around which q does not change its sign its slopes are zero, too: so is its discriminant, or,
// where q = a*x + b, so are a and b.
bool PolynomialSigns::vanishes_only_where_it_changes(const Packed& q) {
    std::vector<Packed> zero_there;
    for (const slong v : variables_of({q})) {
        if (degree(q, v) > 1) {
            zero_there.push_back(discriminant(q, v));
            continue;
        }
        zero_there.push_back(coefficient(q, v, 1));
        zero_there.push_back(coefficient(q, v, 0));
    }
    std::stable_sort(zero_there.begin(), zero_there.end(),
                     [](const Packed& a, const Packed& b) { return a.terms() < b.terms(); });
    return std::any_of(zero_there.begin(), zero_there.end(), [this](const Packed& p) { return !of(p).zero; });
}

} // namespace resonform
