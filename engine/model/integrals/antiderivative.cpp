// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/integrals/antiderivative.hpp"

#include "model/integrals/circular_integral.hpp"
#include "model/integrals/rational_integral.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"

#include <optional>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr int deepest_chain = 3;

class Antiderivative {
public:
    Antiderivative(const GiNaC::symbol& x, const PositiveThere& positive, int depth)
        : x_(x), positive_(positive), depth_(depth) {}

    std::optional<ex> of(const ex& e) const {
        ex result = 0;
        const ex sum = e.expand();
        for (const ex& term : terms_of(sum)) {
            const auto one = of_term(term);
            if (!one) return std::nullopt;
            result += *one;
        }
        return result;
    }

private:
    std::optional<ex> of_term(const ex& term) const {
        if (!term.has(x_)) return term * x_;
        if (auto f = of_power_of_line(term)) return f;
        if (auto f = integral_of_rational(term, x_, positive_)) return f;
        if (auto f = integral_of_circular_product(term, x_, positive_)) return f;
        if (auto f = integral_by_substitution(term, x_, positive_)) return f;
        if (auto f = by_parts(term)) return f;
        return by_chain_rule(term);
    }

    // c x^n (a x + b)^r, in u = a x + b
    std::optional<ex> of_power_of_line(const ex& term) const {
        ex polynomial = 1, base = 0, exponent = 0;
        for (const ex& factor : factors_of(term))
            if (factor.is_polynomial(x_))
                polynomial *= factor;
            else if (GiNaC::is_a<GiNaC::power>(factor) && base.is_zero() &&
                     factor.op(1).info(GiNaC::info_flags::rational)) {
                base = factor.op(0);
                exponent = factor.op(1);
            } else
                return std::nullopt;
        const auto slope = slope_of(base, x_, positive_);
        if (!slope || exponent.info(GiNaC::info_flags::integer)) return std::nullopt;
        const GiNaC::symbol u("u");
        const ex in_u = polynomial.subs(x_ == (u - base.subs(x_ == 0)) / *slope).expand();
        ex sum = 0;
        for (int n = 0; n <= in_u.degree(u); ++n)
            sum += in_u.coeff(u, n) * GiNaC::pow(base, n + exponent + 1) / (n + exponent + 1);
        return sum / *slope;
    }

    // p(x)*log(a x + b) = (P log)' - P a/(a x + b), with P' = p
    std::optional<ex> by_parts(const ex& term) const {
        ex polynomial = 1, inverse = 0;
        for (const ex& factor : factors_of(term)) {
            const std::optional<Function> f = function_of(factor);
            if (factor.is_polynomial(x_))
                polynomial *= factor;
            else if ((f == Function::logarithm || f == Function::arc_tangent) && inverse.is_zero())
                inverse = factor;
            else
                return std::nullopt;
        }
        if (inverse.is_zero()) return std::nullopt;
        const auto whole = integral_of_rational(polynomial, x_, positive_);
        if (!whole) return std::nullopt;
        const auto rest = integral_of_rational((*whole * inverse.diff(x_)).normal(), x_, positive_);
        if (!rest) return std::nullopt;
        return *whole * inverse - *rest;
    }

    // g(w(x)) w'(x), w an argument of a function, a function, or the base of a power
    std::optional<ex> by_chain_rule(const ex& term) const {
        if (depth_ == 0) return std::nullopt;
        const GiNaC::symbol u("u");
        for (const ex& inner : inner_functions(term)) {
            const ex rest =
                (term / inner.diff(x_)).normal().subs(inner == u, GiNaC::subs_options::no_pattern);
            if (rest.has(x_)) continue;
            const PositiveThere there = [&](const ex& e) { return positive_(e.subs(u == inner)); };
            if (const auto f = Antiderivative(u, there, depth_ - 1).of(rest)) return f->subs(u == inner);
        }
        return std::nullopt;
    }

    // The candidates for w. Not tan: an arc tangent of it would jump.
    std::vector<ex> inner_functions(const ex& e) const {
        std::vector<ex> found;
        const auto add = [&](const ex& inner) {
            const ex slope = inner.diff(x_).expand();
            if (slope.has(x_)) found.push_back(inner);
        };
        for (const ex& factor : factors_of(e)) {
            ex part = factor;
            if (GiNaC::is_a<GiNaC::power>(part)) {
                part = part.op(0);
                add(part);
            }
            if (!GiNaC::is_a<GiNaC::function>(part)) continue;
            if (part.nops() == 1) add(part.op(0));
            if (function_of(part) != Function::tangent) add(part);
        }
        return found;
    }

    const GiNaC::symbol& x_;
    const PositiveThere& positive_;
    int depth_;
};

} // namespace

std::optional<ex> antiderivative(const ex& e, const GiNaC::symbol& x, const PositiveThere& positive) {
    return Antiderivative(x, positive, deepest_chain).of(e);
}

} // namespace resonform
