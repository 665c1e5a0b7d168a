// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/read_system.hpp"

#include "algebra/number/error.hpp"
#include "model/files/system_reader.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_tree.hpp"

#include <algorithm>
#include <vector>

namespace resonform {

namespace {

// The folders of `systems` that hold a system.toml, sorted.
std::vector<std::string> names_in(const std::filesystem::path& systems) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(systems, ignored)) {
        if (std::filesystem::is_regular_file(entry.path() / "system.toml", ignored)) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

std::filesystem::path find_system(const std::string& argument, const std::filesystem::path& systems) {
    std::error_code ignored;
    std::filesystem::path given(argument);
    if (!argument.empty()) {
        for (const std::filesystem::path& candidate : {given, systems / given}) {
            if (std::filesystem::is_regular_file(candidate / "system.toml", ignored)) {
                return candidate / "system.toml";
            }
        }
        if (std::filesystem::is_regular_file(given, ignored)) return given;
    }
    bad_input(Reason::file,
              {"SYSTEM must be a folder with system.toml, that file, or a name in " + systems.string(),
               argument.empty() ? "''" : excerpt(argument),
               suggest(argument, names_in(systems)) + "; all systems: resonform list", Place{}});
}

System read_system(const std::filesystem::path& file, const FunctionValues* values) {
    return read_system_text(read_text(file), file, values);
}

System read_system(const std::filesystem::path& file, const std::vector<Setting>& settings,
                   const std::string& option, const FunctionValues* values) {
    try {
        return read_system(file, values);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::refused || settings.empty()) throw;
    }
    return SystemReader(read_toml(read_text(file), file), file, values).read(settings, option);
}

System read_system_text(std::string_view toml, const std::filesystem::path& file,
                        const FunctionValues* values) {
    return SystemReader(read_toml(toml, file), file, values).read();
}

} // namespace resonform
