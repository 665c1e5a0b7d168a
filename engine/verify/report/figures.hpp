// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a report, each from finished data.
#pragma once

#include "verify/comparison/comparison.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/report/page.hpp"
#include "verify/report/plot.hpp"
#include "verify/stability/stability.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace resonform::report {

// Curves of a scene at one eps; of its two drifts without oscillation; of the variables that are constant at
// eps = 0 and have a start value, if any.
struct MotionCurves {
    ErrorCurves full;
    std::optional<ErrorCurves> mean, former;
};

// What is left of a text in the name of a file: "psi'" -> "psip", "0.01" -> "0_01".
std::string identifier_in_file(const std::string& text);

// Numbers that the source gives to figures, at drawn_eps: VerifyPlan::figures.
using PublishedFigures = std::map<std::string, std::vector<int>>;

// Draws every figure with its scripts in one scratch folder; if not `drawn` there are none: those
// of finished data are empty galleries.
class Figures {
public:
    Figures(const System& system, std::filesystem::path scratch, bool drawn = true,
            PublishedFigures published = {});

    // Every output over time beside direct integration, and below it the difference.
    [[nodiscard]] Gallery motion(const std::vector<MotionCurves>& motions) const;
    // Former constants over eps*t, beside direct integration; two drifts: the second over the first, too.
    [[nodiscard]] Gallery transgression(const std::vector<MotionCurves>& motions) const;
    // max error over eps^claimed, where the claimed order is level; its limit line and the estimate beside
    // it.
    [[nodiscard]] Gallery ladders(const std::vector<OutputVerdict>& outputs) const;
    // Error against run time, one figure for each task.
    [[nodiscard]] Gallery work(const Comparison& comparison) const;
    // The worst errors over each input, one small figure for each; with them, which statuses answered where.
    [[nodiscard]] Gallery stability(const Stability& stability) const;

    [[nodiscard]] std::string label(const std::string& name) const; // "x, m"
    // "s" where the file has units: primes count per second. Else "".
    [[nodiscard]] std::string unit_of_time() const;

private:
    [[nodiscard]] Figure draw(const Plot& plot, std::string caption) const;
    [[nodiscard]] std::string time_label(const std::string& time) const; // "εt, s"
    [[nodiscard]] std::string published(const std::string& what,
                                        double eps) const; // "; compare figure 4 of the source"
    [[nodiscard]] std::vector<std::string> drift_outputs(const ErrorCurves& curves) const;
    [[nodiscard]] Figure path(const MotionCurves& motion, const std::string& x, const std::string& y) const;
    [[nodiscard]] Figure former_constant(const ErrorCurves& curves, std::size_t output) const;
    [[nodiscard]] Figure motion_of(const ErrorCurves& curves, std::size_t output) const;
    [[nodiscard]] Figure ladder(const OutputVerdict& output) const;
    [[nodiscard]] Figure stability_over(const Stability& stability, const InputByDecade& own) const;
    [[nodiscard]] Figure work_of(const Comparison& comparison, Task task) const;

    const System* system_;
    std::filesystem::path scratch_;
    bool drawn_;
    PublishedFigures published_;
};

} // namespace resonform::report
