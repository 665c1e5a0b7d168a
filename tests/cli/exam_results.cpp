// SPDX-License-Identifier: GPL-3.0-or-later
// resonform results: what is kept of every scene, goes on where it was ended, and is compared with what is
// found anew.
#include "support/command.hpp"
#include "support/documented.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

class SlowResults : public CommandOfSpring {
protected:
    [[nodiscard]] std::filesystem::path kept() const {
        return scratch_.path() / "kept/spring/s/results.json";
    }
};

} // namespace

TEST_F(SlowResults, AreKeptAndCompared) {
    const Outcome made = said("results kept --format json");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("1 of 1, 0 min so far: spring/s"), std::string::npos) << made.err;
    const Json document = Json::parse(made.out), results = Json::parse(read(kept()));
    EXPECT_EQ(document["scenes"][0]["state"], "written");
    for (const Json& json : {document, results})
        EXPECT_EQ(undocumented(json, file_formats()), std::set<std::string>());
    EXPECT_EQ(results["verification"]["outputs"][0]["verdict"], "pass");
    EXPECT_FALSE(results["comparison"].contains("rows"));
    EXPECT_NE(file("kept/README.md").find("[spring/s](spring/s/report.md)"), std::string::npos);
    EXPECT_EQ(file("kept/spring/s/report.md").find("Every run"), std::string::npos);

    // Nothing is made twice.
    EXPECT_NE(printed("results kept spring/s").find("up to date"), std::string::npos);

    EXPECT_NE(printed("results kept systems/spring/scenes/s.toml --check").find("same"), std::string::npos);
    Json changed = results;
    changed["verification"]["outputs"][0]["found_order"] = 7;
    write(kept(), changed.dump());
    const Outcome different = said("results kept --check");
    EXPECT_EQ(different.code, 1);
    EXPECT_NE(different.out.find("different\n  found_order of x: kept 7, now "), std::string::npos)
        << different.out;
    EXPECT_EQ(Json::parse(read(kept())), changed) << "a check writes nothing";

    // What an older commit has left is made anew.
    changed["commit"] = "0123";
    write(kept(), changed.dump());
    EXPECT_NE(printed("results kept").find("written"), std::string::npos);
}

TEST_F(SlowResults, OfWhatIsNotThere) {
    const Outcome unknown = said("results kept spring/t");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("results are kept of the scenes in systems/"), std::string::npos)
        << unknown.err;
    const Outcome missing = said("results kept --check");
    EXPECT_EQ(missing.code, 1);
    EXPECT_NE(missing.out.find("missing"), std::string::npos) << missing.out;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "kept"));
}

// A scene that cannot be read hides none of the others.
TEST_F(SlowResults, GoOnAfterAnError) {
    write(scratch_.path() / "systems/spring/scenes/a.toml", "order = 0\n");
    const Outcome outcome = said("results kept");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.out.find("failed\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("written\n"), std::string::npos) << outcome.out;
}

} // namespace resonform::test
