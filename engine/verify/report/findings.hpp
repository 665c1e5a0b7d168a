// SPDX-License-Identifier: GPL-3.0-or-later
// All results for one scene, of which reports are made.
#pragma once

#include "solve/solution.hpp"
#include "verify/comparison/comparison.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/report/origin.hpp"
#include "verify/stability/stability.hpp"

#include <memory>

namespace resonform::report {

struct Findings {
    std::shared_ptr<const FirstOrderSystem> system;
    const Scene* scene = nullptr;
    const Solution* solution = nullptr;
    Verification verification;
    Comparison comparison;
    Stability stability;
    Origin origin;
};

} // namespace resonform::report
