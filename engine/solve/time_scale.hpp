// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a solution goes a finite way within the times that a scene asks for (design 2.4).
#pragma once

#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"

namespace resonform {

// The part of the count that only the solution shows: for p >= 2 a slow flow, and a drift among the outputs,
// move as eps^p or more slowly, so that they go a finite way. Error: refused.
void check_time_scale(const Solution& solution, const Scene& scene);

} // namespace resonform
