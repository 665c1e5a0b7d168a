// SPDX-License-Identifier: GPL-3.0-or-later
// scenes/*.toml -> Scene, with its system.
#pragma once

#include "model/system/scene_file.hpp"

#include <filesystem>
#include <string_view>

namespace resonform {

// The system is the one in the scene's parent's parent folder (systems/x/scenes/s.toml), else by the
// name it gives, in `systems`.
// Errors: bad_input: a rule of docs/file_formats.md is broken; those of read_system.
Scene read_scene(const std::filesystem::path& file, const std::filesystem::path& systems);
Scene read_scene_text(std::string_view toml, const std::filesystem::path& file,
                      const std::filesystem::path& systems);

} // namespace resonform
