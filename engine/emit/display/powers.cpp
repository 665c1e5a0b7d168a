// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/powers.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

bool is_function(const DisplayFactor& factor, const char* name) {
    return factor.kind == DisplayFactor::Kind::function && factor.name == name;
}

bool is_exponential(const DisplayFactor& factor) { return is_function(factor, "exp"); }

void add_like_terms(DisplaySum& sum, const DisplayTerm& term) {
    const auto like = std::find_if(sum.terms.begin(), sum.terms.end(),
                                   [&](const DisplayTerm& t) { return same_but_coefficient(t, term); });
    if (like == sum.terms.end()) {
        sum.terms.push_back(term);
        return;
    }
    like->coefficient = like->coefficient + term.coefficient;
    if (cln::zerop(like->coefficient)) sum.terms.erase(like);
}

// The sum of exponent * argument over all exponentials.
DisplaySum whole_exponent(const std::vector<DisplayFactor>& factors) {
    DisplaySum whole;
    for (const DisplayFactor& factor : factors) {
        if (!is_exponential(factor)) continue;
        for (DisplayTerm term : factor.arguments.front().terms) {
            term.coefficient = term.coefficient * factor.exponent;
            add_like_terms(whole, term);
        }
    }
    return whole;
}

// c * log(u) with c free of logarithms?
bool is_logarithm(const DisplayTerm& term) {
    const auto logs = std::count_if(term.factors.begin(), term.factors.end(),
                                    [](const DisplayFactor& f) { return is_function(f, "log"); });
    return logs == 1 && !term.imaginary && term.tail.empty() &&
           std::any_of(term.factors.begin(), term.factors.end(),
                       [](const DisplayFactor& f) { return is_function(f, "log") && f.exponent == 1; });
}

// u as the base of a power: tau itself, or a sum in parentheses.
DisplayFactor base_of(const DisplaySum& u) {
    if (u.terms.size() == 1) {
        const DisplayTerm& term = u.terms.front();
        if (term.coefficient == 1 && !term.imaginary && term.tail.empty() && term.factors.size() == 1 &&
            term.factors.front().exponent == 1)
            return term.factors.front();
    }
    return sum_factor(u);
}

// exp(c log(u)) = u^c
DisplayFactor power_of(DisplayTerm term) {
    const auto log = std::find_if(term.factors.begin(), term.factors.end(),
                                  [](const DisplayFactor& f) { return is_function(f, "log"); });
    DisplayFactor base = base_of(log->arguments.front());
    term.factors.erase(log);
    if (term.factors.empty()) {
        base.exponent = term.coefficient;
        return base;
    }
    DisplayFactor power;
    power.kind = DisplayFactor::Kind::power;
    power.arguments = {factor_sum(std::move(base)), DisplaySum{{std::move(term)}}};
    return power;
}

void multiply(std::vector<DisplayFactor>& factors, DisplayFactor factor) {
    const auto like = std::find_if(factors.begin(), factors.end(), [&](const DisplayFactor& f) {
        return f.kind != DisplayFactor::Kind::power && same_base(f, factor);
    });
    if (like == factors.end()) {
        factors.push_back(std::move(factor));
        return;
    }
    like->exponent = like->exponent + factor.exponent;
    if (cln::zerop(like->exponent)) factors.erase(like);
}

} // namespace

bool has_exponential(const DisplayTerm& term) {
    return std::any_of(term.factors.begin(), term.factors.end(), is_exponential);
}

DisplayTerm with_powers(const DisplayTerm& term) {
    DisplayTerm result = term;
    if (!has_exponential(term)) return result;
    auto& factors = result.factors;
    const auto place = std::find_if(factors.begin(), factors.end(), is_exponential) - factors.begin();
    factors.erase(std::remove_if(factors.begin(), factors.end(), is_exponential), factors.end());
    DisplaySum exponent = whole_exponent(term.factors), rest;
    for (const DisplayTerm& part : exponent.terms)
        if (!is_logarithm(part)) rest.terms.push_back(part);
    if (!rest.terms.empty()) factors.insert(factors.begin() + place, function_factor("exp", std::move(rest)));
    for (DisplayTerm& part : exponent.terms)
        if (is_logarithm(part)) multiply(factors, power_of(std::move(part)));
    return result;
}

} // namespace resonform
