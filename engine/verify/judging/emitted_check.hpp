// SPDX-License-Identifier: GPL-3.0-or-later
// "Emitted = symbolic": compiled emitted code against the exact solution in 50 digits, at seeded points, in
// units of the last place of an output's scale. The verdict is a pass up to the threshold of the scene.
#pragma once

#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/judging/emitted_points.hpp"

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

// Fails where a difference exceeds the threshold; undecided where few points were compared.
Verdict verdict_of(const std::vector<EmittedInType>& types, double threshold);

struct EmittedCheck {
    double threshold = default_ulp;
    std::string reason; // why it is more than the default
    Verdict verdict = Verdict::undecided;
    std::vector<EmittedInType> types;

    [[nodiscard]] double worst() const; // NaN: nothing was compared
};

// At the points of verify/judging/emitted_points.hpp. Statuses must agree, but for low_precision against ok,
// and within 4 ulp of an edge; those at t = 0 of twenty times as many starts, too. library: made from the
// program, whose start values are the arguments. Precondition: every parameter is fixed.
EmittedCheck check_emitted(const Program& program, const std::shared_ptr<const EvaluatorLibrary>& library,
                           const Solution& solution, const Scene& scene, const EmittedCheckOptions& options);

// The lines of `resonform verify`.
std::string to_text(const EmittedCheck& check);

} // namespace resonform
