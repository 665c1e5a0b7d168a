// SPDX-License-Identifier: GPL-3.0-or-later
// "Emitted = symbolic": compiled emitted code against the exact solution in 50 digits, at seeded points, in
// units of the last place of an output's scale. The verdict is a pass up to the threshold of the scene.
#pragma once

#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"
#include "verify/evaluate/evaluator.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

struct EmittedInType {
    std::string type;         // "double", "long double"
    std::size_t points = 0;   // all
    std::size_t compared = 0; // those that both answer with numbers
    double ulp = 0;           // the largest difference; infinite where statuses disagree, NaN: none is seen
    double phase_share = 0;   // there: what part of the scale is that of phases moved by a slow flow
    std::string output;       // there
    std::string statuses;     // there, if they disagree: "emitted ok, symbolic outside_domain"
    std::vector<std::pair<std::string, double>> at; // there: eps, start values, t

    // Numbers were compared, or statuses that disagree.
    [[nodiscard]] bool has_seen() const { return !at.empty(); }
};

struct EmittedCheck {
    double threshold = default_ulp;
    std::string reason; // why it is more than the default
    Verdict verdict = Verdict::undecided;
    std::vector<EmittedInType> types;

    [[nodiscard]] double worst() const; // NaN: nothing was compared
};

struct EmittedCheckOptions {
    std::filesystem::path cache;
    std::function<void(const std::string&)> progress;
    std::size_t starts = 50, times = 20; // of each start
    std::uint64_t seed = 1;
};

// At the points of verify/judging/emitted_points.hpp. Statuses must agree, but for low_precision against ok,
// and within 4 ulp of an edge; those at t = 0 of ten times as many starts, too. library: made from the
// program, whose start values are the arguments. Precondition: every parameter is fixed.
EmittedCheck check_emitted(const Program& program, const std::shared_ptr<const EvaluatorLibrary>& library,
                           const Solution& solution, const Scene& scene, const EmittedCheckOptions& options);

// The lines of `resonform verify`.
std::string to_text(const EmittedCheck& check);

} // namespace resonform
