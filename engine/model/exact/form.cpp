// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/form.hpp"

#include "algebra/number/error.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

#include <algorithm>

namespace resonform {

using GiNaC::ex;

namespace {

// p with symbol^index = value put in, as far as it goes.
ex lowered(const ex& p, const GiNaC::symbol& symbol, int index, const ex& value) {
    const int degree = p.degree(symbol);
    if (degree < index) return p;
    ex result = 0;
    for (int k = 0; k <= degree; ++k)
        result += p.coeff(symbol, k) * GiNaC::pow(value, k / index) * GiNaC::pow(symbol, k % index);
    return result.expand();
}

} // namespace

void ExactForm::add(const GiNaC::symbol& symbol, Kind kind) {
    generators_.push_back({symbol, symbol, kind, symbol.get_name(), Generator::Relation::none, 0, 0});
}

const ExactForm::Generator* ExactForm::find(const ex& meaning) const {
    const auto found = std::find_if(generators_.begin(), generators_.end(),
                                    [&](const Generator& g) { return g.meaning.is_equal(meaning); });
    return found == generators_.end() ? nullptr : &*found;
}

ExactForm::Generator& ExactForm::add(const ex& meaning, std::string text) {
    GiNaC::symbol symbol(text);
    generators_.push_back(
        {symbol, meaning, kind_of(meaning), std::move(text), Generator::Relation::none, 0, 0});
    return generators_.back();
}

// A function moves if something in it does.
ExactForm::Kind ExactForm::kind_of(const ex& meaning) const {
    const bool moves = std::any_of(generators_.begin(), generators_.end(), [&](const Generator& g) {
        return g.kind <= Kind::rate && g.relation == Generator::Relation::none && meaning.has(g.symbol);
    });
    return moves ? Kind::moving : Kind::constant;
}

ex ExactForm::meaning(const ex& e) const {
    GiNaC::exmap meanings;
    for (const Generator& g : generators_)
        if (!g.meaning.is_equal(g.symbol)) meanings[g.symbol] = g.meaning;
    return e.subs(meanings, GiNaC::subs_options::no_pattern);
}

bool ExactForm::positive(const ex& e) const { return SignProver(*domain_).signs(meaning(e)).is_positive(); }

// Later generators first: their relations hold earlier ones.
ex ExactForm::reduced(ex polynomial) const {
    polynomial = polynomial.expand();
    for (auto g = generators_.rbegin(); g != generators_.rend(); ++g)
        if (g->relation != Generator::Relation::none)
            polynomial = lowered(polynomial, g->symbol, g->index, g->value);
    return polynomial;
}

// 1/(a + b*root) = (a - b*root)/(a^2 - b^2*root^2), and 1/root^k = root^(index - k)/base.
void ExactForm::make_rational(Fraction& f) const {
    for (auto g = generators_.rbegin(); g != generators_.rend(); ++g) {
        if (g->relation != Generator::Relation::root || !f.denominator.has(g->symbol)) continue;
        const int low = f.denominator.ldegree(g->symbol), high = f.denominator.degree(g->symbol);
        if (low != high && g->index != 2) continue;
        const ex factor =
            low == high
                ? ex(GiNaC::pow(g->symbol, g->index - low))
                : ex(f.denominator.coeff(g->symbol, 0) - f.denominator.coeff(g->symbol, 1) * g->symbol);
        f.numerator = reduced(f.numerator * factor);
        f.denominator = reduced(f.denominator * factor);
    }
}

std::vector<GiNaC::symbol> ExactForm::symbols() const {
    std::vector<GiNaC::symbol> all;
    for (const Generator& g : generators_) all.push_back(g.symbol);
    return all;
}

std::vector<PowerRelation> ExactForm::relations() const {
    std::vector<PowerRelation> all;
    for (const Generator& g : generators_)
        if (g.relation != Generator::Relation::none) all.push_back({g.symbol, g.index, g.value});
    return all;
}

ExactForm::Fraction ExactForm::quotient(const ex& rational) const {
    if (const auto q = polynomial_quotient(rational, symbols(), relations()))
        return {q->numerator, q->denominator};
    const ex parts = rational.numer_denom(); // complex numbers, fractions in a relation
    Fraction lowered{reduced(parts.op(0)), reduced(parts.op(1))};
    if (lowered.numerator.is_zero() || lowered.denominator.is_zero()) return lowered;
    const ex coprime = (lowered.numerator / lowered.denominator).numer_denom();
    return {coprime.op(0).expand(), coprime.op(1).expand()};
}

ExactForm::Fraction ExactForm::fraction(const ex& e) {
    Fraction f = quotient(converted(e));
    const bool has_root = std::any_of(generators_.begin(), generators_.end(), [&](const Generator& g) {
        return g.relation == Generator::Relation::root && f.denominator.has(g.symbol);
    });
    if (has_root) {
        make_rational(f);
        if (!f.denominator.is_zero()) f = quotient(f.numerator / f.denominator);
    }
    if (f.denominator.is_zero())
        bad_input({"a denominator is zero", excerpt(spell(e)), "correct the expression", place_});
    if (f.numerator.is_zero()) return {0, 1};
    // The sign is that of the first term of the denominator.
    const ex denominator = GiNaC::is_a<GiNaC::add>(f.denominator) ? canonical_sign(meaning(f.denominator))
                                                                  : meaning(f.denominator);
    if (denominator.is_equal(meaning(f.denominator))) return f;
    return {(-f.numerator).expand(), (-f.denominator).expand()};
}

ex ExactForm::simplified(const ex& e) {
    const Fraction f = fraction(e);
    return meaning(f.numerator) / meaning(f.denominator);
}

Zero ExactForm::vanishes(const ex& e) {
    const ex rational = converted(e);
    const std::optional<bool> zero = quotient_is_zero(rational, symbols(), relations());
    if (zero ? *zero : fraction(e).numerator.is_zero()) return Zero::yes;
    return resonform::vanishes(e) == Zero::no ? Zero::no : Zero::unknown;
}

} // namespace resonform
