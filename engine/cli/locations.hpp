// SPDX-License-Identifier: GPL-3.0-or-later
// Where systems/, generated/ and the cache of verifications stand, and how files are written there.
#pragma once

#include "model/files/read_system.hpp"
#include "model/system/system_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace resonform {

struct Home {
    std::filesystem::path folder = "."; // the current one
    bool of_source_tree = false;        // the current one has no systems/: to be read, not to be written

    [[nodiscard]] std::filesystem::path systems() const { return (folder / "systems").lexically_normal(); }
    [[nodiscard]] std::filesystem::path generated() const {
        return (folder / "generated").lexically_normal();
    }
    [[nodiscard]] std::filesystem::path cache() const { return (folder / "build/cache").lexically_normal(); }
};
// The current folder if it has systems/; else the source tree if that is still there.
Home find_home();

// SYSTEM of the command line: find_system of model/files/read_system.hpp. A line on standard error says if a
// name is one of the source tree.
std::filesystem::path find_system(const std::string& argument, const Home& home);
// The same for a file that was found by its name, in a folder of systems.
void say_if_of_source_tree(const Home& home, const std::filesystem::path& system);

// systems/*/system.toml and systems/*/scenes/*.toml, sorted by name.
struct SystemFiles {
    std::filesystem::path system;
    std::vector<std::filesystem::path> scenes;
};
// Says if they are those of the source tree. Errors (bad_input): a folder cannot be read; there is no system.
std::vector<SystemFiles> list_systems(const Home& home);

// A system in systems/ has the name of its folder: generated/ is laid out by names, and two of one name
// would overwrite each other. Errors (bad_input): it has not.
void require_name_of_folder(const std::string& name, const Place& place);
// The same of a system.toml anywhere: outside of systems/ another name is only said, on standard error.
void check_name_of_folder(const System& system, const Home& home);

// SCENE of the command line, a path. Errors (bad_input): no file; scenes of a similar name are suggested.
std::filesystem::path find_scene(const std::string& argument, const Home& home);

std::string read_file(const std::filesystem::path& file);

// Writes the whole file or nothing: a temporary file beside it is renamed. Folders are not made.
// Errors (bad_input): the folder is absent or not writable, the target is no regular file.
// An interruption (Ctrl-C) waits until it is done.
void write_file(const std::filesystem::path& file, const std::string& content);

// Checks before a long computation that write_file() will be able to write. Errors: those of write_file().
void require_place_for(const std::filesystem::path& file);

struct TextFile {
    std::filesystem::path path;
    std::string content;
};
// The same of several: all of them or none. Their folders are made.
void write_files(const std::vector<TextFile>& files);

// Refuses to overwrite a file that was read, by whatever path. Errors (bad_input).
void require_other_file(const std::filesystem::path& output,
                        const std::vector<std::filesystem::path>& were_read);

// Makes a folder and its parents. Errors (bad_input): it cannot be made, a file is in its way.
void make_folder(const std::filesystem::path& folder);

// Makes the folder if it is not there and a file in it, then removes both: a test before a long computation
// whose results go there. Errors (bad_input): as make_folder; no file can be made.
void require_writable_folder(const std::filesystem::path& folder);

// Where integrations and compiled evaluators are kept: the folder of $RESONFORM_CACHE, else that of `home`.
// If the latter cannot be written, a line on standard error says so, and a temporary folder serves for as
// long as the object lives. Errors (bad_input): $RESONFORM_CACHE cannot be written.
class CacheFolder {
public:
    explicit CacheFolder(const Home& home);
    ~CacheFolder();
    CacheFolder(const CacheFolder&) = delete;
    CacheFolder& operator=(const CacheFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    bool temporary_ = false;
};

} // namespace resonform
