// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/leaf_polynomial.hpp"

#include <algorithm>

namespace resonform {

namespace {

int degree_of(const LeafPowers& powers) {
    int degree = 0;
    for (const auto& power : powers) degree += power.second;
    return degree;
}

int exponent_of(const LeafPowers& powers, LeafId leaf) {
    for (const auto& [id, exponent] : powers)
        if (id == leaf) return exponent;
    return 0;
}

// Exponents of `from` lowered by those of `by`.
LeafPowers quotient(const LeafPowers& from, const LeafPowers& by) {
    LeafPowers result;
    for (const auto& [id, exponent] : from)
        if (const int rest = exponent - exponent_of(by, id); rest > 0) result.emplace_back(id, rest);
    return result;
}

} // namespace

void LeafPolynomial::add(LeafPowers powers, const Rational& coefficient) {
    if (cln::zerop(coefficient)) return;
    const auto [term, fresh] = terms_.emplace(std::move(powers), coefficient);
    if (fresh) return;
    term->second = term->second + coefficient;
    if (cln::zerop(term->second)) terms_.erase(term);
}

int LeafPolynomial::degree() const {
    int degree = 0;
    for (const auto& term : terms_) degree = std::max(degree, degree_of(term.first));
    return degree;
}

LeafPolynomial::Parts LeafPolynomial::parts() const {
    Rational content = 0;
    LeafPowers common = terms_.begin()->first;
    for (const auto& [powers, coefficient] : terms_) {
        content = common_measure(content, coefficient);
        LeafPowers least;
        for (const auto& [id, exponent] : common)
            if (const int other = exponent_of(powers, id); other > 0)
                least.emplace_back(id, std::min(exponent, other));
        common = std::move(least);
    }
    Parts parts{content, common, {}};
    std::map<LeafPowers, Rational> terms;
    for (const auto& [powers, coefficient] : terms_)
        terms.emplace(quotient(powers, common), coefficient / parts.content);
    const bool minus = cln::minusp(terms.begin()->second);
    if (minus) parts.content = -parts.content;
    for (const auto& [powers, coefficient] : terms)
        parts.primitive.add(powers, minus ? -coefficient : coefficient);
    return parts;
}

} // namespace resonform
