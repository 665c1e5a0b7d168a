// SPDX-License-Identifier: GPL-3.0-or-later
// resonform list: the systems of systems/ and their scenes.
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/locations.hpp"
#include "model/scene_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json describe(const SystemFiles& files, const Home& home) {
    const System system = read_system(files.system);
    Json scenes = Json::array();
    for (const auto& file : files.scenes) {
        const Scene scene = read_scene(file, home.systems());
        scenes.push_back({{"name", scene.name}, {"title", scene.title}, {"file", file.string()}});
    }
    return {
        {"name", system.name}, {"title", system.title}, {"file", files.system.string()}, {"scenes", scenes}};
}

int list(const std::string& format) {
    const Home home = find_home();
    Json systems = Json::array();
    for (const SystemFiles& files : list_systems(home)) systems.push_back(describe(files, home));
    if (format == "json") {
        fmt::print("{}\n", Json{{"schema", "resonform.list/1"}, {"systems", systems}}.dump(2));
        return done;
    }
    for (const Json& system : systems) {
        fmt::print("{:<32}{}\n", system["name"].get<std::string>(), system["title"].get<std::string>());
        for (const Json& scene : system["scenes"])
            fmt::print("  {:<30}{}\n", scene["name"].get<std::string>(), scene["title"].get<std::string>());
    }
    return done;
}

} // namespace

void add_list(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("list", "the systems at hand and their scenes");
    const FormatOption format(*command, {"text", "json"});
    command->callback([&action, format] { action = [format] { return list(format.value()); }; });
}

} // namespace resonform
