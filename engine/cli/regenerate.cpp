// SPDX-License-Identifier: GPL-3.0-or-later
// resonform regenerate [--check]: generated/<system>/<scene>.hpp of every scene, byte for byte.
#include "algebra/number/error.hpp"
#include "cli/command.hpp"
#include "cli/complaint.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "model/files/read_system.hpp"
#include "model/text/diagnostic.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct RegenerateRequest {
    Home home;
    bool check;
    DerivationLimits limits;
};

struct Entry {
    fs::path file; // relative to the home
    std::string state;
};

struct Regeneration : Complaints {
    std::vector<Entry> entries;
};

std::string compare(const fs::path& file, const std::string& header) {
    if (!fs::exists(file)) return "missing";
    return read_file(file) == header ? "up to date" : "out of date";
}

// The state of the header of a scene after it was made anew.
std::string regenerate_scene(const fs::path& scene, const fs::path& file, const RegenerateRequest& request) {
    const std::string header = watched(request.limits, [&](Watch& watch) {
        const SceneLine line = solve_scene(scene.string(), request.home, watch);
        return header_of(line, watch).text;
    });
    std::string state = compare(file, header);
    if (!request.check && state != "up to date") {
        make_folder(file.parent_path());
        write_file(file, header);
        state = "written";
    }
    return state;
}

// The headers of one system. A broken file is said, and hides none of the others.
void regenerate_system(const SystemFiles& files, const RegenerateRequest& request, Regeneration& result) {
    const auto read = result.attempt([&] {
        const System system = read_system(files.system);
        require_name_of_folder(system.name, system.name_place);
    });
    for (const fs::path& scene : files.scenes) {
        const fs::path name = files.system.parent_path().filename() / (scene.stem().string() + ".hpp");
        const fs::path file = request.home.generated() / name;
        Entry entry{"generated" / name, "failed"};
        if (read) result.attempt([&] { entry.state = regenerate_scene(scene, file, request); });
        result.entries.push_back(std::move(entry));
    }
}

// Headers whose scene is gone.
std::vector<Entry> orphans(const Home& home, const std::vector<Entry>& made) {
    std::set<fs::path> known;
    for (const Entry& entry : made) known.insert(entry.file);
    std::vector<Entry> found;
    if (!fs::exists(home.generated())) return found;
    for (const auto& entry : fs::recursive_directory_iterator(home.generated())) {
        const fs::path file = fs::relative(entry.path(), home.folder);
        if (entry.is_regular_file() && file.extension() == ".hpp" && known.count(file) == 0)
            found.push_back({file, "without a scene"});
    }
    return found;
}

void print(const Regeneration& result, const std::string& format) {
    Json files = Json::array();
    for (const Entry& entry : result.entries) {
        files.push_back({{"file", entry.file.string()}, {"state", entry.state}});
        if (format == "text") put("{:<64}{}\n", entry.file.string(), entry.state);
    }
    if (format == "json")
        put("{}",
            document_text(Json{
                {"schema", "resonform.regeneration/1"}, {"good", result.code == done}, {"files", files}}));
}

int run_regenerate(const RegenerateRequest& request, const std::string& format) {
    const Home& home = request.home;
    if (!request.check && home.of_source_tree)
        bad_input(Reason::command_line, {"regenerate must be run in a folder with systems/",
                                         fs::current_path().string(),
                                         "go to that folder; --check alone may be run anywhere",
                                         {}});
    if (fs::exists(home.generated()) && !fs::is_directory(home.generated()))
        bad_input(Reason::file, {"generated must be a folder: headers are written there", "something else",
                                 "move it away", whole_file(home.generated())});
    Regeneration result;
    for (const SystemFiles& files : list_systems(home)) regenerate_system(files, request, result);
    for (Entry& orphan : orphans(home, result.entries)) result.entries.push_back(std::move(orphan));
    const bool stale = std::any_of(result.entries.begin(), result.entries.end(), [](const Entry& entry) {
        return entry.state != "up to date" && entry.state != "written" && entry.state != "failed";
    });
    if (stale) result.code = std::max<int>(result.code, check_failed);
    print(result, format);
    if (stale && request.check)
        say("resonform: run `resonform regenerate`, and delete headers without a scene");
    else if (stale)
        say("resonform: delete the headers without a scene");
    return result.code;
}

} // namespace

void add_regenerate(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("regenerate", "write generated/ anew from systems/");
    const auto check = std::make_shared<bool>(false);
    command->add_flag("--check", *check,
                      "write nothing; exit 1 if a file differs, is missing or has no scene");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_regenerate({find_home(), *check, limits.value()}, format.value());
    });
}

} // namespace resonform
