// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions become polynomials of a ring that is frozen, and back.
#include "algebra/number/error.hpp"
#include "expand/ring/coefficient_ring.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

// An exponent that is kept in a monomial.
int to_exponent(const Rational& value, const ex& base, const Place& place) {
    constexpr int largest = 16383; // of any ring
    if (cln::abs(cln::numerator(value)) > largest)
        refuse(Reason::size, {fmt::format("exponents are at most {} once roots are taken out", largest),
                              spell(base), "use simpler exponents", place});
    return cln::cl_I_to_int(cln::numerator(value));
}

} // namespace

Polynomial CoefficientRing::convert(const ex& e, const Place& place) const {
    return convert_rewritten(functions_->rewrite(e, place), place);
}

Polynomial CoefficientRing::convert_rewritten(const ex& e, const Place& place) const {
    if (is_a<GiNaC::add>(e)) {
        std::vector<Polynomial> summands;
        for (const ex& term : operands(e)) summands.push_back(convert_rewritten(term, place));
        return sum(summands);
    }
    if (is_a<GiNaC::mul>(e)) {
        Polynomial product = ring_->one();
        for (const ex& factor : operands(e))
            product = ring_->multiply(product, convert_rewritten(factor, place));
        return product;
    }
    if (e.info(GiNaC::info_flags::rational)) return Polynomial(to_rational(e));
    if (is_a<GiNaC::symbol>(e)) return convert_symbol(e, 1, place);
    if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational)) {
        if (e.op(1).info(GiNaC::info_flags::nonnegint))
            return ring_->power(convert_rewritten(e.op(0), place),
                                cln::cl_I_to_int(cln::numerator(to_rational(e.op(1)))));
        return convert_power(e.op(0), to_rational(e.op(1)), place);
    }
    refuse({"coefficients are built from numbers, parameters, slow variables, powers, roots and functions",
            spell(functions_->domain().meaning(e)), "write it as a parameter", place});
}

Polynomial CoefficientRing::convert(const Complex& e, const Place& place) const {
    const Polynomial re = convert(e.re, place);
    return e.im.is_zero() ? re : re + ring_->multiply(ring_->imaginary(), convert(e.im, place));
}

Polynomial CoefficientRing::convert_symbol(const ex& symbol, int exponent, const Place& place) const {
    for (const auto& [known, id] : symbols_)
        if (symbol.is_equal(known)) return ring_->gen(id, exponent);
    bad_input({"coefficients depend on parameters and slow variables only", spell(symbol),
               "declare the variable as slow if its equation of motion says so", place});
}

Polynomial CoefficientRing::convert_power(const ex& base, const Rational& exponent,
                                          const Place& place) const {
    const PowerProduct product = split_power(base, exponent, functions_->domain(), place);
    Polynomial result(product.number);
    for (const auto& factor : product.factors) {
        if (const Base* root = find_base(factor.base)) {
            const int power = to_exponent(factor.exponent * root->index, factor.base, place);
            result = ring_->multiply(result, ring_->gen(root->id, power));
        } else {
            const int power = to_exponent(factor.exponent, factor.base, place);
            result =
                ring_->multiply(result, is_a<GiNaC::symbol>(factor.base)
                                            ? convert_symbol(factor.base, power, place)
                                            : ring_->power(convert_rewritten(factor.base, place), power));
        }
    }
    return result;
}

ex CoefficientRing::expression(const Polynomial& p) const {
    ex sum = 0;
    for (const Term& t : p.terms()) {
        ex product = to_ginac(t.coefficient);
        for (GeneratorId id = 0; id < ring_->size(); ++id)
            if (const int exponent = ring_->exponent(t.monomial, id); exponent != 0)
                product *= power_of(id, exponent);
        sum += product;
    }
    return sum;
}

ex CoefficientRing::power_of(GeneratorId id, int exponent) const {
    for (const auto& [symbol, known] : symbols_)
        if (known == id) return GiNaC::pow(functions_->domain().meaning(symbol), exponent);
    for (const Base& base : bases_)
        if (base.id == id)
            return GiNaC::pow(functions_->domain().meaning(base.expression),
                              GiNaC::numeric(exponent, base.index));
    if (std::find(divisors_.begin(), divisors_.end(), id) != divisors_.end())
        return GiNaC::pow(expression(ring_->generator(id).radicand), exponent);
    throw std::logic_error("no coefficient: " + ring_->generator(id).name);
}

} // namespace resonform
