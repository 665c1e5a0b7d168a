// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a scene: its derivation, accuracy, speed and stability.
#pragma once

#include "verify/comparison/comparison.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/report/page.hpp"
#include "verify/stability/stability.hpp"

#include <filesystem>
#include <memory>

namespace resonform::report {

// All results for one scene.
struct Findings {
    std::shared_ptr<const FirstOrderSystem> system;
    const Scene* scene = nullptr;
    const Solution* solution = nullptr;
    Verification verification;
    Comparison comparison;
    Stability stability;
};

// "pendulum/third_order", the scene of a page that was written; "" of any other text.
std::string subject_of(const std::string& page);

// Curves for the figures are computed here, at eps = 0.1 and 0.01, by emitted code and direct
// integration; with `drawn` = false there are none, and the page says so. Errors (bad_input): gnuplot fails.
Page make_report(const Findings& findings, const VerifyOptions& options, bool drawn = true);

} // namespace resonform::report
