// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/equation.hpp"

#include "algebra/number/taylor_law.hpp"

#include <cstdlib>
#include <utility>

namespace resonform {

namespace {

// For an argument k phi + rest: returns k, leaves `rest` in `argument`. Refuses a k that is no small integer.
int take_out_harmonic(GiNaC::ex& argument, const GiNaC::symbol& angle, const Equation& equation) {
    constexpr int highest_harmonic = 1000;
    const GiNaC::ex k = argument.diff(angle).expand();
    if (k.is_zero()) return 0;
    if (!k.info(GiNaC::info_flags::integer) || GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(k)) > highest_harmonic)
        refuse_certificate("angles occur in integer combinations", equation);
    argument = (argument - k * angle).expand();
    return GiNaC::ex_to<GiNaC::numeric>(k).to_int();
}

class EquationWriter {
public:
    EquationWriter(CertificateProgram& program, CertificateRoots& roots, const Substituted& values,
                   const Equation& equation)
        : program_(program), roots_(roots), values_(values), equation_(equation) {}

    Slot operator()(const GiNaC::ex& e) {
        if (GiNaC::is_a<GiNaC::numeric>(e)) return program_.number(rational_of(e, equation_));
        if (GiNaC::is_a<GiNaC::symbol>(e) || e.is_equal(GiNaC::Pi)) return symbol(e);
        if (GiNaC::is_a<GiNaC::add>(e)) return sum(e);
        if (GiNaC::is_a<GiNaC::mul>(e)) return product(e);
        if (GiNaC::is_a<GiNaC::power>(e)) return power(e.op(0), rational_of(e.op(1), equation_));
        if (GiNaC::is_a<GiNaC::function>(e)) return function(e);
        refuse_certificate("an equation is built from numbers, names, powers and elementary functions",
                           equation_);
    }

private:
    Slot symbol(const GiNaC::ex& e) const {
        if (const auto id = roots_.generator_of(e)) return program_.generator(*id, 1);
        const auto found = values_.symbols.find(e);
        if (found == values_.symbols.end())
            refuse_certificate("equations contain parameters, eps, slow and fast variables, sines and "
                               "cosines of angles and, of drift variables, the rate only",
                               equation_);
        return found->second;
    }

    Slot function(const GiNaC::ex& e) {
        GiNaC::ex argument = e.op(0);
        Slot forward = program_.number(1), backward = forward; // e^{+-i sum k phi}
        bool turns = false;
        for (const auto& angle : values_.angles) {
            if (!argument.has(angle.symbol)) continue;
            const int k = take_out_harmonic(argument, angle.symbol, equation_);
            if (k == 0) continue;
            turns = true;
            const Slot p = natural_power(angle.forward, std::abs(k)),
                       q = natural_power(angle.backward, std::abs(k));
            forward = program_.multiply(forward, k > 0 ? p : q);
            backward = program_.multiply(backward, k > 0 ? q : p);
        }
        if (!turns) return without_angles(e);
        const Function name = is_named(e) ? Function::exponential : elementary_of(e, equation_);
        if (name != Function::sine && name != Function::cosine)
            refuse_certificate("angles stand in sines and cosines", equation_);
        return harmonic(name, forward, backward, argument);
    }

    // cos(a + u) = (e^{ia} (cos u + i sin u) + e^{-ia} (cos u - i sin u))/2, and the sine likewise.
    Slot harmonic(Function name, Slot forward, Slot backward, const GiNaC::ex& u) {
        const Slot i = program_.generator(Ring::imaginary_unit, 1), minus = program_.number(-1);
        const Slot cosine = (*this)(GiNaC::cos(u));
        const Slot sine = program_.multiply(i, (*this)(GiNaC::sin(u)));
        const Slot turned = program_.multiply(forward, program_.add(cosine, sine));
        const Slot back = program_.multiply(backward, program_.difference(cosine, sine));
        const Slot half = program_.number(Rational(1) / 2);
        if (name == Function::cosine) return program_.multiply(half, program_.add(turned, back));
        return program_.multiply(program_.multiply(minus, i),
                                 program_.multiply(half, program_.difference(turned, back)));
    }

    // Residues do not depend on the order of terms, and sorting them would take longer than adding them.
    Slot sum(const GiNaC::ex& e) {
        Slot result = (*this)(e.op(0));
        for (std::size_t k = 1; k < e.nops(); ++k) result = program_.add(result, (*this)(e.op(k)));
        return result;
    }

    Slot product(const GiNaC::ex& e) {
        Slot result = (*this)(e.op(0));
        for (std::size_t k = 1; k < e.nops(); ++k) result = program_.multiply(result, (*this)(e.op(k)));
        return result;
    }

    Slot power(const GiNaC::ex& base, const Rational& exponent) {
        const Slot value = (*this)(base);
        if (cln::denominator(exponent) != 1) {
            const Radical& radical = roots_.resolve(base, exponent, equation_);
            Slot lead =
                program_.multiply(program_.number(radical.number), program_.at_origin((*this)(radical.rest)));
            for (const auto& [id, n] : radical.roots)
                lead = program_.multiply(lead, program_.generator(id, n));
            return program_.power(value, exponent, lead);
        }
        const int n = cln::cl_I_to_int(cln::numerator(exponent));
        return n < 0 ? program_.inverse_power(value, -n) : natural_power(value, n);
    }

    // f(u_0 + r) by addition theorems: f(u_0) from the generators of the ring, f(r) by its Taylor sum.
    Slot without_angles(const GiNaC::ex& e) {
        const GiNaC::ex origin = roots_.at_origin(e.op(0), equation_);
        const Slot u = (*this)(e.op(0));
        const Slot rest = program_.difference(u, program_.at_origin(u));
        if (is_named(e)) return named(named_call(e), rest);
        const Function name = elementary_of(e, equation_);
        if (origin.is_zero() && has_taylor_law(name)) return program_.function(name, rest);
        const auto at_origin = [&](const GiNaC::ex& f) { return value_at_origin(f); };
        const GiNaC::ex& argument = e.op(0);
        const auto sine = [&] {
            return program_.add(
                program_.multiply(at_origin(GiNaC::sin(argument)), program_.function(Function::cosine, rest)),
                program_.multiply(at_origin(GiNaC::cos(argument)), program_.function(Function::sine, rest)));
        };
        const auto cosine = [&] {
            return program_.difference(
                program_.multiply(at_origin(GiNaC::cos(argument)), program_.function(Function::cosine, rest)),
                program_.multiply(at_origin(GiNaC::sin(argument)), program_.function(Function::sine, rest)));
        };
        const auto exponential = [&] {
            return program_.multiply(at_origin(GiNaC::exp(argument)),
                                     program_.function(Function::exponential, rest));
        };
        const Slot half = program_.number(Rational(1) / 2);
        switch (name) {
        case Function::sine: return sine();
        case Function::cosine: return cosine();
        case Function::tangent: return quotient(sine(), cosine());
        case Function::exponential: return exponential();
        case Function::hyperbolic_sine:
        case Function::hyperbolic_cosine:
        case Function::hyperbolic_tangent: {
            const Slot up = exponential(), down = program_.inverse_power(up, 1);
            const Slot s = program_.multiply(half, program_.difference(up, down));
            const Slot c = program_.multiply(half, program_.add(up, down));
            return name == Function::hyperbolic_sine     ? s
                   : name == Function::hyperbolic_cosine ? c
                                                         : quotient(s, c);
        }
        case Function::logarithm: // log(u_0) + log(u/u_0)
            return program_.add(at_origin(GiNaC::log(argument)),
                                program_.function(name, quotient(u, program_.at_origin(u))));
        case Function::arc_tangent: // atan(u_0) + atan((u - u_0)/(1 + u_0 u))
            return program_.add(
                at_origin(GiNaC::atan(argument)),
                program_.function(name,
                                  quotient(rest, program_.add(program_.number(1),
                                                              program_.multiply(program_.at_origin(u), u)))));
        case Function::arc_sine: break;
        default:
            return program_.add(at_origin(e), program_.integral(u, (*this)(known_slope(name, argument))));
        }
        // asin(u_0) + asin(u sqrt(1 - u_0^2) - u_0 sqrt(1 - u^2))
        const Slot root = power(1 - argument * argument, Rational(1) / 2);
        return program_.add(
            at_origin(GiNaC::asin(argument)),
            program_.function(name, program_.difference(program_.multiply(u, program_.at_origin(root)),
                                                        program_.multiply(program_.at_origin(u), root))));
    }

    // sum_k f^(k)(u_0) r^k / k!, as far as the ring has derivatives.
    Slot named(const NamedCall& call, Slot rest) {
        Slot total = program_.number(0), power = program_.number(1);
        Rational factorial = 1;
        const GiNaC::ex& u = call.argument;
        for (int k = 0;; ++k) {
            const GiNaC::ex slope_at_u = named_function(call.name, call.derivative + k, u);
            if (!roots_.knows(slope_at_u, equation_)) return total;
            if (k > 0) {
                power = program_.multiply(power, rest);
                factorial = factorial * k;
            }
            const Slot slope = value_at_origin(slope_at_u);
            total = program_.add(
                total, program_.multiply(program_.number(1 / factorial), program_.multiply(slope, power)));
        }
    }

    // The value of f at weight 0; a slow variable in it is the new one.
    Slot value_at_origin(const GiNaC::ex& f) {
        return program_.at_origin((*this)(roots_.at_origin(f, equation_)));
    }

    Slot quotient(Slot a, Slot b) { return program_.multiply(a, program_.inverse_power(b, 1)); }

    Slot natural_power(Slot base, int exponent) {
        Slot result = program_.number(1);
        for (; exponent > 0; exponent /= 2) {
            if (exponent % 2 != 0) result = program_.multiply(result, base);
            if (exponent > 1) base = program_.multiply(base, base);
        }
        return result;
    }

    CertificateProgram& program_;
    CertificateRoots& roots_;
    const Substituted& values_;
    const Equation& equation_;
};

} // namespace

Slot substitute(CertificateProgram& program, CertificateRoots& roots, const Substituted& values,
                const Equation& equation, const GiNaC::ex& e) {
    return EquationWriter(program, roots, values, equation)(e);
}

} // namespace resonform
