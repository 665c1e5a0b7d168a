// SPDX-License-Identifier: GPL-3.0-or-later
// What results come from: the program, and the command that makes them again.
#pragma once

#include "verify/run/machine.hpp"

#include <string>

namespace resonform::report {

struct Origin {
    std::string version;
    std::string commit; // of the sources that the program was built from; "unknown" without git
    std::string date;   // 2026-01-31, UTC
    std::string command;
    Machine machine;
};

} // namespace resonform::report
