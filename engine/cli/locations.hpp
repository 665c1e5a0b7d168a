// SPDX-License-Identifier: GPL-3.0-or-later
// Where systems/, generated/ and the cache of verifications stand, and how files are written there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resonform {

struct Home {
    std::filesystem::path folder; // ".", the current one, if it has systems/; else the source tree

    [[nodiscard]] std::filesystem::path systems() const { return (folder / "systems").lexically_normal(); }
    [[nodiscard]] std::filesystem::path generated() const {
        return (folder / "generated").lexically_normal();
    }
    [[nodiscard]] std::filesystem::path cache() const { return (folder / "build/cache").lexically_normal(); }
};
Home find_home();

// systems/*/system.toml and systems/*/scenes/*.toml, sorted by name.
struct SystemFiles {
    std::filesystem::path system;
    std::vector<std::filesystem::path> scenes;
};
std::vector<SystemFiles> list_systems(const Home& home);

std::string read_file(const std::filesystem::path& file);

// Writes the whole file or nothing: a temporary file beside it is renamed. Folders are not made.
// Errors (bad_input): the folder is absent or not writable, the target is no regular file.
void write_file(const std::filesystem::path& file, const std::string& content);

// Makes a folder and its parents. Errors (bad_input): it cannot be made or written, a file is in its way.
void make_folder(const std::filesystem::path& folder);

} // namespace resonform
