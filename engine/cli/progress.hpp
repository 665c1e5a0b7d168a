// SPDX-License-Identifier: GPL-3.0-or-later
// What a long command is doing, one line each, on stderr.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace resonform {

inline void show_progress(const std::string& line) {
    fmt::print(stderr, "  {}\n", line);
    std::fflush(stderr);
}

} // namespace resonform
