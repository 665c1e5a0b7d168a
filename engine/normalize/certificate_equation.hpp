// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates an equation of the file, as the user wrote it, over an algebra of truncated series: the
// certificate runs it once with residues and once with bounds of degree and height.
//
// An Algebra has a type Value and
//   number(Rational), add(a, b), multiply(a, b), generator(id, power), function(Elementary, a)
//   power(a, exponent, lead): lead * (a / a_0)^exponent, where a_0 is the weight-0 part of a
//   inverse_power(a, n): a^-n for n >= 1
#pragma once

#include "model/canonical.hpp"
#include "normalize/certificate_roots.hpp"

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

template <class Value> using SymbolValues = std::map<GiNaC::ex, Value, GiNaC::ex_is_less>;

template <class Algebra> class EquationEvaluator {
public:
    using Value = typename Algebra::Value;

    EquationEvaluator(Algebra& algebra, CertificateRoots& roots, const SymbolValues<Value>& symbols,
                      const Equation& equation)
        : algebra_(algebra), roots_(roots), symbols_(symbols), equation_(equation) {}

    Value operator()(const GiNaC::ex& e) {
        if (GiNaC::is_a<GiNaC::numeric>(e)) return algebra_.number(rational_of(e, equation_));
        if (GiNaC::is_a<GiNaC::symbol>(e)) return symbol(e);
        if (GiNaC::is_a<GiNaC::add>(e)) return sum(e);
        if (GiNaC::is_a<GiNaC::mul>(e)) return product(e);
        if (GiNaC::is_a<GiNaC::power>(e)) return power(e.op(0), rational_of(e.op(1), equation_));
        if (GiNaC::is_a<GiNaC::function>(e))
            return algebra_.function(elementary_of(e, equation_), (*this)(e.op(0)));
        refuse_certificate("an equation is built from numbers, names, powers and elementary functions",
                           equation_);
    }

private:
    Value symbol(const GiNaC::ex& e) const {
        const auto found = symbols_.find(e);
        if (found == symbols_.end())
            refuse_certificate("equations contain parameters, eps, slow and fast variables and, of drift "
                               "variables, the rate only",
                               equation_);
        return found->second;
    }

    Value sum(const GiNaC::ex& e) {
        const std::vector<GiNaC::ex> terms = operands(e);
        Value result = (*this)(terms.front());
        for (std::size_t k = 1; k < terms.size(); ++k) result = algebra_.add(result, (*this)(terms[k]));
        return result;
    }

    Value product(const GiNaC::ex& e) {
        const std::vector<GiNaC::ex> factors = operands(e);
        Value result = (*this)(factors.front());
        for (std::size_t k = 1; k < factors.size(); ++k)
            result = algebra_.multiply(result, (*this)(factors[k]));
        return result;
    }

    Value power(const GiNaC::ex& base, const Rational& exponent) {
        const Value value = (*this)(base);
        if (cln::denominator(exponent) != 1) {
            const Radical& radical = roots_.resolve(base, exponent, equation_);
            Value lead = algebra_.multiply(algebra_.number(radical.number), (*this)(radical.rest));
            for (const auto& [id, n] : radical.roots)
                lead = algebra_.multiply(lead, algebra_.generator(id, n));
            return algebra_.power(value, exponent, lead);
        }
        const int n = cln::cl_I_to_int(cln::numerator(exponent));
        return n < 0 ? algebra_.inverse_power(value, -n) : natural_power(value, n);
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
    const SymbolValues<Value>& symbols_;
    const Equation& equation_;
};

} // namespace resonform
