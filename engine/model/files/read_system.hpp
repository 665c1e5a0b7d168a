// SPDX-License-Identifier: GPL-3.0-or-later
// system.toml -> System, by its path or its name.
#pragma once

#include "model/system/system_file.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace resonform {

struct TomlNode;

// The values that a scene gives to the functions which its system knows by their names only.
struct FunctionValues {
    const TomlNode* table = nullptr; // [functions] of the scene; nullptr: it has none
    Place place;                     // of the table, else of the scene
};

// SYSTEM of the command line: a folder with system.toml, that file, or a name in `systems`.
// Errors (bad_input): none of these exists; the names in `systems` are suggested.
std::filesystem::path find_system(const std::string& argument, const std::filesystem::path& systems);

// Reads and checks a system file (docs/file_formats.md). Errors: bad_input: a rule there is broken; refused:
// the format foresees it, but the engine does not do it yet. With `values` every function of the file has
// one, which is read wherever the function stands: the system is as if its user had written that.
System read_system(const std::filesystem::path& file, const FunctionValues* values = nullptr);
// The same where this is not refused; else with numbers put in before the equilibrium is proved or found, as
// `settings` of the system tell. Those that name no parameter are left out. `option` is where they come from.
System read_system(const std::filesystem::path& file, const std::vector<Setting>& settings,
                   const std::string& option, const FunctionValues* values = nullptr);
System read_system_text(std::string_view toml, const std::filesystem::path& file,
                        const FunctionValues* values = nullptr);

} // namespace resonform
