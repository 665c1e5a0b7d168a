// SPDX-License-Identifier: GPL-3.0-or-later
// Roots on their way into an exact form: sqrt(1 + xi^2/r^2) = sqrt(xi^2 + r^2)/r where r is positive.
#include "algebra/number/error.hpp"
#include "model/exact/form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

namespace resonform {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

// The factors of a polynomial with their exponents: symbols, then the square-free factors of the rest.
std::vector<std::pair<ex, int>> factor_powers(ex polynomial,
                                              const std::vector<ExactForm::Generator>& generators) {
    std::vector<std::pair<ex, int>> factors;
    for (const ExactForm::Generator& g : generators) {
        const int n = polynomial.ldegree(g.symbol);
        if (n == 0) continue;
        factors.emplace_back(g.symbol, n);
        polynomial = (polynomial / GiNaC::pow(g.symbol, n)).expand();
    }
    const ex rest = GiNaC::sqrfree(polynomial);
    const auto take = [&](const ex& factor) {
        if (GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::posint))
            factors.emplace_back(factor.op(0), GiNaC::ex_to<numeric>(factor.op(1)).to_int());
        else
            factors.emplace_back(factor, 1);
    };
    if (GiNaC::is_a<GiNaC::mul>(rest))
        for (const ex& factor : operands(rest)) take(factor);
    else
        take(rest);
    return factors;
}

} // namespace

ex ExactForm::root(const ex& base, int index) {
    const Fraction f = fraction(base);
    if (!positive(f.denominator))
        refuse(Reason::undecided,
               {"the denominator under a root is proved positive", excerpt(spell(meaning(f.denominator))),
                "declare what it is made of positive", place_});
    return root_of_polynomial(reduced(f.numerator * GiNaC::pow(f.denominator, index - 1)), index) /
           f.denominator;
}

ex ExactForm::root_of_polynomial(const ex& base, int index) {
    if (base.is_zero()) return 0;
    const numeric content = GiNaC::ex_to<numeric>(base.integer_content());
    ex result = root_of_number(content, index), inside = 1;
    for (const auto& [factor, exponent] : factor_powers((base / content).expand(), generators_)) {
        const bool negative = positive(-factor);
        const ex f = negative ? ex(-factor) : factor;
        if (negative && exponent % 2 == 1) inside = -inside;
        if (f.is_equal(1)) continue;
        if (positive(f)) {
            result *= GiNaC::pow(f, exponent / index);
            if (exponent % index != 0) result *= GiNaC::pow(root_generator(f, index), exponent % index);
        } else {
            inside *= GiNaC::pow(f, exponent);
        }
    }
    inside = inside.expand();
    return inside.is_equal(1) ? result : result * root_generator(inside, index);
}

// By primes, so that sqrt(6) is sqrt(2)*sqrt(3): one generator for each, and these are independent.
ex ExactForm::root_of_number(const numeric& base, int index) {
    numeric whole = base.numer() * base.denom().power(index - 1);
    ex result = 1 / base.denom();
    const auto take = [&](const numeric& factor, int exponent) {
        result *= factor.power(exponent / index);
        if (exponent % index != 0) result *= GiNaC::pow(root_generator(factor, index), exponent % index);
    };
    constexpr int tried = 10000;
    for (int p = 2; p < tried && whole >= numeric(p) * p; ++p) {
        int exponent = 0;
        for (; GiNaC::irem(whole, p).is_zero(); whole = GiNaC::iquo(whole, p)) ++exponent;
        if (exponent != 0) take(p, exponent);
    }
    if (const ex root = GiNaC::pow(ex(whole), numeric(1, index)); GiNaC::is_a<numeric>(root))
        return result * root;
    take(whole, 1);
    return result;
}

ex ExactForm::root_generator(const ex& base, int index) {
    const ex value = GiNaC::pow(meaning(base), numeric(1, index));
    if (const Generator* known = find(value)) return known->symbol;
    const std::string inside = text_of(base);
    Generator& root = add(value, index == 2 ? "sqrt(" + inside + ")"
                                            : "(" + inside + ")^(1/" + std::to_string(index) + ")");
    root.relation = Generator::Relation::root;
    root.value = base;
    root.index = index;
    return root.symbol;
}

} // namespace resonform
