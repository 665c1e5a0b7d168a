// SPDX-License-Identifier: GPL-3.0-or-later
// Along the motion the near-identity map must stay near the identity (docs/theory.md, "And where it goes"):
// an evaluator stops where the first corrections of a mode reach half of the amplitudes they are made of,
//
//   2 sum |coefficient| eps^n prod |a_k|^p_k  <  |a|          z_k = eps^w_k a_k
//
// x'' + x + x^3 = 0:   h = -w^3/16 + 3/16 w wbar^2 + wbar^3/32,   2 (9/32) eps^2 |a|^2 < 1
//
// The condition contains no phase, so it is smooth in slow time except where a coefficient vanishes. Forced
// terms of h, which contain no mode, do not grow with |a|. But where the equations are not linear in the fast
// variables, the forced terms f_j of lowest weight must be small together, as the weight w of the mode
// assumes:
//
//   sum |f_j|  <  2 (1 + |a|)                       z = eps^w (a e^{i theta} + f_j e^{i ...} + ...)
//
// Functions of a driven slow variable xi = zeta + k are expanded about zeta, functions of an angle
// phi = theta + m about theta. With p a declared variable, or a radicand or denominator of the equations:
//
//   2 sum_alpha |d^alpha p/dzeta^alpha| prod_j |k_j|^alpha_j / alpha!  <  |p(zeta)|,     2 |m|  <  1
//
// with 1 <= |alpha| <= 4. Of k and m, each product of modes counts with its terms of lowest weight, including
// terms without a mode or linear in one. Then p at the old xi keeps its sign for every phase.
// (The small divisors of the normalisation are functions of zeta already.)
#pragma once

#include "solve/solution.hpp"

#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

struct FirstCorrection {
    std::string name;               // of the user's variable
    std::vector<std::size_t> modes; // whose |a_k| the terms hold, the mode itself among them
    std::vector<int> powers_of_eps; // of each of them, over that of the largest
    struct Term {                   // coefficient eps^power_of_eps prod |a_k|^powers_k
        std::vector<int> powers;    // in the order of modes; a single mode has one |a| divided out
        int power_of_eps;
        Polynomial coefficient; // in the ring of the solution
    };
    std::vector<std::vector<Term>> sums; // one; of a quantity: |k_j| of each slow variable that moves it
    std::optional<Polynomial> quantity;  // right-hand side: p, or 1; nullopt: moduli of modes
    struct Slope {                       // coefficient prod sums_j^powers_j
        std::vector<int> powers;
        Polynomial coefficient;
    };
    std::vector<Slope> slopes; // of a quantity; none: the sum itself
    bool forced = false;       // of terms without a mode, each a quarter of f_j: 2 sum < 1 + |a|

    // Coefficients of terms, then of slopes, then the quantity: margin_of takes their absolute values.
    [[nodiscard]] std::vector<Polynomial> polynomials() const;
};

// For each mode with nonlinear terms: its quadratic and its cubic terms of lowest weight, and of all
// nonlinear terms those of lowest weight. (Linear terms have divisors that move, with layers of their own.)
// Then those of forced terms, of angles and of slow variables. A closed solution has one more, for the factor
// of the amplitude: 2 |F - 1| < 1.
std::vector<FirstCorrection> first_corrections(const Solution& solution);

// Those of modes among which one decays, which along the motion count without it: they are asked for at the
// start. y' = -2 y + u^2, u' = -k u: y = z_2 + z_1^2/(2 - 2 k), which is no small correction for k = 1.001.
std::vector<FirstCorrection> transient_corrections(const Solution& solution);

// Of a closed solution: C E, the leading part of the modulus over eps.
Polynomial leading_modulus(const Solution& solution);

// Whether the correction or the leading modulus contains a quadrature of a closed solution.
bool needs_quadratures(const Solution& solution, const FirstCorrection& correction);

// eps^power_of_eps |coefficient| prod |a_k|^powers_k, summed by Horner's rule in eps; advances `sizes`.
template <class Algebra, class Real>
Real sum_of_terms(const Algebra& algebra, const FirstCorrection& correction,
                  const std::vector<FirstCorrection::Term>& terms, const Real& eps,
                  const std::vector<Real>& moduli, typename std::vector<Real>::const_iterator& sizes) {
    std::map<int, std::vector<Real>> by_power;
    for (const FirstCorrection::Term& term : terms) {
        std::vector<Real> factors{*sizes++};
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
    return sum;
}

// Right-hand side minus left-hand side, which must be > 0. Algebra: rational, add, multiply, power and hypot.
// moduli: of every mode of the field; sizes: |p| of each of correction.polynomials().
template <class Algebra, class Real>
Real margin_of(const Algebra& algebra, const FirstCorrection& correction, const Real& eps,
               const std::vector<Real>& moduli, const std::vector<Real>& sizes) {
    Real size = correction.quantity ? sizes.back() : algebra.rational(Rational(1));
    if (correction.forced) size = algebra.add({size, moduli[correction.modes.front()]});
    if (!correction.quantity && correction.modes.size() > 1) {
        size = algebra.rational(Rational(0));
        for (std::size_t k = 0; k < correction.modes.size(); ++k)
            size = algebra.hypot(size, algebra.multiply({algebra.power(eps, correction.powers_of_eps[k]),
                                                         moduli[correction.modes[k]]}));
        const Rational none = cln::expt(Rational(2), -100); // the margin is > 0 where all amplitudes are 0
        size = algebra.add({size, algebra.rational(none)});
    }
    std::vector<Real> sums;
    auto next = sizes.begin();
    for (const std::vector<FirstCorrection::Term>& terms : correction.sums)
        sums.push_back(sum_of_terms(algebra, correction, terms, eps, moduli, next));
    std::vector<Real> total;
    for (const FirstCorrection::Slope& slope : correction.slopes) {
        std::vector<Real> factors{*next++};
        for (std::size_t j = 0; j < sums.size(); ++j)
            factors.push_back(algebra.power(sums[j], slope.powers[j]));
        total.push_back(algebra.multiply(factors));
    }
    const Real sum = correction.slopes.empty() ? sums.front() : algebra.add(total);
    return algebra.add({size, algebra.multiply({algebra.rational(Rational(-2)), sum})});
}

} // namespace resonform
