// SPDX-License-Identifier: GPL-3.0-or-later
// docs/file_formats.md names every key that the commands print as JSON, in the section of its schema.
#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>
#include <set>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

// The keys of a document and of the objects in its arrays; deeper keys are names of variables.
std::set<std::string> keys_of(const Json& document) {
    std::set<std::string> keys;
    for (const auto& [key, value] : document.items()) {
        keys.insert(key);
        if (!value.is_array()) continue;
        for (const Json& element : value)
            if (element.is_object())
                for (const auto& entry : element.items()) keys.insert(entry.key());
    }
    return keys;
}

// What stands between the name of the schema and that of the next.
std::string section_of(const std::string& schema, const std::string& text) {
    const std::size_t begin = text.find("`" + schema + "`");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find("`resonform.", begin + 1) - begin);
}

// A term is explained once for all sections.
const std::set<std::string> of_a_term = {"schema", "variable", "exponents", "weight", "coefficient"};

std::set<std::string> undocumented(const Json& document, const std::string& text) {
    const std::string section = section_of(document["schema"], text);
    std::set<std::string> missing;
    for (const std::string& key : keys_of(document))
        if (of_a_term.count(key) == 0 && !std::regex_search(section, std::regex("[`{ ]" + key + "[`,}]")))
            missing.insert(key);
    return missing;
}

const std::string scene = "systems/almost_holonomic_pendulum/scenes/third_order.toml";

} // namespace

TEST(JsonDocuments, EveryKeyIsDocumented) {
    const std::string text = read(std::filesystem::path(RESONFORM_SOURCE_DIR) / "docs/file_formats.md");
    for (const std::string& command :
         {std::string("derive almost_holonomic_pendulum --stage equations"),
          std::string("derive almost_holonomic_pendulum --stage expand"),
          std::string("derive almost_holonomic_pendulum"),
          std::string("derive almost_holonomic_pendulum --stage solution"),
          std::string("certify almost_holonomic_pendulum --order 2"), "generate " + scene,
          "evaluate " + scene + " --eps 0.1 --t 1", std::string("list")}) {
        const Outcome outcome = run("resonform " + command + " --format json", RESONFORM_SOURCE_DIR);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(undocumented(Json::parse(outcome.out), text), std::set<std::string>()) << command;
    }
}

TEST(JsonDocuments, AMissingKeyWouldBeSeen) {
    const Json document = Json::parse(R"({"schema": "resonform.x/1", "known": 1, "new": [{"inner": 1}]})");
    EXPECT_EQ(undocumented(document, "`resonform.x/1` has `known`, `resonform.y/1` has `new` and {inner}"),
              (std::set<std::string>{"inner", "new"}));
}

} // namespace resonform::test
