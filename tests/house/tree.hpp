// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the source tree, for the tests that hold the house in order.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace resonform::test {

struct SourceFile {
    std::string path; // relative to the source tree: "engine/algebra/ring/ring.hpp"
    std::vector<std::string> lines;
};

inline const std::vector<std::string> code = {".hpp", ".cpp"};

// Files below the given folders of the source tree, at any depth, with one of the extensions, sorted by path.
std::vector<SourceFile> files_below(const std::vector<std::string>& folders,
                                    const std::vector<std::string>& extensions);
// The same of another tree: where a test plants what must be found.
std::vector<SourceFile> files_below(const std::filesystem::path& root,
                                    const std::vector<std::string>& folders,
                                    const std::vector<std::string>& extensions);

// "model/text/expression.hpp" of `#include "model/text/expression.hpp"`; nothing for other lines and for
// <...>.
std::optional<std::string> included_file(const std::string& line);

// A line of C++ without its // comment (strings that hold // are kept).
std::string without_comment(const std::string& line);

} // namespace resonform::test
