// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/growth.hpp"

#include "model/text/function_call.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

namespace {

// cos(a + b) = cos(a)*cos(b) - sin(a)*sin(b), and cos(n*u) is a polynomial in cos(u).
double terms_of_circular(const GiNaC::ex& argument, double terms) {
    constexpr double most = 64;
    if (terms > most) return std::exp2(most);
    const GiNaC::ex sum = argument.expand();
    const bool several = GiNaC::is_a<GiNaC::add>(sum);
    double total = 1;
    for (std::size_t k = 0; k < (several ? sum.nops() : 1); ++k) {
        const GiNaC::numeric multiple = (several ? sum.op(k) : sum).integer_content().numer();
        total *= (k == 0 ? 1 : 2) * (1 + std::floor(multiple.to_double() / 2));
    }
    return total;
}

} // namespace

double terms_in_exact_form(const GiNaC::ex& e) {
    if (e.nops() == 0) return 1;
    const double first = terms_in_exact_form(e.op(0));
    if (GiNaC::is_a<GiNaC::power>(e) && GiNaC::is_a<GiNaC::numeric>(e.op(1)))
        return of_power({first, 1, 0, 0}, GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_double()).terms;
    if (GiNaC::is_a<GiNaC::function>(e)) {
        const std::optional<Function> f = function_of(e);
        const bool divided = f == Function::sine || f == Function::cosine || f == Function::hyperbolic_sine ||
                             f == Function::hyperbolic_cosine;
        return divided ? terms_of_circular(e.op(0), first) : 1;
    }
    double total = first;
    for (std::size_t k = 1; k < e.nops(); ++k) {
        const double part = terms_in_exact_form(e.op(k));
        total = GiNaC::is_a<GiNaC::add>(e) ? total + part : total * part;
    }
    return total;
}

Growth of_expression(const GiNaC::ex& e) { return of_substitution(e, GiNaC::symbol(), {}); }

} // namespace resonform
