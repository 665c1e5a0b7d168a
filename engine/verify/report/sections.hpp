// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a report, each from finished data.
#pragma once

#include "verify/report/figures.hpp"
#include "verify/report/findings.hpp"
#include "verify/report/page.hpp"

#include <string>

namespace resonform::report {

// What is claimed, whether it holds, against whom the emitted code wins and loses, where it breaks.
Section verdict_section(const Findings& findings);
// System, scene, and what makes the page again.
Section scene_section(const Findings& findings, const Figures& figures);
Section accuracy_section(const Findings& findings, const Figures& figures);
Section speed_section(const Findings& findings, const Figures& figures, bool every_run);
Section stability_section(const Findings& findings, const Figures& figures);
// What the ladder, the comparison and the sweep have left out, with the reasons.
Section left_out_section(const Findings& findings, bool drawn);

// "0 ≤ t ≤ 1/ε"
std::string interval_of(const Conditions& conditions);

} // namespace resonform::report
