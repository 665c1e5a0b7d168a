// SPDX-License-Identifier: GPL-3.0-or-later
// Final points of emitted headers, compiled as a user would for each width: alone and as ensembles.
#pragma once

#include "emit/program/program.hpp"

#include <string>
#include <vector>

namespace resonform::bench {

struct MemberTimes {                       // in ns a member
    double alone = 0, plain = 0, full = 0; // at_end; ensemble with a phase to 4e-13, and to all digits
};

// For each eps. march: "x86-64", "x86-64-v3", "x86-64-v4". Empty: no compiler, the processor lacks the width,
// or the scene leaves parameters open.
std::vector<MemberTimes> time_members(const Program& program, const std::string& march,
                                      const std::vector<double>& eps);

} // namespace resonform::bench
