// SPDX-License-Identifier: GPL-3.0-or-later
// Along the motion the near-identity map must stay near the identity (docs/theory.md, "And where it goes"):
// an evaluator ends where the first corrections of a mode are half of the amplitudes that they are made of,
//
//   2 sum |coefficient| eps^n prod |a_k|^p_k  <  |a|          z_k = eps^w_k a_k
//
// x'' + x + x^3 = 0:   h = -w^3/16 + 3/16 w wbar^2 + wbar^3/32,   2 (9/32) eps^2 |a|^2 < 1
//
// No phase is in it, so that it is smooth in slow time but where a coefficient vanishes. What is forced is in
// h and has no mode in it: it is left out.
#pragma once

#include "solve/solution.hpp"

#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace resonform {

struct FirstCorrection {
    std::string name;               // of the user's variable
    std::vector<std::size_t> modes; // whose |a_k| the terms hold, the mode itself among them
    std::vector<int> powers_of_eps; // of each of them, over that of the largest
    struct Term {                   // coefficient eps^power_of_eps prod |a_k|^powers_k
        std::vector<int> powers;    // in the order of modes; a single one is divided out
        int power_of_eps;
        Polynomial coefficient; // in the ring of the solution
    };
    std::vector<Term> terms;
};

// Of quadratic and cubic terms those of the lowest weight each, and of all terms beyond linear ones those of
// the lowest weight; no mode without such terms. (Linear ones have divisors that move, with layers of their
// own.) For closed solutions the factor of the amplitude is one more: 2 |F - 1| < 1.
std::vector<FirstCorrection> first_corrections(const Solution& solution);

// Of a closed solution: C E, the leading part of the modulus over eps.
Polynomial leading_modulus(const Solution& solution);

// Whether a quadrature of a closed solution stands in it.
bool needs_quadratures(const Solution& solution, const FirstCorrection& correction);

// What must be > 0. Algebra: rational, add, multiply, power and hypot. moduli: of every mode of the field;
// coefficients: |coefficient| of each term.
template <class Algebra, class Real>
Real margin_of(const Algebra& algebra, const FirstCorrection& correction, const Real& eps,
               const std::vector<Real>& moduli, const std::vector<Real>& coefficients) {
    Real size = algebra.rational(Rational(1));
    if (correction.modes.size() > 1) {
        size = algebra.rational(Rational(0));
        for (std::size_t k = 0; k < correction.modes.size(); ++k)
            size = algebra.hypot(size, algebra.multiply({algebra.power(eps, correction.powers_of_eps[k]),
                                                         moduli[correction.modes[k]]}));
        const Rational none = cln::expt(Rational(2), -100); // where all are at rest, nothing is large
        size = algebra.add({size, algebra.rational(none)});
    }
    std::map<int, std::vector<Real>> by_power;
    for (std::size_t n = 0; n < coefficients.size(); ++n) {
        const FirstCorrection::Term& term = correction.terms[n];
        std::vector<Real> factors{coefficients[n]};
        for (std::size_t k = 0; k < correction.modes.size(); ++k)
            factors.push_back(algebra.power(moduli[correction.modes[k]], term.powers[k]));
        by_power[term.power_of_eps].push_back(algebra.multiply(factors));
    }
    Real sum = algebra.rational(Rational(0));
    for (auto group = by_power.rbegin(); group != by_power.rend(); ++group) {
        group->second.push_back(sum);
        const int power = group->first - (std::next(group) == by_power.rend() ? 0 : std::next(group)->first);
        sum = algebra.multiply({algebra.power(eps, power), algebra.add(group->second)});
    }
    return algebra.add({size, algebra.multiply({algebra.rational(Rational(-2)), sum})});
}

} // namespace resonform
