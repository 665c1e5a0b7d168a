// SPDX-License-Identifier: GPL-3.0-or-later
// A slow flow on a page and as JSON. Preconditions: solution.flow.
#pragma once

#include "emit/json.hpp"
#include "emit/page.hpp"
#include "solve/solution.hpp"

#include <vector>

namespace resonform {

// The frame of phases, the flow within it, and these outputs.
std::vector<Section> flow_sections(const Solution& solution, const std::vector<FlowOutput>& outputs);

// What resonform.solution/1 has of a slow flow: frame, flow, outputs.
Json flow_json(const Solution& solution);

} // namespace resonform
