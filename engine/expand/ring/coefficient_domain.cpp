// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/ring/coefficient_domain.hpp"

#include "model/signs/sign_prover.hpp"

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

// factor^n = (1 - c^2)^(n/2) s^(n mod 2) for the sine s; any other factor is left alone.
ex lowered(const ex& factor, const ex& sine, const ex& cosine) {
    if (!is_a<GiNaC::power>(factor) || !factor.op(0).is_equal(sine) ||
        !factor.op(1).info(GiNaC::info_flags::posint))
        return factor;
    const int n = GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int();
    return GiNaC::pow(1 - GiNaC::pow(cosine, 2), n / 2) * GiNaC::pow(sine, n % 2);
}

ex lowered_term(const ex& term, const ex& sine, const ex& cosine) {
    if (!is_a<GiNaC::mul>(term)) return lowered(term, sine, cosine);
    ex product = 1;
    for (const ex& factor : term) product *= lowered(factor, sine, cosine);
    return product;
}

} // namespace

ex CoefficientDomain::meaning(const ex& e) const {
    return e.subs(meanings_, GiNaC::subs_options::no_pattern);
}

bool CoefficientDomain::positive(const ex& e) const { return provably_positive(meaning(e), *system_); }

bool CoefficientDomain::nonzero(const ex& e) const { return provably_nonzero(meaning(e), *system_); }

ex CoefficientDomain::expanded(const ex& e) const {
    ex result = e.expand();
    for (const auto& [sine, cosine] : circles_) {
        if (!result.has(sine)) continue;
        ex sum = 0;
        if (is_a<GiNaC::add>(result)) {
            for (const ex& term : result) sum += lowered_term(term, sine, cosine);
        } else {
            sum = lowered_term(result, sine, cosine);
        }
        result = sum.expand();
    }
    return result;
}

bool CoefficientDomain::polynomial(const ex& e) const {
    GiNaC::lst symbols;
    for (const auto& p : system_->parameters) symbols.append(p.symbol);
    for (const auto& v : system_->variables) symbols.append(v.jet.front());
    for (const ex& symbol : symbols_) symbols.append(symbol);
    return e.is_polynomial(symbols);
}

} // namespace resonform
