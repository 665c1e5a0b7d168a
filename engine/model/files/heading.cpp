// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/heading.hpp"

#include "algebra/number/error.hpp"
#include "model/files/mechanism_reader.hpp"
#include "model/system/names.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/toml_values.hpp"

namespace resonform {

namespace {

std::string text_or(const TomlNode& table, const std::string& key, const std::string& standard) {
    const TomlNode* node = table.find(key);
    const std::string text = node == nullptr ? "" : line_of(*node);
    return text.empty() ? standard : text;
}

} // namespace

const std::vector<std::string>& keys_of_systems() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all = {"system",      "parameters",  "variables",   "functions",
                                        "hamiltonian", "equations",   "domain",      "relations",
                                        "modes",       "equilibrium", "normal_form", "notation"};
        all.insert(all.end(), mechanism_tables().begin(), mechanism_tables().end());
        return all;
    }();
    return keys;
}

const std::vector<std::string>& keys_of_scenes() {
    static const std::vector<std::string> keys = {"system",     "title",          "order",       "time_scale",
                                                  "truncation", "outputs",        "oscillating", "transients",
                                                  "growing",    "error_estimate", "functions",   "fix",
                                                  "start",      "emit",           "verify"};
    return keys;
}

Heading heading_of_system(const TomlNode& root, const std::filesystem::path& file) {
    check_keys(root, keys_of_systems());
    const TomlNode* header = root.find("system");
    if (header == nullptr)
        bad_input({"the system file has no table [system]", "no [system]",
                   "begin the file with [system] and name = \"...\"", whole_file(file)});
    check_table(*header);
    check_keys(*header, {"name", "title", "source"});
    const TomlNode* name = header->find("name");
    if (name == nullptr)
        bad_input({"the system has no name", "[system]", "write name = \"...\" under [system]",
                   place_of(header->source)});
    Heading heading;
    heading.name = string_of(*name);
    if (!is_identifier(heading.name)) bad_value(*name, identifier_rule("a system's name"), identifier_hint());
    heading.name_place = place_of(name->source);
    heading.title = text_or(*header, "title", heading.name);
    heading.source = text_or(*header, "source", "");
    return heading;
}

Heading read_heading_of_system(const std::filesystem::path& file) {
    return heading_of_system(read_toml(read_text(file), file), file);
}

Heading heading_of_scene(const TomlNode& root, const std::filesystem::path& file) {
    check_keys(root, keys_of_scenes());
    Heading heading;
    heading.name = file.stem().string();
    const TomlNode* title = root.find("title");
    heading.title = title == nullptr ? heading.name : line_of(*title);
    return heading;
}

Heading read_heading_of_scene(const std::filesystem::path& file) {
    return heading_of_scene(read_toml(read_text(file), file), file);
}

} // namespace resonform
