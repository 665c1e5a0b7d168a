// SPDX-License-Identifier: GPL-3.0-or-later
// resonform regenerate [--check]: generated/<system>/<scene>.hpp of every scene, byte for byte.
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "emit/cpp.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct Entry {
    fs::path file; // relative to the home
    std::string state;
};

std::string compare(const fs::path& file, const std::string& header) {
    if (!fs::exists(file)) return "missing";
    return read_file(file) == header ? "up to date" : "out of date";
}

Entry regenerate_scene(const std::string& scene_file, const Home& home, bool check) {
    const SceneLine line = solve_scene(scene_file, home);
    const std::string header = emit_cpp(build_program(line.solution, line.scene));
    const fs::path file = home.generated() / line.scene.system->name / (line.scene.name + ".hpp");
    std::string state = compare(file, header);
    if (!check && state != "up to date") {
        make_folder(file.parent_path());
        write_file(file, header);
        state = "written";
    }
    return {fs::relative(file, home.folder), state};
}

// Headers whose scene is gone.
std::vector<Entry> orphans(const Home& home, const std::set<fs::path>& known) {
    std::vector<Entry> found;
    if (!fs::exists(home.generated())) return found;
    for (const auto& entry : fs::recursive_directory_iterator(home.generated())) {
        const fs::path file = fs::relative(entry.path(), home.folder);
        if (entry.is_regular_file() && file.extension() == ".hpp" && known.count(file) == 0)
            found.push_back({file, "without a scene"});
    }
    return found;
}

int run_regenerate(bool check, const std::string& format) {
    const Home home = find_home();
    if (!check && home.of_source_tree)
        bad_input({"regenerate must be run in a folder with systems/",
                   fs::current_path().string(),
                   "go to that folder; --check alone may be run anywhere",
                   {}});
    std::vector<Entry> entries;
    std::set<fs::path> known;
    const std::vector<SystemFiles> systems = list_systems(home);
    for (const SystemFiles& files : systems) require_name_of_folder(read_system(files.system));
    for (const SystemFiles& files : systems)
        for (const fs::path& scene : files.scenes) {
            entries.push_back(regenerate_scene(scene.string(), home, check));
            known.insert(entries.back().file);
        }
    for (Entry& orphan : orphans(home, known)) entries.push_back(std::move(orphan));

    bool good = true;
    Json files = Json::array();
    for (const Entry& entry : entries) {
        good = good && (entry.state == "up to date" || entry.state == "written");
        files.push_back({{"file", entry.file.string()}, {"state", entry.state}});
        if (format == "text") put("{:<64}{}\n", entry.file.string(), entry.state);
    }
    if (format == "json")
        put("{}\n", Json{{"schema", "resonform.regeneration/1"}, {"good", good}, {"files", files}}.dump(2));
    if (!good) say("resonform: run `resonform regenerate`, and delete headers without a scene");
    return good ? done : check_failed;
}

} // namespace

void add_regenerate(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("regenerate", "write generated/ anew from systems/");
    const auto check = std::make_shared<bool>(false);
    command->add_flag("--check", *check,
                      "write nothing; exit 1 if a file differs, is missing or has no scene");
    const FormatOption format(*command, {"text", "json"});
    command->callback([&action, check, format] {
        action = [check, format] { return run_regenerate(*check, format.value()); };
    });
}

} // namespace resonform
