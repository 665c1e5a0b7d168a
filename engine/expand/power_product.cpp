// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/power_product.hpp"

#include "model/positivity.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

bool is_integer(const Rational& r) { return cln::denominator(r) == 1; }

// The trial division stops here: a larger prime factor stays unsplit, which is still a valid base.
constexpr int largest_trial_divisor = 10000;

class Splitter {
public:
    Splitter(const System& system, const Place& place) : system_(system), place_(place) {}

    void split(const ex& base, const Rational& exponent) {
        if (cln::zerop(exponent)) return;
        if (is_a<GiNaC::numeric>(base)) return split_number(base, exponent);
        if (is_a<GiNaC::power>(base)) return split_nested(base, exponent);
        if (is_a<GiNaC::mul>(base)) return split_product(base, exponent);
        if (is_a<GiNaC::symbol>(base)) return append(base, exponent);
        if (is_a<GiNaC::add>(base)) return split_sum(base, exponent);
        refuse({"coefficients are built from powers and roots of parameters and slow variables", spell(base),
                "functions of slow variables are not supported yet: write the coefficient with powers",
                place_});
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
        if (rest > 1) append_integer(rest, exponent);
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
        if (!is_integer(exponent) && !provably_positive(inner, system_)) not_positive(inner);
        split(inner, to_rational(base.op(1)) * exponent);
    }

    void split_product(const ex& base, const Rational& exponent) {
        if (!is_integer(exponent)) {
            if (const auto factors = positive_factors(base)) {
                for (const ex& factor : *factors) split(factor, exponent);
                return;
            }
            for (const ex& factor : base)
                if (!provably_positive(factor, system_)) not_positive(factor);
        }
        for (const ex& factor : base) split(factor, exponent);
    }

    // The factors, those that are negative turned: -(-2 + tau)*tau is (2 - tau)*tau. Nothing if there is one
    // of neither sign, or the product is negative.
    [[nodiscard]] std::optional<std::vector<ex>> positive_factors(const ex& product) const {
        std::vector<ex> factors;
        bool negative = false;
        for (ex factor : product) {
            const bool power = is_a<GiNaC::power>(factor);
            const ex base = power ? factor.op(0) : factor, exponent = power ? factor.op(1) : ex(1);
            if (!provably_positive(base, system_)) {
                const ex turned = (-base).expand();
                if (!exponent.info(GiNaC::info_flags::integer) || !provably_positive(turned, system_))
                    return std::nullopt;
                negative = negative != exponent.info(GiNaC::info_flags::odd);
                factor = GiNaC::pow(turned, exponent);
            }
            factors.push_back(factor);
        }
        return negative ? std::nullopt : std::optional(factors);
    }

    void split_sum(const ex& base, const Rational& exponent) {
        const ex fraction = base.normal();
        if (!is_a<GiNaC::add>(fraction)) return split(fraction, exponent);
        const ex expanded = fraction.expand();
        const ex factored = polynomial(expanded) ? GiNaC::factor(expanded) : expanded;
        if (!is_a<GiNaC::add>(factored) && separable(factored, exponent)) return split(factored, exponent);
        append_sum(expanded, exponent);
    }

    [[nodiscard]] bool polynomial(const ex& e) const {
        GiNaC::lst symbols;
        for (const auto& p : system_.parameters) symbols.append(p.symbol);
        for (const auto& v : system_.variables) symbols.append(v.jet.front());
        return e.is_polynomial(symbols);
    }

    // May factors be treated one by one? Always for whole exponents, else only where each is positive.
    [[nodiscard]] bool separable(const ex& factored, const Rational& exponent) const {
        if (is_integer(exponent)) return true;
        if (is_a<GiNaC::power>(factored)) return provably_positive(factored.op(0), system_);
        // A number times one sum is that sum.
        const auto numbers = std::count_if(factored.begin(), factored.end(),
                                           [](const ex& f) { return is_a<GiNaC::numeric>(f); });
        const bool one_sum =
            static_cast<std::size_t>(numbers) + 1 == factored.nops() &&
            std::any_of(factored.begin(), factored.end(), [](const ex& f) { return is_a<GiNaC::add>(f); });
        return !one_sum && positive_factors(factored).has_value();
    }

    void append_sum(const ex& base, const Rational& exponent) {
        const ex content = base.integer_content();
        const ex primitive = (base / content).expand();
        if (!content.is_equal(1)) split_number(content, exponent);
        if (provably_positive(primitive, system_)) {
            result.factors.push_back({primitive, exponent});
        } else if (is_integer(exponent) && provably_positive(-primitive, system_)) {
            if (cln::oddp(cln::numerator(exponent))) result.number = -result.number;
            result.factors.push_back({(-primitive).expand(), exponent});
        } else {
            append(primitive, exponent);
        }
    }

    void append(const ex& base, const Rational& exponent) {
        if (!is_integer(exponent) && !provably_positive(base, system_)) not_positive(base);
        if (cln::minusp(exponent) && !provably_nonzero(base, system_))
            refuse({"nothing is divided by an expression that is not proved to be non-zero", spell(base),
                    "declare it: nonzero = true or positive = true for a name, or [domain] positive = [\"" +
                        spell(base) + "\"]",
                    place_});
        result.factors.push_back({base, exponent});
    }

    [[noreturn]] void not_positive(const ex& base) const {
        refuse({"a root is taken only of what is proved to be positive", spell(base),
                "declare what is positive: " + how_to_declare_positive(base), place_});
    }

    const System& system_;
    const Place& place_;
};

} // namespace

PowerProduct split_power(const ex& base, const Rational& exponent, const System& system, const Place& place) {
    Splitter splitter(system, place);
    splitter.split(base, exponent);
    return splitter.result;
}

Rational to_rational(const ex& number) {
    return cln::the<cln::cl_RA>(ex_to<GiNaC::numeric>(number).to_cl_N());
}

ex to_ginac(const Rational& number) { return GiNaC::numeric(number); }

std::string how_to_declare_positive(const ex& e) {
    if (is_a<GiNaC::symbol>(e)) return spell(e) + " = { positive = true, ... }";
    if (!is_a<GiNaC::add>(e)) return "every factor by itself, with positive = true for a name";
    return "positive = true for a name in it, or [domain] positive = [\"" + spell(e) + "\"]";
}

std::string spell(const ex& e) {
    // GiNaC's own order of terms depends on addresses: sort the printed terms of sums and products.
    std::vector<std::string> parts;
    if (is_a<GiNaC::add>(e)) {
        for (const ex& term : e) parts.push_back(spell(term));
        std::sort(parts.begin(), parts.end());
        std::string text;
        for (const auto& p : parts) text += (text.empty() ? "" : p.front() == '-' ? " " : " + ") + p;
        return text;
    }
    const auto wrap = [](const ex& f) { return is_a<GiNaC::add>(f) ? "(" + spell(f) + ")" : spell(f); };
    if (is_a<GiNaC::mul>(e)) {
        std::string number;
        for (const ex& factor : e) {
            if (is_a<GiNaC::numeric>(factor)) {
                number = factor.is_equal(-1) ? "-" : spell(factor) + "*";
            } else {
                parts.push_back(wrap(factor));
            }
        }
        std::sort(parts.begin(), parts.end());
        std::string text;
        for (const auto& p : parts) text += (text.empty() ? "" : "*") + p;
        return number + text;
    }
    if (is_a<GiNaC::power>(e)) {
        const bool atom = is_a<GiNaC::symbol>(e.op(0));
        const bool whole = e.op(1).info(GiNaC::info_flags::nonnegint);
        return (atom ? spell(e.op(0)) : "(" + spell(e.op(0)) + ")") + "^" +
               (whole ? spell(e.op(1)) : "(" + spell(e.op(1)) + ")");
    }
    if (is_a<GiNaC::function>(e)) return ex_to<GiNaC::function>(e).get_name() + "(" + spell(e.op(0)) + ")";
    std::ostringstream stream;
    stream << e;
    return stream.str();
}

} // namespace resonform
