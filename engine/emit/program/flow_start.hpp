// SPDX-License-Identifier: GPL-3.0-or-later
// Where a slow flow starts: a_j = amplitude e^{i phase}, or through the inverse map from physical values,
//
//   z_0 = rows of the modal matrix * (x_0, x'_0, ...),   w_0 = z_0 + g(z_0, ...; xi_0),   a_j = w_0/eps^w
//
// at the full weight of the map. Where a mode w_j is 0 (scene.at_zero), one state s is not given: it is
// solved for together with w, by substitutions in z = w + h(w), where row j is z_j = h_j(w). Angles, slow
// variables and drifts have physical values (drifts: or their constants); where the oscillators start from
// constants, zeta_0 = xi_0 - k(w_0; zeta_0) is solved by substitutions
// (normalize/recursion/substitutions.hpp).
#pragma once

#include "emit/program/flow_moment.hpp"
#include "normalize/recursion/substitutions.hpp"

#include <map>
#include <string>

namespace resonform {

// Whether physical start values go through the inverse map; else, where that would be long, by substitutions
// in the map. Both are right through weight M, and differ beyond.
bool starts_by_inverse_map(const Solution& solution);

// Those for a start that does not go through the inverse map; modes: they are looked for, too.
std::vector<SubstitutionStep> start_substitutions(const Solution& solution, bool modes);

FlowValues flow_start(Program& program, const Solution& solution, const Scene& scene, const RealForm& real,
                      const Surroundings& surroundings, const std::map<std::string, Graph::Node>& names);

} // namespace resonform
