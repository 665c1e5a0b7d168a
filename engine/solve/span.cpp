// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/span.hpp"

namespace resonform {

void Span::add(const Polynomial& p) {
    const std::size_t index = count_++;
    Decomposition d = decompose(p);
    if (d.remainder.empty()) return;
    for (Rational& c : d.coordinates) c = -c;
    d.coordinates[index] = 1;
    const Term lead = d.remainder.terms().back();
    const Rational scale = 1 / lead.coefficient;
    for (Rational& c : d.coordinates) c = c * scale;
    rows_.emplace(lead.monomial, Row{scale * d.remainder, std::move(d.coordinates)});
}

Span::Decomposition Span::decompose(Polynomial target) const {
    Decomposition result;
    result.coordinates.assign(count_, 0);
    std::vector<Term> remainder;
    while (!target.empty()) {
        const Term lead = target.terms().back();
        const auto found = rows_.find(lead.monomial);
        if (found == rows_.end()) {
            remainder.push_back(lead);
            target = target - Polynomial(lead.monomial, lead.coefficient);
            continue;
        }
        const Row& row = found->second;
        target = target - lead.coefficient * row.vector;
        for (std::size_t k = 0; k < row.combination.size(); ++k)
            result.coordinates[k] = result.coordinates[k] + lead.coefficient * row.combination[k];
    }
    result.remainder = Polynomial::from_terms(std::move(remainder));
    return result;
}

} // namespace resonform
