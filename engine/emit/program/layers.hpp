// SPDX-License-Identifier: GPL-3.0-or-later
// Around the zeros of a small divisor that moves in slow time, the resonance surfaces, lies a layer in which
// the normal form is not valid (design 2.3): dividing by D gains no power of eps where
//
//   |D|^2 <= |dD/dt|,   dD/dt = sum_k dD/dzeta_k zeta_k'
//
// This is |D| <~ sqrt(eps) where D passes zero; of a frequency omega = D itself it is |d(1/omega)/dt| >= 1.
// Nor is it valid where amplitudes have grown too large for its map (emit/program/corrections.hpp).
//
// A divisor of products that decay may vanish when these are gone (solve/small_divisors.hpp). While it
// keeps its sign outside of its layer, the map is as good as any other. Behind it terms are still right where
// e^chi of their product, relative to the start, is small beyond all powers of eps; only near the zero 1/D is
// larger. Of a term with 1/D^p that was no more than the mode itself at the start is left, with one power
// more for the rounding of D,
//
//   e^chi |D_0/D|^{p + 1}
//
// and it does no harm below eps^{N + 1}/1000. Where neither holds, the status is low_precision. To have a
// number where D = 0, 1/D is computed as D/(D^2 + rho^2) with rho = 2^-90 D_0, and (D^2 + rho^2)^{1/2} stands
// for D above.
#pragma once

#include "emit/program/flow_moment.hpp"
#include "solve/small_divisors.hpp"

#include <functional>
#include <utility>

namespace resonform {

using ToNode = std::function<Graph::Node(const Polynomial&)>;

// Adds the margins D^2 - dD/dt and D^2 + dD/dt of all moving divisors, > 0 outside of the layers, to
// program.layers. `lower`: the node of a real polynomial of the normal form's ring at any slow time;
// `divisor`: the same of a divisor, without cancellation (Lowering::divisor). Divisors
// whose rate needs the derivative of a function known by name that nothing else needs are left out. The
// margins of standing divisors go into program.positive, unless they are numbers that are large enough for
// every eps <= 1/2.
void add_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                const ToNode& lower, const ToNode& divisor);

// Adds the margins of moving_divisors_at_start to program.positive. `lower`: the node at t = 0.
void add_start_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                      const ToNode& lower);

// 1/D of such a divisor for the outputs, by the nodes of D at any slow time and at t = 0.
Graph::Node inverse_of(Graph& graph, Graph::Node now, Graph::Node start);

// Adds what leaves the outputs their digits to a phase of the program, which has all phases of the flow.
// start, now: the node of a real polynomial of the normal form's ring at t = 0 and at any slow time.
void add_fading(Program& program, const Solution& solution, const Surroundings& surroundings,
                const FadingDivisor& fading, const ToNode& start, const ToNode& now);

// Real and imaginary part of a polynomial, by `lower`, the node of a real one.
std::pair<Graph::Node, Graph::Node> real_and_imaginary(const Ring& ring, const Polynomial& p,
                                                       const ToNode& lower);

} // namespace resonform
