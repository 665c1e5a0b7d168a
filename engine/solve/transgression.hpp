// SPDX-License-Identifier: GPL-3.0-or-later
// The transgression: the motion, on the time 1/eps, of the variables that are constant at eps = 0 (slow
// variables and drifts), through the first power of eps that moves them.
//
//   pendulum:  xi = xi_0 + eps v t,  x = C_X + r log((xi + sqrt(xi^2 + r^2))/r) + O(eps^2)
//   particle:  z' = eps sqrt(c/m)(...) + O(eps^5), a constant: z rises uniformly
#pragma once

#include "solve/drift_path.hpp"

#include <optional>
#include <vector>

namespace resonform {

struct FormerConstant {
    std::size_t variable; // index into System::variables
    std::optional<int>
        oscillation; // the power of eps with which it oscillates about its law, through order N
};

struct Transgression {
    // The solution with laws only. Closed: drifts and the primitives that they need, no outputs. A slow flow:
    // rates of slow variables and drifts through the first weight that moves them, of amplitudes and offsets
    // of angles through the weight that changes them by their own size. Terms left out of a series have
    // weight through() + 1 or more, whether they were computed or not.
    Solution law;
    std::vector<FormerConstant> constants; // in the order of the file
    std::optional<DriftPath> path;         // of two drifts
};

// Whether it has slow variables or drifts.
[[nodiscard]] bool has_former_constants(const System& system);

// Precondition: has_former_constants.
[[nodiscard]] Transgression transgression(const Solution& solution);

} // namespace resonform
