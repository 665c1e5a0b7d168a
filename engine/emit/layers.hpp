// SPDX-License-Identifier: GPL-3.0-or-later
// Around the zeros of a small divisor that moves in slow time, the resonance surfaces, lies a layer in which
// a normal form says nothing (design 2.3): dividing by D gains no power of eps where
//
//   |D|^2 <= |dD/dt|,   dD/dt = sum_k dD/dzeta_k zeta_k'
//
// This is |D| <~ sqrt(eps) where D passes zero; of a frequency omega = D itself it is |d(1/omega)/dt| >= 1.
#pragma once

#include "emit/moment.hpp"

#include <functional>

namespace resonform {

// What is > 0 outside of the layers is put into program.layers: D^2 - dD/dt and D^2 + dD/dt for all divisors
// that move and were divided by, of those that differ by a factor the smallest. `lower`: the node of a real
// polynomial of the normal form's ring at any slow time. A divisor whose rate needs the derivative of a
// function known by name that nothing else needs is left out.
void add_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                const std::function<Graph::Node(const Polynomial&)>& lower);

} // namespace resonform
