// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/locations.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace resonform {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const fs::path& file, const std::string& reason) {
    Place place;
    place.file = file.string();
    bad_input({"the output must be a file in a folder that exists and can be written", reason,
               "make the folder, or give another path", place});
}

std::vector<fs::path> sorted_entries(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder, error)) entries.push_back(entry.path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

} // namespace

Home find_home() {
    std::error_code error;
    if (fs::is_directory("systems", error)) return {"."};
    return {fs::path(RESONFORM_SOURCE_DIR)};
}

std::vector<SystemFiles> list_systems(const Home& home) {
    std::vector<SystemFiles> systems;
    for (const fs::path& folder : sorted_entries(home.systems())) {
        if (!fs::exists(folder / "system.toml")) continue;
        SystemFiles files{folder / "system.toml", {}};
        for (const fs::path& scene : sorted_entries(folder / "scenes"))
            if (scene.extension() == ".toml") files.scenes.push_back(scene);
        systems.push_back(std::move(files));
    }
    return systems;
}

std::string read_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

void write_file(const fs::path& file, const std::string& content) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error); // a link is followed, not replaced
    if (error) cannot_write(file, error.message());
    if (fs::exists(target, error) && !fs::is_regular_file(target, error))
        cannot_write(file, "the path exists and is not a regular file");
    const fs::path temporary = target.string() + fmt::format(".{}.tmp", getpid());
    {
        std::ofstream out(temporary, std::ios::binary);
        if (!out) cannot_write(file, "the folder does not exist or is not writable");
        out << content;
        out.flush();
        if (!out) error = std::make_error_code(std::errc::no_space_on_device);
    }
    if (!error) fs::rename(temporary, target, error);
    if (error) {
        const std::string reason = error.message();
        fs::remove(temporary, error);
        cannot_write(file, reason);
    }
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) cannot_write(folder, error.message());
    if (access(folder.c_str(), W_OK | X_OK) != 0) cannot_write(folder, "the folder is not writable");
}

} // namespace resonform
