// SPDX-License-Identifier: GPL-3.0-or-later
// Functions on their way into an exact form.
#include "algebra/number/error.hpp"
#include "model/exact/form.hpp"
#include "model/exact/written_form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

constexpr int most_multiples = 16; // of u in sin(n*u), exp(n*u)

// c * rest with a rational c.
std::pair<numeric, ex> split(const ex& term) {
    numeric c = 1;
    ex rest = 1;
    const auto take = [&](const ex& factor) {
        if (factor.info(GiNaC::info_flags::rational))
            c *= GiNaC::ex_to<numeric>(factor);
        else
            rest *= factor;
    };
    if (GiNaC::is_a<GiNaC::mul>(term))
        for (const ex& factor : term) take(factor);
    else
        take(term);
    return {c, rest};
}

// term = multiple * unit with an integer multiple.
std::pair<int, ex> multiple_of(const ex& term) {
    const auto [c, rest] = split(term);
    const numeric size = GiNaC::abs(c.numer());
    const int sign = c.is_negative() ? -1 : 1;
    if (size > numeric(most_multiples)) return {sign, sign * term};
    return {sign * size.to_int(), rest / c.denom()};
}

bool is_plain(const ex& e) {
    return GiNaC::is_a<numeric>(e) || GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::constant>(e);
}

// A sum, a product, or a whole power.
bool is_rational_operation(const ex& e) {
    return GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e) ||
           (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer));
}

} // namespace

std::string ExactForm::text_of(const ex& e) { return written(*this, e); }

// Are all functions and roots in it converted already?
bool ExactForm::is_known(const ex& e) const {
    if (is_plain(e)) return true;
    if (is_rational_operation(e))
        return std::all_of(e.begin(), e.end(), [&](const ex& part) { return is_known(part); });
    return known_.count(e) != 0;
}

// New generators come in the order of the spelling of operands; without new ones, the order does not matter.
ex ExactForm::converted(const ex& e, bool in_order) {
    if (is_plain(e)) return e;
    in_order = in_order && !is_known(e);
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
        GiNaC::exvector parts;
        for (const ex& part : in_order ? operands(e) : std::vector<ex>(e.begin(), e.end()))
            parts.push_back(converted(part, in_order));
        return GiNaC::is_a<GiNaC::add>(e) ? ex(GiNaC::add(parts)) : ex(GiNaC::mul(parts));
    }
    if (is_rational_operation(e)) return GiNaC::pow(converted(e.op(0), in_order), e.op(1));
    if (const auto found = known_.find(e); found != known_.end()) return found->second;
    ex value;
    if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational)) {
        const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
        value = GiNaC::pow(root(converted(e.op(0)), exponent.denom().to_int()), exponent.numer());
    } else {
        value = function(e);
    }
    known_[e] = value;
    return value;
}

ex ExactForm::function(const ex& e) {
    if (is_named(e)) {
        const NamedCall call = named_call(e);
        const ex argument = simplified(call.argument);
        return generator(named_function(call.name, call.derivative, argument),
                         call.name + std::string(static_cast<std::size_t>(call.derivative), '\''), argument);
    }
    if (!GiNaC::is_a<GiNaC::function>(e) || e.nops() != 1)
        refuse({"an expression of a mechanism is made of rational powers and the known functions",
                excerpt(spell(e)), "write it in these", place_});
    const std::optional<Function> f = function_of(e);
    if (!f)
        refuse({"unknown function: neither an elementary one nor one under [functions]", excerpt(spell(e)),
                "write it with these", place_});
    const auto tangent = [](const Unit& unit) { return unit.sine / unit.cosine; };
    switch (*f) {
    case Function::sine: return angle(e.op(0)).sine;
    case Function::cosine: return angle(e.op(0)).cosine;
    case Function::exponential: return exponential(e.op(0));
    case Function::tangent: return tangent(angle(e.op(0)));
    case Function::hyperbolic_tangent: return tangent(angle(e.op(0), true));
    case Function::hyperbolic_sine: return angle(e.op(0), true).sine;
    case Function::hyperbolic_cosine: return angle(e.op(0), true).cosine;
    default: break;
    }
    const std::string name(row_of(*f).name);
    const Signed argument = signed_argument(e.op(0));
    if (row_of(*f).parity != Parity::odd)
        return argument.value.is_zero() ? e
                                        : generator(call(*f, argument.sign * argument.value), name, e.op(0));
    if (argument.value.is_zero()) return 0;
    return argument.sign * generator(call(*f, argument.value), name, argument.value);
}

ExactForm::Signed ExactForm::signed_argument(const ex& argument) {
    const Fraction f = fraction(argument);
    const ex numerator = meaning(f.numerator), denominator = meaning(f.denominator);
    const bool sum = GiNaC::is_a<GiNaC::add>(numerator);
    const bool negative =
        sum ? !canonical_sign(numerator).is_equal(numerator) : split(numerator).first.is_negative();
    return {negative ? -1 : 1, (negative ? (-numerator).expand() : numerator) / denominator};
}

ex ExactForm::generator(const ex& meaning, const std::string& name, const ex& argument) {
    if (GiNaC::is_a<numeric>(meaning) || GiNaC::is_a<GiNaC::constant>(meaning)) return meaning;
    if (!GiNaC::is_a<GiNaC::function>(meaning)) return converted(meaning); // it has a value: atan(1)
    if (const Generator* known = find(meaning)) return known->symbol;
    return add(meaning, name + "(" + text_of(argument) + ")").symbol;
}

// exp(a + 3*b/2) = exp(a)*exp(b/2)^3
ex ExactForm::exponential(const ex& argument) {
    const Fraction f = fraction(argument);
    ex product = 1;
    for (const ex& term : terms_of(f.numerator)) {
        if (term.is_zero()) continue;
        const auto [n, unit] = multiple_of(term / f.denominator);
        const ex value = meaning(unit);
        product *= GiNaC::pow(generator(GiNaC::exp(value), "exp", value), n);
    }
    return product;
}

// cos(u + v) and sin(u + v), or cosh and sinh.
ExactForm::Unit ExactForm::sum_of(const Unit& u, const Unit& v, bool hyperbolic) {
    return {u.cosine * v.cosine + (hyperbolic ? 1 : -1) * u.sine * v.sine,
            u.sine * v.cosine + u.cosine * v.sine};
}

ExactForm::Unit ExactForm::angle(const ex& argument, bool hyperbolic) {
    const Fraction f = fraction(argument);
    Unit total{1, 0};
    for (const ex& term : terms_of(f.numerator))
        if (!term.is_zero())
            total = sum_of(total, angle_of_term(term / f.denominator, hyperbolic), hyperbolic);
    return total;
}

ExactForm::Unit ExactForm::angle_of_term(const ex& term, bool hyperbolic) {
    if (const ex turn = term / GiNaC::Pi; !hyperbolic && turn.info(GiNaC::info_flags::rational))
        return angle_of_multiple_of_pi(GiNaC::ex_to<numeric>(turn));
    const auto [n, unit] = multiple_of(term);
    const ex inner = meaning(unit);
    const bool function = GiNaC::is_a<GiNaC::symbol>(unit) && GiNaC::is_a<GiNaC::function>(inner);
    const Unit once = !function    ? circle(inner, hyperbolic)
                      : hyperbolic ? unit_of_logarithm(inner)
                                   : unit_of_arc(inner);
    Unit total = once;
    for (int k = 1; k < std::abs(n); ++k) total = sum_of(total, once, hyperbolic);
    return {total.cosine, n < 0 ? -total.sine : total.sine};
}

// cos(atan(u)) = 1/sqrt(1 + u^2)
ExactForm::Unit ExactForm::unit_of_arc(const ex& function) {
    const std::optional<Function> f = function_of(function);
    if (f != Function::arc_tangent && f != Function::arc_sine) return circle(function);
    const ex u = converted(function.op(0));
    if (f == Function::arc_sine) return {root(1 - u * u, 2), u};
    const ex hypotenuse = root(1 + u * u, 2);
    return {1 / hypotenuse, u / hypotenuse};
}

// cosh(log(u)) = (u + 1/u)/2, cosh(asinh(u)) = sqrt(1 + u^2)
ExactForm::Unit ExactForm::unit_of_logarithm(const ex& function) {
    const std::optional<Function> f = function_of(function);
    if (f != Function::logarithm && f != Function::inverse_hyperbolic_sine &&
        f != Function::inverse_hyperbolic_cosine && f != Function::inverse_hyperbolic_tangent)
        return circle(function, true);
    const ex u = converted(function.op(0));
    if (f == Function::logarithm) return {(u + 1 / u) / 2, (u - 1 / u) / 2};
    if (f == Function::inverse_hyperbolic_sine) return {root(1 + u * u, 2), u};
    if (f == Function::inverse_hyperbolic_cosine) return {u, root(u * u - 1, 2)};
    const ex cosine = 1 / root(1 - u * u, 2);
    return {cosine, u * cosine};
}

ExactForm::Unit ExactForm::angle_of_multiple_of_pi(const numeric& multiple) {
    const ex angle = multiple * GiNaC::Pi;
    const ex cosine = GiNaC::cos(angle), sine = GiNaC::sin(angle);
    if (GiNaC::is_a<GiNaC::function>(cosine) || GiNaC::is_a<GiNaC::function>(sine)) return circle(angle);
    return {converted(cosine), converted(sine)};
}

ExactForm::Unit ExactForm::circle(const ex& argument, bool hyperbolic) {
    const ex sine = hyperbolic ? GiNaC::sinh(argument) : GiNaC::sin(argument);
    const ex cosine = hyperbolic ? GiNaC::cosh(argument) : GiNaC::cos(argument);
    if (find(sine) == nullptr) {
        const std::string end = (hyperbolic ? "h(" : "(") + text_of(argument) + ")";
        const std::size_t at = generators_.size();
        add(sine, "sin" + end);
        const GiNaC::symbol partner = add(cosine, "cos" + end).symbol;
        generators_[at].relation = Generator::Relation::square;
        generators_[at].value = (hyperbolic ? -1 : 1) * (1 - partner * partner);
        generators_[at].index = 2;
    }
    return {find(cosine)->symbol, find(sine)->symbol};
}

} // namespace resonform
