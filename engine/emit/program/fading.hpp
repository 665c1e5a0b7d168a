// SPDX-License-Identifier: GPL-3.0-or-later
// Divisors of products that decay, which may vanish when these are gone:
//
//   u' = -(1 + s) u,   y' = -2 y + u^2,   s' = -eps:     y = z_2 - z_1^2/(2 s) + ...
//
// While D = -2 s keeps its sign outside of its layer, |D|^2 > |dD/dt|, the map is as good as any other.
// Behind it terms are still right where e^chi of their product, relative to the start, is small beyond all
// powers of eps; only near the zero 1/D is larger. Of a term with 1/D^p that was no more than the mode itself
// at the start is left, with one power more for the rounding of D,
//
//   e^chi |D_0/D|^{p + 1}
//
// and it does no harm below eps^{N + 1}/1000. Where neither holds, the status is low_precision. To have a
// number where D = 0, 1/D is computed as D/(D^2 + rho^2) with rho = 2^-90 D_0, and (D^2 + rho^2)^{1/2} stands
// for D above.
#pragma once

#include "emit/program/layers.hpp"

#include <functional>
#include <vector>

namespace resonform {

struct FadingDivisor {
    GeneratorId generator; // whose powers 1/D is
    MovingDivisor moving;
    int power;                              // the highest one of 1/D
    std::vector<std::vector<int>> products; // e^{<product, chi>} multiplies it, with the decays of the flow
};

// The moving divisors that stand in no rate, and in outputs only beside modes that decay. What the equations
// divide by is none of them.
std::vector<FadingDivisor> fading_divisors(const Solution& solution);
bool fades(const std::vector<FadingDivisor>& fading, GeneratorId generator);

// 1/D for the outputs, by the nodes of D at any slow time and at t = 0.
Graph::Node inverse_of(Graph& graph, Graph::Node now, Graph::Node start);

// Adds what leaves the outputs their digits to a phase of the program, which has all phases of the flow.
// start, now: the node of a real polynomial of the normal form's ring at t = 0 and at any slow time.
void add_fading(Program& program, const Solution& solution, const Surroundings& surroundings,
                const FadingDivisor& fading, const std::function<Graph::Node(const Polynomial&)>& start,
                const std::function<Graph::Node(const Polynomial&)>& now);

} // namespace resonform
