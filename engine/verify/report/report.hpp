// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a scene: its derivation, accuracy, speed and stability.
#pragma once

#include "verify/judging/options.hpp"
#include "verify/report/findings.hpp"
#include "verify/report/page.hpp"

#include <string>

namespace resonform::report {

// "pendulum/third_order", the scene of a page that was written; "" of any other text.
std::string subject_of(const std::string& page);

// How much of it: everything, or what is worth being kept: no motions, no rows of the comparison, no
// derivation.
enum class Extent { everything, kept };

// Curves for the figures are computed here, at drawn_eps, by emitted code and direct
// integration; with `drawn` = false there are none, and the page says so. Errors (bad_input): gnuplot fails.
Page make_report(const Findings& findings, const VerifyOptions& options, bool drawn = true,
                 Extent extent = Extent::everything);

} // namespace resonform::report
