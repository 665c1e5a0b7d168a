// SPDX-License-Identifier: GPL-3.0-or-later
// Is every key of a JSON document named in the section of its schema in docs/file_formats.md?
#pragma once

#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace resonform::test {

// The keys of a document and of the objects in its arrays; other objects have names of variables as keys.
inline std::set<std::string> keys_of(const nlohmann::json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) {
        keys.insert(key);
        if (!value.is_array()) continue;
        for (const nlohmann::json& element : value)
            if (element.is_object()) keys.merge(keys_of(element));
    }
    return keys;
}

// What stands between the name of the schema and that of the next.
inline std::string section_of(const std::string& schema, const std::string& text) {
    const std::size_t begin = text.find("`" + schema + "`");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find("`resonform.", begin + 1) - begin);
}

inline std::set<std::string> undocumented(const nlohmann::json& document, const std::string& text) {
    const std::set<std::string> of_a_term = {"schema", "variable", "exponents", "weight",
                                             "coefficient"}; // explained once for all sections
    const std::string section = section_of(document["schema"], text);
    std::set<std::string> missing;
    for (const std::string& key : keys_of(document))
        if (of_a_term.count(key) == 0 && !std::regex_search(section, std::regex("[`{ ]" + key + "[`,}]")))
            missing.insert(key);
    return missing;
}

inline std::string file_formats() {
    std::ifstream in(std::string(RESONFORM_SOURCE_DIR) + "/docs/file_formats.md");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace resonform::test
