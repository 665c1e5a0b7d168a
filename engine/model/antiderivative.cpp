// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/antiderivative.hpp"

namespace resonform {

namespace {

using GiNaC::ex;

// The slope of a linear function of x; nullopt: it is none, or its slope is a sum, which might be zero.
std::optional<ex> slope_of(const ex& argument, const GiNaC::symbol& x) {
    const ex slope = argument.diff(x).expand();
    if (slope.has(x) || slope.is_zero() || GiNaC::is_a<GiNaC::add>(slope)) return std::nullopt;
    return slope;
}

std::optional<ex> of_function(const ex& e) {
    if (!GiNaC::is_a<GiNaC::function>(e) || e.nops() != 1) return std::nullopt;
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    const ex u = e.op(0);
    if (name == "sin") return -GiNaC::cos(u);
    if (name == "cos") return GiNaC::sin(u);
    if (name == "exp") return e;
    if (name == "sinh") return GiNaC::cosh(u);
    if (name == "cosh") return GiNaC::sinh(u);
    return std::nullopt;
}

// x^n f(a x + b) by parts.
std::optional<ex> of_product(const GiNaC::symbol& x, int n, const ex& f) {
    const auto once = of_function(f);
    const auto slope = once ? slope_of(f.op(0), x) : std::nullopt;
    if (!slope) return std::nullopt;
    const ex head = GiNaC::pow(x, n) * *once / *slope;
    if (n == 0) return head;
    const auto rest = of_product(x, n - 1, *once);
    if (!rest) return std::nullopt;
    return head - n * *rest / *slope;
}

std::optional<ex> of_power(const ex& e, const GiNaC::symbol& x) {
    const bool power = GiNaC::is_a<GiNaC::power>(e);
    const ex base = power ? e.op(0) : e, exponent = power ? e.op(1) : ex(1);
    const auto slope = slope_of(base, x);
    if (!slope || !exponent.info(GiNaC::info_flags::rational)) return std::nullopt;
    if (exponent.is_equal(-1)) return GiNaC::log(base) / *slope;
    return GiNaC::pow(base, exponent + 1) / ((exponent + 1) * *slope);
}

std::optional<ex> of_term(const ex& term, const GiNaC::symbol& x) {
    ex constant = 1, moving = 1, powers = 1;
    const auto take = [&](const ex& factor) {
        if (!factor.has(x))
            constant *= factor;
        else if (factor.is_equal(x) || (GiNaC::is_a<GiNaC::power>(factor) && factor.op(0).is_equal(x) &&
                                        factor.op(1).info(GiNaC::info_flags::posint)))
            powers *= factor;
        else
            moving *= factor;
    };
    if (GiNaC::is_a<GiNaC::mul>(term))
        for (const ex& factor : term) take(factor);
    else
        take(term);
    std::optional<ex> found;
    if (moving.is_equal(1))
        found = GiNaC::pow(x, powers.degree(x) + 1) / (powers.degree(x) + 1);
    else if (GiNaC::is_a<GiNaC::function>(moving))
        found = of_product(x, powers.degree(x), moving);
    else if (powers.is_equal(1))
        found = of_power(moving, x);
    if (found) *found *= constant;
    return found;
}

} // namespace

std::optional<ex> antiderivative(const ex& e, const GiNaC::symbol& x) {
    const ex sum = e.expand();
    ex result = 0;
    const auto add = [&](const ex& term) {
        const auto one = of_term(term, x);
        if (one) result += *one;
        return one.has_value();
    };
    if (!GiNaC::is_a<GiNaC::add>(sum)) return add(sum) ? std::optional<ex>(result) : std::nullopt;
    for (const ex& term : sum)
        if (!add(term)) return std::nullopt;
    return result;
}

} // namespace resonform
