// SPDX-License-Identifier: GPL-3.0-or-later
// Display forms of a solution's elements: primitives as logarithms and integrals, e^{i k theta} as sines
// and cosines.
#pragma once

#include "emit/display/display.hpp"
#include "solve/solution.hpp"

#include <string>
#include <vector>

namespace resonform {

// log(...), exp(...), integral(..., xi = xi_0..xi) or integral(..., T = 0..eps*t) for every primitive.
Substitutes solution_substitutes(const Solution& solution);

// The slow time T = eps*t: a symbol that is no name of the system, and the sum eps*t.
std::string slow_time_name(const Solution& solution);
DisplaySum slow_time_sum();

// The path of a slow variable with the rate a - b xi in t: xi_0 + a*t, or xi_0*exp(-b*t) + a/b*(1 -
// exp(-b*t)). No terms where a/b is no element of the ring.
DisplaySum path_sum(const Ring& ring, const std::string& name, const SlowPath& path);

// Does a name occur anywhere in it?
bool mentions(const DisplaySum& sum, const std::string& name);

// The name of the phase in print: theta, or another when the system uses it.
std::string phase_name(const Solution& solution);

// One harmonic of a real trigonometric polynomial: coefficient * (1, cos(k theta), sin(k theta)).
struct Harmonic {
    int multiple = 0; // k >= 0
    bool sine = false;
    Polynomial coefficient; // in Solution::ring, real, free of phases
};

// A real element of the ring: c e^{ik theta} + conj = 2 Re c cos(k theta) - 2 Im c sin(k theta).
// By k, cosine before sine; zero coefficients left out.
std::vector<Harmonic> harmonics(const Solution& solution, const Polynomial& p);

// Every coefficient as one term with its cos(k theta) or sin(k theta) behind it.
DisplaySum display_harmonics(const Solution& solution, const std::vector<Harmonic>& list);

} // namespace resonform
