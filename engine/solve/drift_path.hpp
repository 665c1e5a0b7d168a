// SPDX-License-Identifier: GPL-3.0-or-later
// The path of two drifts in their plane, with the slow variable (or time) eliminated from their leading laws:
//
//   x = C_X + r log((xi + sqrt(s))/r),  y = C_Y + sqrt(s),  s = xi^2 + r^2   ->   y - C_Y = r cosh((x -
//   C_X)/r)
#pragma once

#include "solve/solution.hpp"

#include <optional>

namespace resonform {

// y - C_y = offset + slope d + rising e^(d/scale) + falling e^(-d/scale), d = x - C_x, with coefficients in
// parameters only: straight lines, catenaries and their kind.
struct DriftPath {
    std::size_t over, of; // x and y: indices into Solution::drift
    Polynomial offset, slope, scale, rising, falling;
};

// Of a solution in closed form with exactly two drifts, by their parts without eps. nullopt: they do not both
// move there, or the path is not proved to be of this kind.
std::optional<DriftPath> drift_path(const Solution& solution);

} // namespace resonform
