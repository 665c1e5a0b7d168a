// SPDX-License-Identifier: GPL-3.0-or-later
// { data = "omega.csv", columns = ["tau", "omega"], degree = 5 } -> the samples of a function.
#pragma once

#include "model/text/toml_tree.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace resonform {

struct Samples {
    std::string file;                   // as the scene names it
    std::array<std::string, 2> columns; // of the arguments and of the values
    std::vector<double> x, y;           // x ascends
    int degree = 5;
};

// `scene`: the file that the path of the data is relative to. Errors (bad_input): see docs/file_formats.md.
Samples read_samples(const TomlNode& node, const std::filesystem::path& scene);

} // namespace resonform
