// SPDX-License-Identifier: GPL-3.0-or-later
// system.toml -> System, by its path or its name.
#pragma once

#include "model/system/system_file.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace resonform {

// SYSTEM of the command line: a folder with system.toml, that file, or a name in `systems`.
// Errors (bad_input): none of these exists; the names in `systems` are suggested.
std::filesystem::path find_system(const std::string& argument, const std::filesystem::path& systems);

// Reads and checks a system file (docs/file_formats.md). Errors: bad_input: a rule there is broken; refused:
// the format foresees it, but the engine does not do it yet.
System read_system(const std::filesystem::path& file);
// The same where this is not refused; else with numbers put in before the equilibrium is proved or found, as
// `settings` of the system tell. Those that name no parameter are left out. `option` is where they come from.
System read_system(const std::filesystem::path& file, const std::vector<Setting>& settings,
                   const std::string& option);
System read_system_text(std::string_view toml, const std::filesystem::path& file);

} // namespace resonform
