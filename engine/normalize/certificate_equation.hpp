// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates an equation of the file, as the user wrote it, over an algebra of truncated series: the
// certificate runs it once with residues and once with bounds of degree and height.
//
// An Algebra has a type Value and
//   number(Rational), add(a, b), multiply(a, b), generator(id, power), function(Elementary, a)
//   power(a, exponent, lead): lead * (a / a_0)^exponent, where a_0 is the weight-0 part of a
//   inverse_power(a, n): a^-n for n >= 1
//   at_origin(a): a_0
#pragma once

#include "model/named_function.hpp"
#include "normalize/certificate_roots.hpp"

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace resonform {

enum class Elementary {
    exponential,
    logarithm,
    sine,
    cosine,
    tangent,
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    arc_sine,
    arc_tangent,
};

// Refuses with the equation as written, so that the message does not depend on GiNaC's order of terms.
[[noreturn]] void refuse_certificate(const std::string& rule, const Equation& equation);

Rational rational_of(const GiNaC::ex& number, const Equation& equation);       // refuses what is not rational
Elementary elementary_of(const GiNaC::ex& function, const Equation& equation); // refuses unknown functions

// What stands for the symbols of an equation; an angle is known by e^{i phi} and e^{-i phi}.
template <class Value> struct Substituted {
    struct Angle {
        GiNaC::symbol symbol;
        Value forward, backward;
    };
    std::map<GiNaC::ex, Value, GiNaC::ex_is_less> symbols; // look-up only
    std::vector<Angle> angles;
};

// k of an argument k phi + rest, an integer; the angle is taken out of `argument`. Refuses what is not one.
int take_out_harmonic(GiNaC::ex& argument, const GiNaC::symbol& angle, const Equation& equation);

template <class Algebra> class EquationEvaluator {
public:
    using Value = typename Algebra::Value;

    EquationEvaluator(Algebra& algebra, CertificateRoots& roots, const Substituted<Value>& values,
                      const Equation& equation)
        : algebra_(algebra), roots_(roots), values_(values), equation_(equation) {}

    Value operator()(const GiNaC::ex& e) {
        if (GiNaC::is_a<GiNaC::numeric>(e)) return algebra_.number(rational_of(e, equation_));
        if (GiNaC::is_a<GiNaC::symbol>(e) || e.is_equal(GiNaC::Pi)) return symbol(e);
        if (GiNaC::is_a<GiNaC::add>(e)) return sum(e);
        if (GiNaC::is_a<GiNaC::mul>(e)) return product(e);
        if (GiNaC::is_a<GiNaC::power>(e)) return power(e.op(0), rational_of(e.op(1), equation_));
        if (GiNaC::is_a<GiNaC::function>(e)) return function(e);
        refuse_certificate("an equation is built from numbers, names, powers and elementary functions",
                           equation_);
    }

private:
    Value symbol(const GiNaC::ex& e) const {
        if (const auto id = roots_.generator_of(e)) return algebra_.generator(*id, 1);
        const auto found = values_.symbols.find(e);
        if (found == values_.symbols.end())
            refuse_certificate("equations contain parameters, eps, slow and fast variables, sines and "
                               "cosines of angles and, of drift variables, the rate only",
                               equation_);
        return found->second;
    }

    Value function(const GiNaC::ex& e) {
        GiNaC::ex argument = e.op(0);
        Value forward = algebra_.number(1), backward = forward; // e^{+-i sum k phi}
        bool turns = false;
        for (const auto& angle : values_.angles) {
            if (!argument.has(angle.symbol)) continue;
            const int k = take_out_harmonic(argument, angle.symbol, equation_);
            if (k == 0) continue;
            turns = true;
            const Value p = natural_power(angle.forward, std::abs(k)),
                        q = natural_power(angle.backward, std::abs(k));
            forward = algebra_.multiply(forward, k > 0 ? p : q);
            backward = algebra_.multiply(backward, k > 0 ? q : p);
        }
        if (!turns) return without_angles(e);
        const Elementary name = is_named(e) ? Elementary::exponential : elementary_of(e, equation_);
        if (name != Elementary::sine && name != Elementary::cosine)
            refuse_certificate("angles stand in sines and cosines", equation_);
        return harmonic(name, forward, backward, argument);
    }

    // cos(a + u) = (e^{ia} (cos u + i sin u) + e^{-ia} (cos u - i sin u))/2, and the sine likewise.
    Value harmonic(Elementary name, const Value& forward, const Value& backward, const GiNaC::ex& u) {
        const Value i = algebra_.generator(Ring::imaginary_unit, 1), minus = algebra_.number(-1);
        const Value cosine = (*this)(GiNaC::cos(u));
        const Value sine = algebra_.multiply(i, (*this)(GiNaC::sin(u)));
        const Value turned = algebra_.multiply(forward, algebra_.add(cosine, sine));
        const Value back = algebra_.multiply(backward, difference(cosine, sine));
        const Value half = algebra_.number(Rational(1) / 2);
        if (name == Elementary::cosine) return algebra_.multiply(half, algebra_.add(turned, back));
        return algebra_.multiply(algebra_.multiply(minus, i),
                                 algebra_.multiply(half, difference(turned, back)));
    }

    // Residues do not depend on the order of terms, and sorting them would take longer than adding them.
    Value sum(const GiNaC::ex& e) {
        Value result = (*this)(e.op(0));
        for (std::size_t k = 1; k < e.nops(); ++k) result = algebra_.add(result, (*this)(e.op(k)));
        return result;
    }

    Value product(const GiNaC::ex& e) {
        Value result = (*this)(e.op(0));
        for (std::size_t k = 1; k < e.nops(); ++k) result = algebra_.multiply(result, (*this)(e.op(k)));
        return result;
    }

    Value power(const GiNaC::ex& base, const Rational& exponent) {
        const Value value = (*this)(base);
        if (cln::denominator(exponent) != 1) {
            const Radical& radical = roots_.resolve(base, exponent, equation_);
            Value lead =
                algebra_.multiply(algebra_.number(radical.number), algebra_.at_origin((*this)(radical.rest)));
            for (const auto& [id, n] : radical.roots)
                lead = algebra_.multiply(lead, algebra_.generator(id, n));
            return algebra_.power(value, exponent, lead);
        }
        const int n = cln::cl_I_to_int(cln::numerator(exponent));
        return n < 0 ? algebra_.inverse_power(value, -n) : natural_power(value, n);
    }

    // f(u_0 + r) by addition theorems: f(u_0) from the generators of the ring, f(r) by its Taylor sum.
    Value without_angles(const GiNaC::ex& e) {
        const GiNaC::ex origin = roots_.at_origin(e.op(0), equation_);
        const Value u = (*this)(e.op(0));
        const Value rest = difference(u, algebra_.at_origin(u));
        if (is_named(e)) return named(named_call(e), rest);
        const Elementary name = elementary_of(e, equation_);
        if (origin.is_zero() && name != Elementary::logarithm) return algebra_.function(name, rest);
        const auto at_origin = [&](const GiNaC::ex& f) { return value_at_origin(f); };
        const GiNaC::ex& argument = e.op(0);
        const auto sine = [&] {
            return algebra_.add(algebra_.multiply(at_origin(GiNaC::sin(argument)),
                                                  algebra_.function(Elementary::cosine, rest)),
                                algebra_.multiply(at_origin(GiNaC::cos(argument)),
                                                  algebra_.function(Elementary::sine, rest)));
        };
        const auto cosine = [&] {
            return difference(algebra_.multiply(at_origin(GiNaC::cos(argument)),
                                                algebra_.function(Elementary::cosine, rest)),
                              algebra_.multiply(at_origin(GiNaC::sin(argument)),
                                                algebra_.function(Elementary::sine, rest)));
        };
        const auto exponential = [&] {
            return algebra_.multiply(at_origin(GiNaC::exp(argument)),
                                     algebra_.function(Elementary::exponential, rest));
        };
        const Value half = algebra_.number(Rational(1) / 2);
        switch (name) {
        case Elementary::sine: return sine();
        case Elementary::cosine: return cosine();
        case Elementary::tangent: return quotient(sine(), cosine());
        case Elementary::exponential: return exponential();
        case Elementary::hyperbolic_sine:
        case Elementary::hyperbolic_cosine:
        case Elementary::hyperbolic_tangent: {
            const Value up = exponential(), down = algebra_.inverse_power(up, 1);
            const Value s = algebra_.multiply(half, difference(up, down));
            const Value c = algebra_.multiply(half, algebra_.add(up, down));
            return name == Elementary::hyperbolic_sine     ? s
                   : name == Elementary::hyperbolic_cosine ? c
                                                           : quotient(s, c);
        }
        case Elementary::logarithm: // log(u_0) + log(u/u_0)
            return algebra_.add(at_origin(GiNaC::log(argument)),
                                algebra_.function(name, quotient(u, algebra_.at_origin(u))));
        case Elementary::arc_tangent: // atan(u_0) + atan((u - u_0)/(1 + u_0 u))
            return algebra_.add(
                at_origin(GiNaC::atan(argument)),
                algebra_.function(name,
                                  quotient(rest, algebra_.add(algebra_.number(1),
                                                              algebra_.multiply(algebra_.at_origin(u), u)))));
        case Elementary::arc_sine: break;
        }
        // asin(u_0) + asin(u sqrt(1 - u_0^2) - u_0 sqrt(1 - u^2))
        const Value root = power(1 - argument * argument, Rational(1) / 2);
        return algebra_.add(
            at_origin(GiNaC::asin(argument)),
            algebra_.function(name, difference(algebra_.multiply(u, algebra_.at_origin(root)),
                                               algebra_.multiply(algebra_.at_origin(u), root))));
    }

    // sum_k f^(k)(u_0) r^k / k!, as far as the ring has derivatives.
    Value named(const NamedCall& call, const Value& rest) {
        Value total = algebra_.number(0), power = algebra_.number(1);
        Rational factorial = 1;
        const GiNaC::ex& u = call.argument;
        for (int k = 0; roots_.knows(call.name, call.derivative + k); ++k) {
            if (k > 0) {
                power = algebra_.multiply(power, rest);
                factorial = factorial * k;
            }
            const Value slope = value_at_origin(named_function(call.name, call.derivative + k, u));
            total = algebra_.add(
                total, algebra_.multiply(algebra_.number(1 / factorial), algebra_.multiply(slope, power)));
        }
        return total;
    }

    // Of a function at weight 0; a slow variable there is the new one.
    Value value_at_origin(const GiNaC::ex& f) {
        return algebra_.at_origin((*this)(roots_.at_origin(f, equation_)));
    }

    Value difference(const Value& a, const Value& b) {
        return algebra_.add(a, algebra_.multiply(algebra_.number(-1), b));
    }
    Value quotient(const Value& a, const Value& b) {
        return algebra_.multiply(a, algebra_.inverse_power(b, 1));
    }

    Value natural_power(Value base, int exponent) {
        Value result = algebra_.number(1);
        for (; exponent > 0; exponent /= 2) {
            if (exponent % 2 != 0) result = algebra_.multiply(result, base);
            if (exponent > 1) base = algebra_.multiply(base, base);
        }
        return result;
    }

    Algebra& algebra_;
    CertificateRoots& roots_;
    const Substituted<Value>& values_;
    const Equation& equation_;
};

} // namespace resonform
