// SPDX-License-Identifier: GPL-3.0-or-later
// Around the zeros of a small divisor that moves in slow time, the resonance surfaces, lies a layer in which
// the normal form is not valid (design 2.3): dividing by D gains no power of eps where
//
//   |D|^2 <= |dD/dt|,   dD/dt = sum_k dD/dzeta_k zeta_k'
//
// This is |D| <~ sqrt(eps) where D passes zero; of a frequency omega = D itself it is |d(1/omega)/dt| >= 1.
// Nor is it valid where amplitudes have grown too large for its map (emit/program/corrections.hpp).
#pragma once

#include "emit/program/flow_moment.hpp"
#include "solve/solution.hpp"

#include <functional>
#include <utility>

namespace resonform {

// A divisor D that moves, and dD/dt by the leading parts of the slow rates, in the normal form's ring; of
// divisors that differ by a factor the smallest.
struct MovingDivisor {
    Polynomial divisor, rate;
};
std::vector<MovingDivisor> moving_divisors(const Normalization& normalization);

// |D|^2 -+ both parts of dD/dt, > 0 outside of the layer, without those that are known to be. `lower`: the
// node of a real polynomial of the normal form's ring.
std::vector<Graph::Node> margins_of(Graph& graph, const Ring& ring, const MovingDivisor& moving,
                                    const Surroundings& surroundings,
                                    const std::function<Graph::Node(const Polynomial&)>& lower);

// Those of monomials with modes that decay or grow: they matter at the start alone, for what decays is gone
// before the divisor moves far.
std::vector<MovingDivisor> moving_divisors_at_start(const Normalization& normalization);

// A constant divisor is as good as zero where the phase D t stays small on t <= 1/eps: then the monomial that
// was divided by it cancels against its start value, but only in exact arithmetic. It must satisfy
// margin = |D|^2 - (10^-4 eps)^2 > 0, so that two divisions by D leave eight digits of the real type. Of
// divisors that differ by a factor, only the smallest.
struct StandingDivisor {
    Polynomial divisor, margin;
};
std::vector<StandingDivisor> standing_divisors(const Normalization& normalization);

// Adds the margins D^2 - dD/dt and D^2 + dD/dt of all moving divisors, > 0 outside of the layers, to
// program.layers. `lower`: the node of a real polynomial of the normal form's ring at any slow time. Divisors
// whose rate needs the derivative of a function known by name that nothing else needs are left out. The
// margins of standing divisors go into program.positive, unless they are numbers that are large enough for
// every eps <= 1/2.
void add_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                const std::function<Graph::Node(const Polynomial&)>& lower);

// Adds the margins of moving_divisors_at_start to program.positive. `lower`: the node at t = 0.
void add_start_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                      const std::function<Graph::Node(const Polynomial&)>& lower);

// Real and imaginary part of a polynomial, by `lower`, the node of a real one.
std::pair<Graph::Node, Graph::Node>
real_and_imaginary(const Ring& ring, const Polynomial& p,
                   const std::function<Graph::Node(const Polynomial&)>& lower);

} // namespace resonform
