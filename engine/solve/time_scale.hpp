// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a solution moves a finite distance within the times that a scene asks for (design 2.4).
#pragma once

#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"

namespace resonform {

// The condition of the truncation count that only the solution can decide: for p above the least weight the
// slow flow, and each drift among the outputs, has rates of order eps^p or less and so moves a finite
// distance. Error: refused.
void check_time_scale(const Solution& solution, const Scene& scene);

} // namespace resonform
