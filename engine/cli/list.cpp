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

#include <algorithm>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

// What there is, and what could not be read.
struct Listing {
    Json systems = Json::array();
    int code = done; // the worst

    // One broken file hides none of the others.
    void complain(const Error& error) {
        say_error(error);
        code = std::max(code, static_cast<int>(error.kind()));
    }
};

Json list_scenes(const SystemFiles& files, Listing& listing) {
    Json scenes = Json::array();
    for (const auto& file : files.scenes) {
        try {
            const Heading scene = read_heading_of_scene(file);
            scenes.push_back({{"name", scene.name}, {"title", scene.title}, {"file", file.string()}});
        } catch (const Error& error) {
            listing.complain(error);
        }
    }
    return scenes;
}

Listing list_all(const Home& home) {
    Listing listing;
    for (const SystemFiles& files : list_systems(home)) {
        try {
            const Heading system = read_heading_of_system(files.system);
            require_name_of_folder(system.name, system.name_place);
            listing.systems.push_back({{"name", system.name},
                                       {"title", system.title},
                                       {"file", files.system.string()},
                                       {"scenes", list_scenes(files, listing)}});
        } catch (const Error& error) {
            listing.complain(error);
        }
    }
    return listing;
}

void print_text(const Json& systems) {
    for (const Json& system : systems) {
        put("{:<32}{}\n", system["name"].get<std::string>(), system["title"].get<std::string>());
        for (const Json& scene : system["scenes"])
            put("  {:<30}{}\n", scene["name"].get<std::string>(), scene["title"].get<std::string>());
    }
}

int list(const std::string& format) {
    const Listing listing = list_all(find_home());
    if (format == "json")
        put("{}", document_text(Json{{"schema", "resonform.list/1"}, {"systems", listing.systems}}));
    else
        print_text(listing.systems);
    return listing.code;
}

} // namespace

void add_list(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("list", "the systems at hand and their scenes");
    const FormatOption format(*command, {"text", "json"});
    command->callback([&action, format] { action = [format] { return list(format.value()); }; });
}

} // namespace resonform
