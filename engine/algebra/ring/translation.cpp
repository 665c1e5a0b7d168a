// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/translation.hpp"

#include "algebra/ring/primitive_terms.hpp"

namespace resonform {

std::optional<Packed> Translation::packed(const Polynomial& p) const {
    Packed result(context_);
    Packed::Exponents exponents(ids_.size());
    for (const Term& t : primitive_terms(p)) {
        for (std::size_t k = 0; k < ids_.size(); ++k) {
            const int exponent = ring_.exponent(t.monomial, ids_[k]);
            if (exponent < 0) return std::nullopt;
            exponents[k] = static_cast<ulong>(exponent);
        }
        result.give(exponents, Whole(cln::numerator(t.coefficient)));
    }
    result.put_in_order();
    return result;
}

Polynomial Translation::unpacked(const Packed& p) const {
    std::vector<Term> terms;
    p.visit_terms([&](const Packed::Exponents& exponents, const Whole& coefficient) {
        Monomial monomial;
        for (std::size_t k = 0; k < ids_.size(); ++k)
            monomial = monomial + ring_.monomial(ids_[k], static_cast<int>(exponents[k]));
        terms.push_back({monomial, coefficient.value()});
    });
    return Polynomial::from_terms(std::move(terms));
}

} // namespace resonform
