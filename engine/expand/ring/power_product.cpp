// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/ring/power_product.hpp"

#include "algebra/number/error.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

bool is_integer(const Rational& r) { return cln::denominator(r) == 1; }

bool is_algebraic_number(const ex& e) {
    return std::none_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
        return is_a<GiNaC::symbol>(part) || is_a<GiNaC::constant>(part) || is_a<GiNaC::function>(part);
    });
}

// As a polynomial in its symbols and in the roots of numbers.
ex factored_over_roots(const ex& polynomial) {
    GiNaC::exmap roots;
    const ex factored = GiNaC::factor(polynomial.to_polynomial(roots));
    return factored.subs(roots, GiNaC::subs_options::no_pattern);
}

// The trial division stops here: a larger prime factor stays unsplit, which is still a valid base.
constexpr int largest_trial_divisor = 10000;

// Declaring a number positive would not make it so.
constexpr const char* hint_for_constant =
    "this is a number: correct it, or put a parameter that is declared in its place";

class Splitter {
public:
    Splitter(const CoefficientDomain& domain, const Place& place) : domain_(domain), place_(place) {}

    void split(const ex& base, const Rational& exponent) {
        if (cln::zerop(exponent)) return;
        if (is_a<GiNaC::numeric>(base)) return split_number(base, exponent);
        if (is_a<GiNaC::power>(base)) return split_nested(base, exponent);
        if (is_a<GiNaC::mul>(base)) return split_product(base, exponent);
        if (is_a<GiNaC::symbol>(base)) return append(base, exponent);
        if (is_a<GiNaC::add>(base)) return split_sum(base, exponent);
        refuse({"coefficients are built from powers, roots and functions of parameters and slow variables",
                spell(base), "write it with sin, cos, exp, log, powers and roots", place_});
    }

    PowerProduct result;

private:
    void split_number(const ex& base, const Rational& exponent) {
        const Rational value = to_rational(base);
        if (cln::zerop(value)) {
            if (cln::plusp(exponent)) {
                result.number = 0;
                return;
            }
            bad_input({"nothing is divided by an expression that is zero", spell(base),
                       "remove the division, or expand about another point", place_});
        }
        if (is_integer(exponent)) {
            result.number = result.number * cln::expt(value, cln::numerator(exponent));
            return;
        }
        if (cln::minusp(value)) not_positive(base);
        split_integer(cln::numerator(value), exponent);
        split_integer(cln::denominator(value), -exponent);
    }

    void split_integer(Integer rest, const Rational& exponent) {
        for (int p = 2; p <= largest_trial_divisor && rest > 1; ++p) {
            int multiplicity = 0;
            while (cln::zerop(cln::mod(rest, p))) {
                rest = cln::exquo(rest, p);
                ++multiplicity;
            }
            if (multiplicity > 0) append_integer(p, multiplicity * exponent);
        }
        if (rest > 1) append_unsplit(rest, exponent);
    }

    // All its prime factors are beyond trial division. A power of one of these must not stand beside its
    // root.
    void append_unsplit(Integer base, Rational exponent) {
        Integer root;
        for (unsigned n = 2; cln::expt_pos(Integer(largest_trial_divisor), n) < base; ++n)
            for (; cln::rootp(base, Integer(n), &root); base = root) exponent = n * exponent;
        append_integer(base, exponent);
    }

    // p^(n + f) with 0 <= f < 1: the whole part goes into the number.
    void append_integer(const Integer& p, const Rational& exponent) {
        const Integer whole = cln::floor1(exponent);
        result.number = result.number * cln::expt(Rational(p), whole);
        const Rational fraction = exponent - whole;
        if (!cln::zerop(fraction)) result.factors.push_back({to_ginac(p), fraction});
    }

    void split_nested(const ex& base, const Rational& exponent) {
        if (!is_a<GiNaC::numeric>(base.op(1)) || !ex_to<GiNaC::numeric>(base.op(1)).is_rational())
            refuse({"exponents are rational numbers", spell(base), "write the power with a number", place_});
        const ex& inner = base.op(0);
        // (b^a)^e = b^(a e) holds for integer e, and for any e where b is positive.
        const Rational all = to_rational(base.op(1)) * exponent;
        if (is_integer(exponent) || domain_.positive(inner)) return split(inner, all);
        if (!is_square_of_negative(base)) not_positive(inner);
        split((-inner).expand(), all);
    }

    // (c - w)^2 is (w - c)^2.
    [[nodiscard]] bool is_square_of_negative(const ex& power) const {
        return power.op(1).info(GiNaC::info_flags::even) && domain_.positive((-power.op(0)).expand());
    }

    void split_product(const ex& base, const Rational& exponent) {
        if (!is_integer(exponent)) {
            if (const auto factors = positive_factors(base)) {
                for (const PowerFactor& factor : *factors)
                    if (factor.base.is_equal(base)) // -tau, which is positive as a whole
                        append(base, factor.exponent * exponent);
                    else
                        split(factor.base, factor.exponent * exponent);
                return;
            }
            not_positive_product(base);
        }
        for (const ex& factor : operands(base)) split(factor, exponent);
    }

    // The factors, negative ones with their sign changed: -(-2 + tau)*tau is (2 - tau)*tau. nullopt if a sign
    // is unknown, or the product is negative. Bases and exponents apart, because GiNaC may change the sign of
    // a sum under a power.
    [[nodiscard]] std::optional<std::vector<PowerFactor>> positive_factors(const ex& product) const {
        std::vector<PowerFactor> factors;
        bool negative = false;
        for (const ex& factor : operands(product)) {
            const bool whole = is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::integer);
            const ex base = whole ? factor.op(0) : factor;
            const Rational exponent = whole ? to_rational(factor.op(1)) : Rational(1);
            if (domain_.positive(base)) {
                factors.push_back({base, exponent});
                continue;
            }
            const ex turned = (-base).expand();
            if (!domain_.positive(turned)) return std::nullopt;
            negative = negative != cln::oddp(cln::numerator(exponent));
            factors.push_back({turned, exponent});
        }
        return negative ? std::nullopt : std::optional(factors);
    }

    // The powers inside of a sum as products of powers, too: 1 + (a*b)^(1/2) is 1 + a^(1/2)*b^(1/2).
    [[nodiscard]] ex split_inside(const ex& e) const {
        if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational) &&
            !e.op(1).info(GiNaC::info_flags::integer)) {
            const PowerProduct parts = split_power(e.op(0), to_rational(e.op(1)), domain_, place_);
            ex product = to_ginac(parts.number);
            for (const PowerFactor& f : parts.factors) product *= GiNaC::pow(f.base, to_ginac(f.exponent));
            return product;
        }
        if (is_a<GiNaC::power>(e)) return GiNaC::pow(split_inside(e.op(0)), e.op(1));
        const bool sum = is_a<GiNaC::add>(e);
        if (!sum && !is_a<GiNaC::mul>(e)) return e;
        ex all = sum ? 0 : 1;
        for (const ex& operand : operands(e)) {
            const ex inside = split_inside(operand);
            all = sum ? all + inside : all * inside;
        }
        return all;
    }

    void split_sum(const ex& base, const Rational& exponent) {
        const ex fraction = split_inside(base).normal();
        if (!is_a<GiNaC::add>(fraction)) return split(fraction, exponent);
        const ex expanded = domain_.expanded(fraction);
        if (!is_a<GiNaC::add>(expanded)) return split(expanded, exponent);
        // Numbers taken out of a root would be roots of their own: sqrt(2)*k - k = (sqrt(2) - 1)*k.
        ex factored = expanded;
        if (domain_.polynomial(expanded))
            factored = is_integer(exponent) ? factored_over_roots(expanded) : GiNaC::factor(expanded);
        if (!is_a<GiNaC::add>(factored) && separable(factored, expanded, exponent))
            return split(factored, exponent);
        append_sum(expanded, exponent);
    }

    // Not so for 1 + tau^6 = (1 + tau^2)*(1 - tau^2 + tau^4): only the whole is proved to be positive.
    [[nodiscard]] bool all_nonzero(const ex& product) const {
        const std::vector<ex> factors = operands(product);
        return std::all_of(factors.begin(), factors.end(), [&](const ex& f) { return domain_.nonzero(f); });
    }

    // May factors be treated one by one? For whole exponents, unless it is an inverse and only the whole is
    // proved nonzero; for others, only where each factor is positive.
    [[nodiscard]] bool separable(const ex& factored, const ex& sum, const Rational& exponent) const {
        if (is_integer(exponent))
            return !cln::minusp(exponent) || !domain_.nonzero(sum) || all_nonzero(factored);
        if (is_a<GiNaC::power>(factored))
            return domain_.positive(factored.op(0)) || is_square_of_negative(factored);
        // A number times one sum is treated like the sum.
        const auto numbers = std::count_if(factored.begin(), factored.end(),
                                           [](const ex& f) { return is_a<GiNaC::numeric>(f); });
        const bool one_sum =
            static_cast<std::size_t>(numbers) + 1 == factored.nops() &&
            std::any_of(factored.begin(), factored.end(), [](const ex& f) { return is_a<GiNaC::add>(f); });
        return !one_sum && positive_factors(factored).has_value();
    }

    // Of a number made of roots, 1/(1 + sqrt(2) + sqrt(3)), which would be a base of its own that depends on
    // these. nullopt: symbols or functions are in it, or the roots depend on one another.
    [[nodiscard]] std::optional<ex> inverse_of_number(const ex& e) const {
        if (!is_algebraic_number(e)) return std::nullopt;
        return domain_.inverse_of_number(e, place_);
    }

    void append_sum(const ex& base, const Rational& exponent) {
        if (is_integer(exponent) && cln::minusp(exponent))
            if (const auto inverse = inverse_of_number(base)) return split(*inverse, -exponent);
        const ex content = base.integer_content();
        const ex primitive = (base / content).expand();
        if (!content.is_equal(1)) split_number(content, exponent);
        if (domain_.positive(primitive)) {
            result.factors.push_back({primitive, exponent});
        } else if (is_integer(exponent) && domain_.positive(-primitive)) {
            if (cln::oddp(cln::numerator(exponent))) result.number = -result.number;
            result.factors.push_back({(-primitive).expand(), exponent});
        } else {
            append_of_unknown_sign(primitive, exponent);
        }
    }

    // Always takes the same one of a base and its negative.
    void append_of_unknown_sign(const ex& base, const Rational& exponent) {
        const ex chosen = is_integer(exponent) ? canonical_sign(base) : base;
        if (!chosen.is_equal(base) && cln::oddp(cln::numerator(exponent))) result.number = -result.number;
        append(chosen, exponent);
    }

    void append(const ex& base, const Rational& exponent) {
        if (!is_integer(exponent) && !domain_.positive(base)) not_positive(base);
        if (cln::minusp(exponent) && !domain_.nonzero(base))
            refuse(Reason::undecided,
                   {"nothing is divided by an expression that is not proved to be non-zero", spell(base),
                    is_constant(domain_.meaning(base))
                        ? hint_for_constant
                        : "declare it: nonzero = true or positive = true for a name, or "
                          "[domain] positive = [\"" +
                              spell(base) + "\"]",
                    place_});
        result.factors.push_back({base, exponent});
    }

    // Names the first factor of unknown sign: for -1/2*(a - b)/c with c > 0 it asks for b - a > 0.
    [[noreturn]] void not_positive_product(const ex& product) const {
        ex unknown;
        bool negative = false;
        for (const ex& factor : operands(product)) {
            const bool whole = is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::integer);
            const ex base = whole ? factor.op(0) : factor;
            if (domain_.positive(base)) continue;
            const bool even = whole && factor.op(1).info(GiNaC::info_flags::even);
            if (domain_.positive((-base).expand()))
                negative = negative != !even;
            else if (unknown.is_zero())
                unknown = base;
        }
        if (unknown.is_zero()) not_positive(product);
        not_positive(negative ? (-unknown).expand() : unknown);
    }

    [[noreturn]] void not_positive(const ex& base) const {
        refuse(Reason::undecided, {"a root is taken only of what is proved to be positive", spell(base),
                                   how_to_make_positive(domain_.meaning(base)), place_});
    }

    const CoefficientDomain& domain_;
    const Place& place_;
};

} // namespace

PowerProduct split_power(const ex& base, const Rational& exponent, const CoefficientDomain& domain,
                         const Place& place) {
    Splitter splitter(domain, place);
    splitter.split(base, exponent);
    return splitter.result;
}

std::string how_to_make_positive(const ex& e) {
    if (is_constant(e)) return hint_for_constant;
    const std::string declare = "declare what is positive: ";
    if (is_a<GiNaC::symbol>(e)) return declare + spell(e) + " = { positive = true, ... }";
    if (!is_a<GiNaC::add>(e)) return declare + "every factor by itself, with positive = true for a name";
    constexpr std::size_t longest = 300;
    const std::string text = spell(e);
    if (text.size() > longest)
        return declare + "positive = true for a name in it, or write it with fewer multiples of one argument";
    return declare + "positive = true for a name in it, or [domain] positive = [\"" + text + "\"]";
}

} // namespace resonform
