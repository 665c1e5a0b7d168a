// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas that a scene's code computes, as text for its banner.
#pragma once

#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"

#include <string>
#include <vector>

namespace resonform {

// Lines: slow variables, the phase if `with_phase`, and the outputs of the scene.
std::vector<std::string> scene_formulas(const Solution& solution, const Scene& scene, bool with_phase);

} // namespace resonform
