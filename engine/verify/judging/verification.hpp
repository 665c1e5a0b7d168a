// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured of a scene, and the verdicts.
#pragma once

#include "verify/judging/conditions.hpp"
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/judge.hpp"
#include "verify/judging/lies.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

struct Verification {
    std::string system, scene;
    Conditions conditions;
    std::vector<OutputVerdict> outputs;
    EmittedCheck emitted;
    std::vector<OutputVerdict> defects = {}; // beside modes that grow: of the equations, by their variables

    std::optional<Lies> lies = {}; // none: not asked for

    // Every verdict equals the expected one, emitted = symbolic, and no lie survives.
    [[nodiscard]] bool as_expected() const {
        return emitted.verdict == Verdict::pass && !(lies && (lies->honest_fails || lies->survivors() > 0)) &&
               std::all_of(outputs.begin(), outputs.end(),
                           [](const OutputVerdict& o) { return o.verdict == o.expected; });
    }
};

} // namespace resonform
