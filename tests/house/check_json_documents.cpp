// SPDX-License-Identifier: GPL-3.0-or-later
// docs/file_formats.md names every key that the commands print as JSON, in the section of its schema.
// (`compare` and `stability`, which take longer: tests/verify.)
#include "support/command.hpp"
#include "support/documented.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

const std::string scene = "systems/almost_holonomic_pendulum/scenes/third_order.toml";

} // namespace

TEST(JsonDocuments, EveryKeyIsDocumented) {
    for (const std::string& command :
         {std::string("derive almost_holonomic_pendulum --stage equations"),
          std::string("derive almost_holonomic_pendulum --stage expand"),
          std::string("derive almost_holonomic_pendulum"),
          std::string("derive almost_holonomic_pendulum --stage solution"),
          std::string("derive almost_holonomic_pendulum --stage transgression"),
          std::string("derive nonholonomic_particle --stage transgression"),
          std::string("certify almost_holonomic_pendulum --order 2"), "generate " + scene,
          "evaluate " + scene + " --eps 0.1 --t 1", std::string("list"), std::string("regenerate --check")}) {
        const Outcome outcome = run("resonform " + command + " --format json", RESONFORM_SOURCE_DIR);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(undocumented(Json::parse(outcome.out), file_formats()), std::set<std::string>()) << command;
    }
}

// A verdict that passes, and one without an order.
TEST(JsonDocuments, EveryKeyOfVerifyIsDocumented) {
    const Scratch scratch;
    write_spring(scratch.path());
    const auto verified = [&](const std::string& ladder) {
        write(scratch.path() / "systems/spring/scenes/s.toml",
              "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = 5\neps = " + ladder);
        const Outcome outcome =
            run("resonform verify systems/spring/scenes/s.toml --format json", scratch.path());
        const Json document = Json::parse(outcome.out);
        EXPECT_EQ(undocumented(document, file_formats()), std::set<std::string>());
        EXPECT_EQ(document["schema"], "resonform.verification/1");
        return document["outputs"][0];
    };
    const Json decided = verified("[0.1, 0.05, 0.02]\n"), undecided = verified("[0.1, 0.05]\n");
    EXPECT_EQ(decided["found_order"], 3);
    EXPECT_TRUE(decided["constant"].is_number());
    EXPECT_EQ(undecided["verdict"], "undecided");
    EXPECT_TRUE(undecided["found_order"].is_null());
    EXPECT_TRUE(undecided["constant"].is_null());
    EXPECT_NE(undecided["reason"], "");
}

TEST(JsonDocuments, AMissingKeyWouldBeSeen) {
    const Json document = Json::parse(R"({"schema": "resonform.x/1", "known": 1, "new": [{"inner": 1}]})");
    EXPECT_EQ(undocumented(document, "`resonform.x/1` has `known`, `resonform.y/1` has `new` and {inner}"),
              (std::set<std::string>{"inner", "new"}));
}

} // namespace resonform::test
