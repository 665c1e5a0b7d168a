// SPDX-License-Identifier: GPL-3.0-or-later
// A slow flow on a page and as JSON. Preconditions: solution.flow.
#pragma once

#include "emit/display/json.hpp"
#include "emit/display/page.hpp"
#include "solve/solution.hpp"

#include <vector>

namespace resonform {

// The frame of phases, the flow within it, and these outputs.
std::vector<Section> flow_sections(const Solution& solution, const std::vector<FlowOutput>& outputs);

// The frame of phases, and the flow within it with the weights that are left out of each rate.
std::vector<Section> leading_flow_sections(const Solution& solution);

// The part of resonform.solution/1 for a slow flow: frame, flow, outputs.
Json flow_json(const Solution& solution);

// The part of resonform.transgression/1 for a slow flow: frame, flow with the weights that are left out and,
// where the amplitudes are constants, these as real ones and the uniform motion of drifts in them.
Json leading_flow_json(const Solution& solution);

} // namespace resonform
