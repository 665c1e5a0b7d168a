// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a solution.
#pragma once

#include "model/system/scene_file.hpp"

#include <optional>

namespace resonform {

// Orders and powers of eps are held as weights are: in units of 1/eps_root of the system.
struct SolveOptions {
    int order = 3;          // N
    int truncation = 4;     // M
    int time_scale = 1;     // p: for times of order eps^-p
    bool transients = true; // false: the slow manifold alone, without modes that decay or grow at eps = 0
    Growing growing = Growing::status; // of modes that grow at eps = 0
    std::optional<ModeAtZero> at_zero = {};
};

// As a scene asks for it, at this order and truncation.
inline SolveOptions options_of(const Scene& scene, int order, int truncation) {
    return {order, truncation, scene.slow_power(), scene.transients, scene.growing, scene.at_zero};
}

} // namespace resonform
