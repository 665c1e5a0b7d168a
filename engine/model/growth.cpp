// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

Growth of_sum(const Growth& a, const Growth& b) {
    return {a.terms + b.terms, std::max(a.degree, b.degree), a.bits + b.bits + 1, std::max(a.depth, b.depth)};
}

Growth of_product(const Growth& a, const Growth& b) {
    return {a.terms * b.terms, a.degree + b.degree, a.bits + b.bits, std::max(a.depth, b.depth)};
}

// A sum of t terms to the n-th power has at most binomial(t + n - 1, n) terms.
Growth of_power(const Growth& base, double exponent) {
    const double n = std::max(1.0, std::ceil(std::abs(exponent)));
    const double log_terms =
        std::lgamma(base.terms + n) - std::lgamma(n + 1) - std::lgamma(std::max(1.0, base.terms));
    Growth power;
    power.terms = base.terms <= 1 ? 1 : std::exp(log_terms);
    power.degree = base.degree * n;
    power.depth = base.depth;
    power.bits = (base.bits + std::log2(std::max(1.0, base.terms))) * n;
    return power;
}

Growth growth_of_number(const GiNaC::numeric& n) {
    return {1, 0, static_cast<double>(n.numer().int_length() + n.denom().int_length()), 0};
}

Growth of_substitution(const GiNaC::ex& e, const GiNaC::symbol& symbol, const Growth& value) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) return growth_of_number(GiNaC::ex_to<GiNaC::numeric>(e));
    if (e.is_equal(symbol)) return value;
    if (e.nops() == 0) return {1, 1, 0, 0};
    Growth total = of_substitution(e.op(0), symbol, value);
    total.depth += 1;
    if (GiNaC::is_a<GiNaC::power>(e)) {
        const bool known = GiNaC::is_a<GiNaC::numeric>(e.op(1));
        return of_power(total, known ? GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_double() : 1);
    }
    if (GiNaC::is_a<GiNaC::function>(e)) return {1, 1, total.bits, total.depth};
    for (std::size_t i = 1; i < e.nops(); ++i) {
        Growth part = of_substitution(e.op(i), symbol, value);
        part.depth += 1;
        total = GiNaC::is_a<GiNaC::add>(e) ? of_sum(total, part) : of_product(total, part);
    }
    return total;
}

Growth of_expression(const GiNaC::ex& e) { return of_substitution(e, GiNaC::symbol(), {}); }

} // namespace resonform
