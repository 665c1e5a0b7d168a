// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a stability sweep: every corner of every input alone, then random mixtures.
#pragma once

#include "emit/program.hpp"

#include <cstdint>
#include <vector>

namespace resonform {

// What an input means decides how far it is driven.
enum class InputKind {
    eps,       // 1e-12 ... 0.5
    positive,  // 1e-12 ... 1e12
    real,      // the same of both signs: parameters, constants
    amplitude, // 1e-12 ... 1e3 of both signs; eps times more than that is in the reach of no expansion
    slow,      // 0, and 1e-150 ... 1e150 of both signs
    phase,     // 0 ... 1e14 of both signs
};

// The corners of a kind, extremes included.
std::vector<double> corners(InputKind kind);

struct SweepPoint {
    double eps = 0;
    std::vector<double> parameters, start; // in the order of the program
};

// The inputs of a program in the order eps, parameters, start.
std::vector<InputKind> input_kinds(const Program& program, const System& system);

// Every corner alone (the rest at the scene's defaults), then `random_points` log-uniform ones of which
// each input is at a corner with probability 0.4: pairs and triples of corners are among them. Same seed,
// same points.
std::vector<SweepPoint> sweep_points(const Program& program, const System& system, std::size_t random_points,
                                     std::uint64_t seed);

} // namespace resonform
