// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomials of a slow flow by name, so that one can be changed.
#pragma once

#include "solve/flow/slow_flow.hpp"

#include <functional>
#include <string>
#include <vector>

namespace resonform {

struct PartOfFlow {
    std::string name; // "rate of mode 0, weight 3"
    Polynomial truth;
    std::function<void(SlowFlow&, const Polynomial&)> put; // in its place
};

std::vector<PartOfFlow> named_parts(const SlowFlow& flow);

} // namespace resonform
