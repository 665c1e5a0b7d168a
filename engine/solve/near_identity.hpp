// SPDX-License-Identifier: GPL-3.0-or-later
// Where a solution starts, its map must be close to the identity (docs/theory.md, "Where a solution starts"):
//
//   from physical values z_0   w_0 + h(w_0) misses z_0 by less than a half of |z_0| and |h(w_0)|
//   from constants w_0         h(z_0) misses h(w_0), z_0 = w_0 + h(w_0), by less than a half of |w_0| and
//                              |h(w_0)|: z_0 - h(z_0) leads back
//
// or by less than eps^M/2. Slow variables, angles and drifts start from physical values. The origin of slow
// variables and drifts is arbitrary, so their size is no measure: they are missed by less than 2^-M |h(w_0)|,
// the error being halved in each of M steps of the inversion (or, for rounding, by 10^-10 of their size and
// of the terms of their sum: at the start the constant of a drift and its mean motion cancel). Forced terms
// of h, those without a mode, drop out of these differences: their harmonics together are less than twice the
// start value, or than 2 eps^weight (of a slow variable or angle, than 2; no bound for modes if the equations
// are linear in the fast variables). A template over the number type, for two users: the emitter computes
// with nodes of a graph, the check of emitted code with 50 digits.
#pragma once

#include "solve/solution.hpp"

#include <string>
#include <utility>
#include <vector>

namespace resonform {

// A variable to which the map adds something.
struct MovedVariable {
    enum class Kind { mode, slow, angle, drift };
    Kind kind;
    std::size_t index;              // into GradedField::modes, slow, angles, drift
    std::string name;               // of the user's variable
    int weight;                     // of a mode
    const Series* series;           // of the map
    Polynomial added;               // it through weight M
    std::vector<std::size_t> modes; // of a mode: itself, and those that are in `added`
    std::vector<Polynomial> forced; // terms of `added` without a mode: the coefficient of each harmonic
};
std::vector<MovedVariable> moved_variables(const Solution& solution);

// False where all equations are of first degree in the fast variables: forced motion is then superposed.
bool feels_what_is_forced(const FirstOrderSystem& equations);

// Values at t = 0; modes are divided by eps^weight. Angles are measured from their old value, which is 0.
template <class Complex> struct StartShift {
    Complex old, now, added; // added: by the map to the new variables
    Complex added_to_old;    // by the map to the old ones; of modes that start from constants
    std::vector<Complex> forced = {};
    std::vector<Complex> terms = {}; // of `now`, where it is a sum
};
template <class Complex> struct StartShifts {
    std::vector<StartShift<Complex>> modes, slow, angles, drift;

    [[nodiscard]] StartShift<Complex>& of(const MovedVariable& v) {
        switch (v.kind) {
        case MovedVariable::Kind::mode: return modes[v.index];
        case MovedVariable::Kind::slow: return slow[v.index];
        case MovedVariable::Kind::angle: return angles[v.index];
        case MovedVariable::Kind::drift: break;
        }
        return drift[v.index];
    }
};

// Algebra has the types Real and Complex, number(int), little() = eps^(2M), gained(Real x) = 4^(1 - M) x,
// rounding(Real x) = 10^-20 x, sum(list of Real), square(Complex) = |z|^2, plus and minus of Complex,
// times(int, Real), and require(Real, name): that it is positive.
template <class Algebra> class NearIdentity {
public:
    using Real = typename Algebra::Real;
    using Complex = typename Algebra::Complex;
    explicit NearIdentity(Algebra& algebra) : algebra_(algebra) {}

    void require(const std::vector<MovedVariable>& moved, StartShifts<Complex>& at, bool from_constants) {
        for (const MovedVariable& v : moved) {
            if (v.kind == MovedVariable::Kind::mode && from_constants)
                require_way_back(v, at);
            else
                require_reproduced(v, at.of(v));
            if (!v.forced.empty()) require_moderate(v, at.of(v), from_constants);
        }
    }
    // For a factor of an amplitude, which is 1 up to small terms; minus_one: the factor minus 1.
    void require_close_to_one(const Complex& minus_one, const std::string& name) {
        require_half(minus_one, {algebra_.number(1)}, name);
    }

private:
    // Requires |missed| < sqrt(sum of the squares)/2.
    void require_half(const Complex& missed, std::vector<Real> squares, const std::string& name) {
        squares.push_back(algebra_.times(-4, algebra_.square(missed)));
        algebra_.require(algebra_.sum(std::move(squares)), name);
    }
    void require_reproduced(const MovedVariable& v, const StartShift<Complex>& s) {
        const Complex found = algebra_.plus(s.now, s.added);
        if (v.kind == MovedVariable::Kind::angle) // half a radian
            require_half(found, {algebra_.number(1)}, v.name);
        else if (v.kind == MovedVariable::Kind::mode)
            require_half(algebra_.minus(found, s.old),
                         {algebra_.little(), algebra_.square(s.old), algebra_.square(s.added)}, v.name);
        else
            require_half(algebra_.minus(found, s.old),
                         {algebra_.little(), algebra_.gained(algebra_.square(s.added)), rounding(s)}, v.name);
    }
    [[nodiscard]] Real rounding(const StartShift<Complex>& s) const {
        std::vector<Real> squares{algebra_.square(s.old)};
        for (const Complex& term : s.terms) squares.push_back(algebra_.square(term));
        return algebra_.rounding(algebra_.sum(std::move(squares)));
    }
    void require_moderate(const MovedVariable& v, const StartShift<Complex>& s, bool from_constants) {
        const bool constant = v.kind == MovedVariable::Kind::mode && from_constants;
        std::vector<Real> terms{algebra_.number(4),
                                algebra_.times(4, algebra_.square(constant ? s.now : s.old))};
        for (const Complex& harmonic : s.forced)
            terms.push_back(algebra_.times(-1, algebra_.square(harmonic)));
        algebra_.require(algebra_.sum(std::move(terms)), v.name);
    }
    void require_way_back(const MovedVariable& v, const StartShifts<Complex>& at) {
        std::vector<Real> squares{algebra_.little()};
        for (const std::size_t k : v.modes) {
            squares.push_back(algebra_.square(at.modes[k].now));
            squares.push_back(algebra_.square(at.modes[k].added));
        }
        const StartShift<Complex>& s = at.modes[v.index];
        require_half(algebra_.minus(s.added_to_old, s.added), std::move(squares), v.name);
    }

    Algebra& algebra_;
};

} // namespace resonform
