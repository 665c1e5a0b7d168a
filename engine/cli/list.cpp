// SPDX-License-Identifier: GPL-3.0-or-later
// resonform list: the systems of systems/ and their scenes, by their headings: no equations are derived.
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/complaint.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "model/files/heading.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json list_scenes(const SystemFiles& files, Complaints& complaints) {
    Json scenes = Json::array();
    for (const auto& file : files.scenes)
        complaints.attempt([&] {
            const Heading scene = read_heading_of_scene(file);
            scenes.push_back({{"name", scene.name}, {"title", scene.title}, {"file", file.string()}});
        });
    return scenes;
}

Json list_all(const Home& home, Complaints& complaints) {
    Json systems = Json::array();
    for (const SystemFiles& files : list_systems(home))
        complaints.attempt([&] {
            const Heading system = read_heading_of_system(files.system);
            require_name_of_folder(system.name, system.name_place);
            systems.push_back({{"name", system.name},
                               {"title", system.title},
                               {"file", files.system.string()},
                               {"scenes", list_scenes(files, complaints)}});
        });
    return systems;
}

void print_text(const Json& systems) {
    for (const Json& system : systems) {
        put("{:<32}{}\n", system["name"].get<std::string>(), system["title"].get<std::string>());
        for (const Json& scene : system["scenes"])
            put("  {:<30}{}\n", scene["name"].get<std::string>(), scene["title"].get<std::string>());
    }
}

int list(const std::string& format) {
    Complaints complaints;
    const Json systems = list_all(find_home(), complaints);
    if (format == "json")
        put("{}", document_text(Json{{"schema", "resonform.list/1"}, {"systems", systems}}));
    else
        print_text(systems);
    return complaints.code;
}

} // namespace

void add_list(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("list", "the systems at hand and their scenes");
    const FormatOption format(*command, {"text", "json"});
    on_choice(*command, action, [=] { return list(format.value()); });
}

} // namespace resonform
