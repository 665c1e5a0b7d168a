// SPDX-License-Identifier: GPL-3.0-or-later
// What this program is, for the results that it writes.
#pragma once

#include "verify/report/origin.hpp"

#include <string>

namespace resonform {

// The commit that the program was built from, "-dirty" behind it if files were changed; "unknown" without
// git. Written at every build by cmake/commit.cmake.
const char* source_commit();

// Of this program, today.
report::Origin origin_of(std::string command);

} // namespace resonform
