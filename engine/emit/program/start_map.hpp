// SPDX-License-Identifier: GPL-3.0-or-later
// The near-identity map at t = 0 as conditions of a program (solve/near_identity.hpp).
#pragma once

#include "emit/program/flow_moment.hpp"

#include <vector>

namespace resonform {

// Old and new variables at t = 0. Modes that start from constants have no old ones, which would follow
// from the map.
struct StartPair {
    FlowValues old, now;            // `drift` of both: of drifts that are checked, else -1, or empty
    std::vector<Graph::Node> turns; // of the angles, from the old to the new
    std::vector<std::vector<Graph::Node>> drift_terms = {}; // of which now.drift are sums, or empty
    bool from_constants = false;
    const FlowSums* sums = nullptr; // of series of the map, if some are known
};

void require_near_identity(Program& program, const Solution& solution, const RealForm& real,
                           const Surroundings& surroundings, const StartPair& start);

// factor = 1 + terms in eps, of the amplitude of `variable`
void require_close_to_one(Program& program, Graph::Node factor, const std::string& variable);

} // namespace resonform
