// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured of a scene, and the verdicts.
#pragma once

#include "verify/judging/conditions.hpp"
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/judge.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace resonform {

struct Verification {
    std::string system, scene;
    Conditions conditions;
    std::vector<OutputVerdict> outputs;
    EmittedCheck emitted;
    std::vector<OutputVerdict> defects = {}; // beside modes that grow: of the equations, by their variables

    // Every verdict equals the expected one, and emitted = symbolic.
    [[nodiscard]] bool as_expected() const {
        return emitted.verdict == Verdict::pass &&
               std::all_of(outputs.begin(), outputs.end(),
                           [](const OutputVerdict& o) { return o.verdict == o.expected; });
    }
};

} // namespace resonform
