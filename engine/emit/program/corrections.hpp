// SPDX-License-Identifier: GPL-3.0-or-later
// The first corrections of the near-identity map (solve/first_correction.hpp) as conditions of a program.
// modes: divided by eps^weight; `lower`: the node of a real polynomial of the solution's ring.
#pragma once

#include "emit/program/flow_moment.hpp"
#include "solve/first_correction.hpp"

#include <functional>

namespace resonform {

// Those in which a mode stands that grows, at the start, in units of eps^weight: with terms T |a|^p, |a| its
// modulus,
//
//   |a| sum T^{1/p}
//
// so that this times e^chi is about the ratio of one power of the mode in the map to the one before.
Graph::Node corrections_of(Program& program, const Solution& solution, const Surroundings& surroundings,
                           std::size_t growing, const std::vector<FlowUnit>& modes,
                           const std::function<Graph::Node(const Polynomial&)>& lower);

// Adds their margins at any slow time to program.layers. One that needs a quadrature becomes a condition of
// every call instead (program.positive), since tables are built only after the layers.
void add_corrections(Program& program, const Solution& solution, const Surroundings& surroundings,
                     const std::vector<FlowUnit>& modes,
                     const std::function<Graph::Node(const Polynomial&)>& lower);

// Adds those of solve/first_correction.hpp that count at the start alone to program.positive: modes and
// `lower` at t = 0.
void add_start_corrections(Program& program, const Solution& solution, const Surroundings& surroundings,
                           const std::vector<FlowUnit>& modes,
                           const std::function<Graph::Node(const Polynomial&)>& lower);

} // namespace resonform
