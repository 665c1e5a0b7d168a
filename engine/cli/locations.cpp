// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/locations.hpp"

#include "algebra/number/error.hpp"
#include "cli/arguments.hpp"
#include "cli/output.hpp"
#include "model/files/read_system.hpp"
#include "model/system/names.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "verify/run/drafts.hpp"
#include "verify/run/installation.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace resonform {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const fs::path& file, const std::string& reason) {
    bad_input(Reason::file, {"the output must be a file in a folder that exists and can be written", reason,
                             "make the folder, free space, or give another path", whole_file(file)});
}

[[noreturn]] void cannot_write_into(const fs::path& folder, const std::string& reason) {
    bad_input(Reason::file, {"the folder must be one that can be made and written", reason,
                             "give another path", whole_file(folder)});
}

// A folder that is not there has no entries.
std::vector<fs::path> sorted_entries(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        entries.push_back(entry->path());
    if (error && error != std::errc::no_such_file_or_directory)
        bad_input(Reason::file, {"the folder must be readable", error.message(),
                                 "check the folder and its permissions", whole_file(folder)});
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::vector<SystemFiles> systems_of(const Home& home) {
    std::vector<SystemFiles> systems;
    for (const fs::path& folder : sorted_entries(home.systems())) {
        std::error_code error; // a link to itself, no permission: whoever reads the file complains
        if (!fs::exists(folder / "system.toml", error) && !error) continue;
        SystemFiles files{folder / "system.toml", {}};
        if (!error)
            for (const fs::path& scene : sorted_entries(folder / "scenes"))
                if (scene.extension() == ".toml") files.scenes.push_back(scene);
        systems.push_back(std::move(files));
    }
    return systems;
}

// The scenes that a wrong path may mean: those of its name, else those whose name is nearest.
std::vector<std::string> scenes_like(const std::string& argument, const Home& home) {
    std::vector<std::string> paths, names;
    for (const SystemFiles& files : systems_of(home))
        for (const fs::path& scene : files.scenes) {
            paths.push_back(scene.string());
            names.push_back(scene.stem().string());
        }
    const std::string near_path = nearest(argument, paths);
    if (!near_path.empty()) return {near_path};
    const std::string near_name = nearest(fs::path(argument).stem().string(), names);
    std::vector<std::string> found;
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (!near_name.empty() && names[i] == near_name) found.push_back(paths[i]);
    return found;
}

// "did you mean A or B? ", with names up to 300 bytes so that the hint behind it is not cut; "" for no names.
std::string question(const std::vector<std::string>& scenes) {
    constexpr std::size_t longest = 300;
    std::string text;
    for (const std::string& scene : scenes) {
        if (text.size() + scene.size() > longest) {
            text += text.empty() ? "" : " or another";
            break;
        }
        text += (text.empty() ? "did you mean " : " or ") + scene;
    }
    return text.empty() ? "" : text + "? ";
}

// Makes folders; the destructor removes those that are still empty.
class NewFolders {
public:
    NewFolders() = default;
    ~NewFolders() {
        std::error_code ignored;
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
    }
    NewFolders(const NewFolders&) = delete;
    NewFolders& operator=(const NewFolders&) = delete;

    void make(const fs::path& folder) {
        std::error_code ignored;
        std::vector<fs::path> missing; // the deepest first
        for (fs::path f = fs::absolute(folder).lexically_normal();
             !fs::exists(f, ignored) && f.has_relative_path(); f = f.parent_path())
            missing.push_back(f);
        made_.insert(made_.end(), missing.rbegin(), missing.rend());
        make_folder(folder);
    }

private:
    std::vector<fs::path> made_; // each before those in it
};

void write_draft(Drafts& drafts, const TextFile& file) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file.path, error); // a link is followed, not replaced
    if (error) cannot_write(file.path, error.message());
    if (fs::exists(target, error) && !fs::is_regular_file(target, error))
        cannot_write(file.path, "the path exists and is not a regular file");
    if (const std::error_code failed = drafts.write(target, file.content))
        cannot_write(file.path, failed.message());
}

} // namespace

Home find_home() {
    std::error_code ignored;
    const fs::path own = installation().data;
    if (fs::is_directory("systems", ignored) || !fs::is_directory(own / "systems", ignored)) return {};
    return {own, true};
}

void say_if_of_source_tree(const Home& home, const fs::path& system) {
    const fs::path inside = system.lexically_relative(home.systems());
    if (!home.of_source_tree || inside.empty() || *inside.begin() == "..") return;
    say(fmt::format("resonform: there is no systems/ here; the one used is {}", home.systems().string()));
}

fs::path find_system(const std::string& argument, const Home& home) {
    std::error_code ignored;
    fs::path file = find_system(argument, home.systems());
    if (!fs::exists(argument, ignored)) say_if_of_source_tree(home, file); // no path: a name
    return file;
}

std::vector<SystemFiles> list_systems(const Home& home) {
    std::vector<SystemFiles> systems = systems_of(home);
    if (systems.empty())
        bad_input(Reason::file,
                  {"there must be a system: a folder with system.toml", "none",
                   "add one, or go to a folder whose systems/ has one", whole_file(home.systems())});
    say_if_of_source_tree(home, systems.front().system);
    return systems;
}

void require_name_of_folder(const std::string& name, const Place& place) {
    const std::string folder = fs::absolute(place.file).parent_path().filename().string();
    if (folder == name) return;
    const std::string rename = "rename the folder to " + name;
    bad_input({fmt::format("a system in systems/ must have the name of its folder, '{}'", folder), name,
               is_identifier(folder) ? fmt::format("write name = \"{}\", or {}", folder, rename) : rename,
               place});
}

void check_name_of_folder(const System& system, const Home& home) {
    const fs::path& file = system.file;
    if (file.filename() != "system.toml") return; // a file by itself, in any folder
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
    std::error_code ignored;
    if (fs::equivalent(folder.parent_path(), home.systems(), ignored))
        return require_name_of_folder(system.name, system.name_place);
    if (folder.filename() == system.name) return;
    say(fmt::format("resonform: {} calls the system '{}', though its folder is '{}'", file.string(),
                    system.name, folder.filename().string()));
}

fs::path find_scene(const std::string& argument, const Home& home) {
    std::error_code ignored;
    if (fs::is_regular_file(argument, ignored)) return argument;
    bad_input(Reason::file,
              {"SCENE must be the path of a scene file, as systems/NAME/scenes/SCENE.toml",
               argument.empty()                ? as_found(argument)
               : fs::exists(argument, ignored) ? "no regular file"
                                               : "no such file",
               question(scenes_like(argument, home)) + "All scenes: resonform list", whole_file(argument)});
}

std::string read_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

void write_file(const fs::path& file, const std::string& content) {
    Drafts drafts;
    write_draft(drafts, {file, content});
    if (const std::error_code error = drafts.put_in_place()) cannot_write(file, error.message());
}

void require_place_for(const fs::path& file) {
    Drafts drafts;
    write_draft(drafts, {file, ""});
}

void write_files(const std::vector<TextFile>& files) {
    NewFolders folders;
    Drafts drafts; // gone before the folders
    for (const TextFile& file : files) {
        folders.make(file.path.parent_path());
        write_draft(drafts, file);
    }
    if (const std::error_code error = drafts.put_in_place())
        cannot_write(files.front().path, error.message());
}

void require_other_file(const fs::path& output, const std::vector<fs::path>& were_read) {
    std::error_code ignored; // no such file yet: not the same
    for (const fs::path& file : were_read)
        if (fs::equivalent(output, file, ignored))
            bad_input(Reason::file, {"the output must not be a file that was read", file.string(),
                                     "give another path", whole_file(output)});
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) cannot_write_into(folder, error.message());
}

void require_writable_folder(const fs::path& folder) {
    NewFolders folders;
    Drafts drafts;
    folders.make(folder);
    if (const std::error_code error = drafts.write(folder / ".resonform", "probe"))
        cannot_write_into(folder, error.message());
}

CacheFolder::CacheFolder(const Home& home) : path_(home.cache()) {
    const char* chosen = std::getenv("RESONFORM_CACHE"); // NOLINT(concurrency-mt-unsafe): nobody sets it here
    const bool is_chosen = chosen != nullptr && *chosen != '\0';
    if (is_chosen) path_ = chosen;
    try {
        require_writable_folder(path_);
    } catch (const Error& error) {
        if (is_chosen) {
            Diagnostic d = error.diagnostic();
            d.rule = "the cache must be a folder that can be written";
            d.hint = "set RESONFORM_CACHE to another folder, or unset it";
            bad_input(std::move(d));
        }
        std::string folder = (fs::temp_directory_path() / "resonform-XXXXXX").string();
        if (mkdtemp(folder.data()) == nullptr) throw;
        say(fmt::format("resonform: nothing is kept for the next run, {} cannot be written ({}); "
                        "RESONFORM_CACHE names another folder",
                        path_.string(), error.diagnostic().value));
        path_ = folder;
        temporary_ = true;
    }
}

CacheFolder::~CacheFolder() {
    std::error_code ignored;
    if (temporary_) fs::remove_all(path_, ignored);
}

} // namespace resonform
