// SPDX-License-Identifier: GPL-3.0-or-later
// The headings of system and scene files, read without the rest of the file.
#pragma once

#include "model/text/toml_tree.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace resonform {

struct Heading {
    std::string name, title;
    std::string source; // of a system: where its equations come from
    Place name_place;   // of a system: where its name stands
};

// The keys at the top of the two kinds of file.
const std::vector<std::string>& keys_of_systems();
const std::vector<std::string>& keys_of_scenes();

// The table [system]. Errors (bad_input): a wrong or missing key in it, or an unknown table of the file.
Heading heading_of_system(const TomlNode& root, const std::filesystem::path& file);
Heading read_heading_of_system(const std::filesystem::path& file);
// The same of a scene, whose name is that of its file.
Heading heading_of_scene(const TomlNode& root, const std::filesystem::path& file);
Heading read_heading_of_scene(const std::filesystem::path& file);

} // namespace resonform
