// SPDX-License-Identifier: GPL-3.0-or-later
// Building and factoring display sums; nothing here knows a ring.
#include "emit/display/display.hpp"

#include "algebra/number/functions.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace resonform {

namespace {

bool same_sum(const DisplaySum& a, const DisplaySum& b);

bool same_factor(const DisplayFactor& a, const DisplayFactor& b) {
    return same_base(a, b) && a.exponent == b.exponent;
}

bool same_factors(const std::vector<DisplayFactor>& a, const std::vector<DisplayFactor>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_factor);
}

bool same_sum(const DisplaySum& a, const DisplaySum& b) {
    return std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(),
                      [](const DisplayTerm& s, const DisplayTerm& t) {
                          return s.coefficient == t.coefficient && same_but_coefficient(s, t);
                      });
}

// The smallest exponent of a base over all terms, 0 for a term that is free of it: its exponent in the common
// factor above the fraction bar, or in the common denominator.
Rational common_exponent(const DisplaySum& sum, const DisplayFactor& base) {
    Rational least = base.exponent;
    for (const DisplayTerm& term : sum.terms) {
        const auto it = std::find_if(term.factors.begin(), term.factors.end(),
                                     [&](const DisplayFactor& f) { return same_base(f, base); });
        const Rational exponent = it == term.factors.end() ? Rational(0) : it->exponent;
        if (exponent < least) least = exponent;
    }
    return least;
}

void divide(DisplayTerm& term, const DisplayFactor& divisor) {
    const auto it = std::find_if(term.factors.begin(), term.factors.end(),
                                 [&](const DisplayFactor& f) { return same_base(f, divisor); });
    if (it == term.factors.end()) {
        term.factors.insert(term.factors.begin(), divisor);
        term.factors.front().exponent = -divisor.exponent;
        return;
    }
    it->exponent = it->exponent - divisor.exponent;
    if (cln::zerop(it->exponent)) term.factors.erase(it);
}

// Every base that occurs, in the order of its first occurrence.
std::vector<DisplayFactor> bases_of(const DisplaySum& sum) {
    std::vector<DisplayFactor> bases;
    for (const DisplayTerm& term : sum.terms)
        for (const DisplayFactor& factor : term.factors)
            if (std::none_of(bases.begin(), bases.end(),
                             [&](const DisplayFactor& base) { return same_base(base, factor); }))
                bases.push_back(factor);
    return bases;
}

// The rational content, with the sign of the first term; `i` too when all terms have it. Rounded numbers have
// none.
void take_coefficient(DisplaySum& sum, DisplayTerm& content) {
    cln::cl_I numerators = 0, denominators = 1;
    if (sum.terms.front().digits > 0) return;
    content.imaginary = true;
    for (const DisplayTerm& term : sum.terms) {
        numerators = cln::gcd(numerators, cln::numerator(term.coefficient));
        denominators = cln::lcm(denominators, cln::denominator(term.coefficient));
        content.imaginary = content.imaginary && term.imaginary;
    }
    content.coefficient = Rational(numerators) / denominators;
    if (cln::minusp(sum.terms.front().coefficient)) content.coefficient = -content.coefficient;
    for (DisplayTerm& term : sum.terms) {
        term.coefficient = term.coefficient / content.coefficient;
        if (content.imaginary) term.imaginary = false;
    }
}

} // namespace

bool same_base(const DisplayFactor& a, const DisplayFactor& b) {
    return a.kind == b.kind && a.name == b.name && a.primes == b.primes && a.number == b.number &&
           std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(),
                      same_sum);
}

bool same_but_coefficient(const DisplayTerm& a, const DisplayTerm& b) {
    return a.imaginary == b.imaginary && same_factors(a.factors, b.factors) && same_factors(a.tail, b.tail);
}

DisplayFactor symbol_factor(const std::string& name, const Rational& exponent) {
    DisplayFactor factor;
    const std::size_t primes = name.size() - (name.find_last_not_of('\'') + 1);
    factor.name = name.substr(0, name.size() - primes);
    factor.primes = static_cast<int>(primes);
    factor.exponent = exponent;
    return factor;
}

DisplayFactor sum_factor(DisplaySum sum, const Rational& exponent) {
    DisplayFactor factor;
    factor.kind = DisplayFactor::Kind::sum;
    factor.arguments = {std::move(sum)};
    factor.exponent = exponent;
    return factor;
}

DisplayFactor integral_factor(std::vector<DisplaySum> of) {
    DisplayFactor factor;
    factor.kind = DisplayFactor::Kind::integral;
    factor.arguments = std::move(of);
    return factor;
}

DisplayFactor function_factor(const std::string& name, DisplaySum argument) {
    DisplayFactor factor;
    factor.kind = DisplayFactor::Kind::function;
    factor.name = name;
    factor.arguments.push_back(std::move(argument));
    return factor;
}

bool is_elementary(const DisplayFactor& function) {
    return function_called(function.name) || function.name == "conj" || function.name == "Re" ||
           function.name == "Im";
}

DisplaySum factor_sum(DisplayFactor factor) {
    DisplayTerm term;
    term.factors.push_back(std::move(factor));
    return term_sum(std::move(term));
}

DisplaySum term_sum(DisplayTerm term) {
    DisplaySum sum;
    sum.terms.push_back(std::move(term));
    return sum;
}

DisplaySum symbol_sum(const std::string& name) { return factor_sum(symbol_factor(name)); }

DisplaySum function_of(const std::string& function, const std::string& name) {
    return factor_sum(function_factor(function, symbol_sum(name)));
}

DisplaySum number_sum(const Rational& value) {
    DisplaySum sum;
    if (cln::zerop(value)) return sum;
    sum.terms.emplace_back();
    sum.terms.front().coefficient = value;
    return sum;
}

DisplaySum operator+(DisplaySum a, const DisplaySum& b) {
    a.terms.insert(a.terms.end(), b.terms.begin(), b.terms.end());
    return a;
}

DisplaySum operator-(DisplaySum a) {
    for (DisplayTerm& term : a.terms) term.coefficient = -term.coefficient;
    return a;
}

void insert_sum(std::vector<DisplayFactor>& factors, DisplaySum sum) {
    const auto place = std::find_if(factors.begin(), factors.end(), [](const DisplayFactor& factor) {
        return factor.kind != DisplayFactor::Kind::symbol && factor.kind != DisplayFactor::Kind::number;
    });
    factors.insert(place, sum_factor(std::move(sum)));
}

bool is_bare_sum(const DisplayTerm& term) {
    return term.coefficient == 1 && !term.imaginary && term.tail.empty() && term.factors.size() == 1 &&
           term.factors.front().kind == DisplayFactor::Kind::sum && term.factors.front().exponent == 1;
}

DisplayTerm factored(DisplaySum sum) {
    if (sum.terms.size() == 1) return std::move(sum.terms.front());
    DisplayTerm content;
    if (sum.terms.empty()) {
        content.coefficient = 0;
        return content;
    }
    take_coefficient(sum, content);
    for (DisplayFactor common : bases_of(sum)) {
        common.exponent = common_exponent(sum, common);
        if (cln::zerop(common.exponent)) continue;
        for (DisplayTerm& term : sum.terms) divide(term, common);
        content.factors.push_back(std::move(common));
    }
    insert_sum(content.factors, std::move(sum));
    return content;
}

} // namespace resonform
