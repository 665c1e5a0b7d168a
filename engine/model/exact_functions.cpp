// SPDX-License-Identifier: GPL-3.0-or-later
// Functions on their way into an exact form.
#include "model/canonical.hpp"
#include "model/exact_form.hpp"
#include "model/named_function.hpp"
#include "model/written_form.hpp"

#include <utility>

namespace resonform {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

constexpr int most_multiples = 16; // of u in sin(n*u), exp(n*u)

std::vector<ex> terms_of(const ex& sum) {
    if (GiNaC::is_a<GiNaC::add>(sum)) return operands(sum);
    return {sum};
}

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

std::string name_of(const ex& function) { return GiNaC::ex_to<GiNaC::function>(function).get_name(); }

} // namespace

std::string ExactForm::text_of(const ex& e) { return written(*this, e); }

ex ExactForm::converted(const ex& e) {
    if (GiNaC::is_a<numeric>(e) || GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::constant>(e)) return e;
    if (GiNaC::is_a<GiNaC::add>(e)) {
        ex sum = 0;
        for (const ex& part : operands(e)) sum += converted(part);
        return sum;
    }
    if (GiNaC::is_a<GiNaC::mul>(e)) {
        ex product = 1;
        for (const ex& part : operands(e)) product *= converted(part);
        return product;
    }
    if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational)) {
        const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
        const ex base = converted(e.op(0));
        if (exponent.is_integer()) return GiNaC::pow(base, exponent);
        return GiNaC::pow(root(base, exponent.denom().to_int()), exponent.numer());
    }
    return function(e);
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
                excerpt(spell(e)),
                "write it in these",
                {}});
    const std::string name = name_of(e);
    if (name == "sin") return angle(e.op(0)).sine;
    if (name == "cos") return angle(e.op(0)).cosine;
    if (name == "exp") return exponential(e.op(0));
    if (name == "tan") {
        const Unit unit = angle(e.op(0));
        return unit.sine / unit.cosine;
    }
    const Signed argument = signed_argument(e.op(0));
    if (argument.value.is_zero()) return name == "cosh" ? 1 : name == "log" ? e : ex(0);
    if (name == "log") return generator(GiNaC::log(argument.sign * argument.value), name, e.op(0));
    if (name == "asin") return argument.sign * generator(GiNaC::asin(argument.value), name, argument.value);
    if (name == "atan") return argument.sign * generator(GiNaC::atan(argument.value), name, argument.value);
    const Unit unit = circle(argument.value, true);
    if (name == "cosh") return unit.cosine;
    return argument.sign * (name == "sinh" ? unit.sine : unit.sine / unit.cosine);
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

ExactForm::Unit ExactForm::angle(const ex& argument) {
    const Fraction f = fraction(argument);
    Unit total{1, 0};
    for (const ex& term : terms_of(f.numerator)) {
        if (term.is_zero()) continue;
        const Unit unit = angle_of_term(term / f.denominator);
        total = {total.cosine * unit.cosine - total.sine * unit.sine,
                 total.sine * unit.cosine + total.cosine * unit.sine};
    }
    return total;
}

ExactForm::Unit ExactForm::angle_of_term(const ex& term) {
    if (const ex turn = term / GiNaC::Pi; turn.info(GiNaC::info_flags::rational))
        return angle_of_multiple_of_pi(GiNaC::ex_to<numeric>(turn));
    const auto [n, unit] = multiple_of(term);
    const ex inner = meaning(unit);
    Unit once;
    if (GiNaC::is_a<GiNaC::symbol>(unit) && GiNaC::is_a<GiNaC::function>(inner) && name_of(inner) == "atan") {
        const ex u = converted(inner.op(0)), hypotenuse = root(1 + u * u, 2);
        once = {1 / hypotenuse, u / hypotenuse};
    } else if (GiNaC::is_a<GiNaC::symbol>(unit) && GiNaC::is_a<GiNaC::function>(inner) &&
               name_of(inner) == "asin") {
        const ex u = converted(inner.op(0));
        once = {root(1 - u * u, 2), u};
    } else {
        once = circle(inner);
    }
    Unit total = once;
    for (int k = 1; k < std::abs(n); ++k)
        total = {total.cosine * once.cosine - total.sine * once.sine,
                 total.sine * once.cosine + total.cosine * once.sine};
    return {total.cosine, n < 0 ? -total.sine : total.sine};
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
    const std::string end = (hyperbolic ? "h(" : "(") + text_of(argument) + ")";
    if (find(sine) == nullptr) {
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
