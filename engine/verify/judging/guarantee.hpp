// SPDX-License-Identifier: GPL-3.0-or-later
// The order that is guaranteed, whatever a ladder shows: by the count of weights and, for a claim above it,
// by deriving the next weights and testing whether they vanish.
#pragma once

#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"
#include "verify/estimate/next_weight.hpp"

#include <map>
#include <optional>
#include <string>

namespace resonform {

struct Guarantee {
    // The error is O(eps^order), held as weights are; none: the count does not hold on this interval.
    std::optional<int> order;
    bool refuted = false; // the next power does not vanish: no higher order holds
    std::string reason;   // why the order is no higher, where the claim is
};

using Guarantees = std::map<std::string, Guarantee>; // by output
using Claims = std::map<std::string, int>;           // the order claimed of each

// Each weight above that of `solution` is derived, with [fix] put in, as
// long as a claim is neither reached nor refuted; a refusal by `derive` or on the way leaves it open,
// with the reason. The order is not searched for beyond the claim.
Guarantees guarantees(const Scene& scene, const Solution& solution, const Claims& claims,
                      const Derive& derive);

} // namespace resonform
