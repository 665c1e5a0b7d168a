// SPDX-License-Identifier: GPL-3.0-or-later
// The neutral form in which exact results are printed: sums of factored terms in a fixed order, before
// any notation (text, LaTeX, SymPy) spells them.
//
//   ring:     (2 G^-2 sigma^-10 r^2 v^3 xi - ...)/128
//   display:  1/128 * g^-1 v^3 xi (2 r^2 - xi^2) (r^2 + xi^2)^(-5/2)
//
// Roots are shown as rational powers of their radicands, symbols in the order of the user's file,
// polynomials by falling total degree.
#pragma once

#include "algebra/ring/ring.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

struct DisplaySum;

// base ^ exponent, exponent != 0.
struct DisplayFactor {
    enum class Kind {
        symbol,   // name with primes: psi''
        number,   // a rational under a root
        sum,      // (r^2 + xi^2): arguments[0]
        function, // name(arguments...), with primes if it is known by its name only
        integral, // of arguments[0] by arguments[1] from arguments[2] to arguments[3]
        power,    // arguments[0] ^ arguments[1], one base; its own exponent is 1
    };
    Kind kind = Kind::symbol;
    std::string name;
    int primes = 0;
    Rational number = 0;
    std::vector<DisplaySum> arguments;
    Rational exponent = 1;
};

// coefficient * [i] * factors * tail. Negative exponents among the factors go below the fraction bar;
// the tail follows the fraction: -xi/(4*(r^2 + xi^2)) * z1*xi'.
struct DisplayTerm {
    Rational coefficient = 1;
    int digits = 0; // > 0: the coefficient is printed as a decimal number with so many significant digits
    bool imaginary = false;
    std::vector<DisplayFactor> factors;
    std::vector<DisplayFactor> tail;
};

// No terms: zero.
struct DisplaySum {
    std::vector<DisplayTerm> terms;
};

DisplayFactor symbol_factor(const std::string& name, const Rational& exponent = 1); // "psi''": two primes
DisplayFactor function_factor(const std::string& name, DisplaySum argument);
bool is_elementary(const DisplayFactor& function); // sin, log, ...: else it is known by its name only
DisplayFactor sum_factor(DisplaySum sum, const Rational& exponent = 1); // in parentheses
DisplayFactor integral_factor(std::vector<DisplaySum> of);              // integrand, variable, from, to
DisplaySum factor_sum(DisplayFactor factor);                            // a sum of this one factor
DisplaySum term_sum(DisplayTerm term);                                  // of this one term
DisplaySum symbol_sum(const std::string& name);
DisplaySum function_of(const std::string& function, const std::string& name); // old(z1)
DisplaySum number_sum(const Rational& value);
bool same_base(const DisplayFactor& a, const DisplayFactor& b); // equal but for the exponent
bool same_but_coefficient(const DisplayTerm& a, const DisplayTerm& b);
DisplaySum operator+(DisplaySum a, const DisplaySum& b);
DisplaySum operator-(DisplaySum a);

// How generators are shown if not by their name: a primitive as its logarithm, ...
using Substitutes = std::map<GeneratorId, DisplayFactor>;

DisplaySum display(const Ring& ring, const Polynomial& p, const Substitutes& substitutes = {});

// p by monomials in `outer` with their coefficients, ordered by weight, then by exponents ascending in
// the order of `outer`: z1, z1*eps, z1*eps^2, z1^2*z2.
std::vector<std::pair<Monomial, Polynomial>> collect_in_order(const Ring& ring, const Polynomial& p,
                                                              const std::vector<GeneratorId>& outer);

// The same as a sum: each coefficient one term with the monomial as its tail.
DisplaySum display_collected(const Ring& ring, const Polynomial& p, const std::vector<GeneratorId>& outer,
                             const Substitutes& substitutes = {});

// factors *= sum; the sum goes before substitutes such as logarithms.
void insert_sum(std::vector<DisplayFactor>& factors, DisplaySum sum);

// +(a + b): a term that needs no parentheses inside a sum.
bool is_bare_sum(const DisplayTerm& term);

// A sum as one term: common powers and the rational content before a parenthesis.
DisplayTerm factored(DisplaySum sum);

} // namespace resonform
