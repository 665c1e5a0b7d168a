// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the source tree, for the tests that hold the house in order.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resonform::test {

struct SourceFile {
    std::string path; // relative to the source tree: "engine/algebra/ring.hpp"
    std::vector<std::string> lines;
};

// Files below the given folders with one of the extensions, sorted by path.
std::vector<SourceFile> files_below(const std::vector<std::string>& folders,
                                    const std::vector<std::string>& extensions);

// A line of C++ without its // comment (strings that hold // are kept).
std::string without_comment(const std::string& line);

} // namespace resonform::test
