// SPDX-License-Identifier: GPL-3.0-or-later
// Which systems/ is used, what may stand in it, and what `list` and `regenerate` make of a broken one.
#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace resonform::test {

namespace {

namespace fs = std::filesystem;

const std::string system_text = "[system]\nname = \"swing\"\n[variables]\nx = { role = \"fast\" }\n"
                                "[equations]\nx = \"x'' + x = 0\"\n";

// One system, in a folder of the given name, with one scene.
void write_system(const fs::path& home, const std::string& folder) {
    write(home / "systems" / folder / "system.toml", system_text);
    write(home / "systems" / folder / "scenes/first.toml",
          "order = 2\n[start]\namplitude.x = 1\nphase.x = 0\n");
}

std::string in(const Outcome& outcome) { return outcome.out + outcome.err; }

} // namespace

TEST(Locations, ASystemHasTheNameOfItsFolder) {
    const Scratch scratch;
    write_system(scratch.path(), "swing");
    write_system(scratch.path(), "swing_copy");
    const std::string message =
        "resonform: systems/swing_copy/system.toml:2:9: system.name: a system in systems/ must have the name "
        "of its folder, 'swing_copy'\n    name = \"swing\"\n            ^\n  found: swing\n"
        "  hint:  write name = \"swing_copy\", or rename the folder to swing\n";
    const Outcome list = run("resonform list", scratch.path());
    EXPECT_EQ(list.code, 2);
    EXPECT_EQ(list.err, message);
    EXPECT_EQ(list.out.substr(0, 5), "swing");
    const Outcome regenerate = run("resonform regenerate", scratch.path());
    EXPECT_EQ(regenerate.code, 2);
    EXPECT_EQ(regenerate.err, message);
    EXPECT_TRUE(fs::exists(scratch.path() / "generated/swing/first.hpp"));
    EXPECT_FALSE(fs::exists(scratch.path() / "generated/swing_copy"));
}

TEST(Locations, AFolderWhoseNameNoSystemCanHaveIsRenamed) {
    const Scratch scratch;
    write_system(scratch.path(), "my swing");
    const Outcome list = run("resonform list", scratch.path());
    EXPECT_NE(list.err.find("\n  hint:  rename the folder to swing\n"), std::string::npos) << list.err;
}

TEST(Locations, RegenerateGoesOnPastWhatIsBrokenAndEndsWithTheWorst) {
    const Scratch scratch;
    write_system(scratch.path(), "swing");
    const fs::path scenes = scratch.path() / "systems/swing/scenes";
    write(scenes / "broken.toml", "oder = 2\n");
    ASSERT_EQ(run("resonform regenerate", scratch.path()).code, 2);
    write(scratch.path() / "generated/swing/broken.hpp", "made when the scene was whole");
    const Outcome check = run("resonform regenerate --check --format json", scratch.path());
    EXPECT_EQ(check.code, 2);
    EXPECT_NE(check.err.find("broken.toml:1:1: oder"), std::string::npos) << check.err;
    EXPECT_EQ(check.err.find("without a scene"), std::string::npos) << check.err;
    const auto document = nlohmann::json::parse(check.out);
    EXPECT_EQ(document["good"], false);
    EXPECT_EQ(document["files"].dump(), R"x([{"file":"generated/swing/broken.hpp","state":"failed"},)x"
                                        R"x({"file":"generated/swing/first.hpp","state":"up to date"}])x");
    write(scratch.path() / "systems/damped/system.toml", "[system]\nname = \"damped\"\n[variables]\n"
                                                         "x = { role = \"fast\" }\n[equations]\n"
                                                         "x = \"x'' + 2*x' + x = 0\"\n");
    write(scratch.path() / "systems/damped/scenes/first.toml",
          "order = 2\n[start]\namplitude.x = 1\nphase.x = 0\n");
    const Outcome refused = run("resonform regenerate", scratch.path());
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("oder"), std::string::npos) << refused.err;
}

TEST(Locations, ListGoesOnPastABrokenScene) {
    const Scratch scratch;
    write_system(scratch.path(), "swing");
    write(scratch.path() / "systems/swing/scenes/broken.toml", "oder = 2\n");
    write(scratch.path() / "systems/torn/system.toml", "[system\n");
    const Outcome list = run("resonform list --format json", scratch.path());
    EXPECT_EQ(list.code, 2);
    const auto systems = nlohmann::json::parse(list.out)["systems"];
    ASSERT_EQ(systems.size(), 1U);
    ASSERT_EQ(systems[0]["scenes"].size(), 1U);
    EXPECT_EQ(systems[0]["scenes"][0]["name"], "first");
    EXPECT_NE(list.err.find("broken.toml:1:1: oder"), std::string::npos) << list.err;
    EXPECT_NE(list.err.find("systems/torn/system.toml"), std::string::npos) << list.err;
}

// By its heading: nothing is derived, so that nothing can take long.
TEST(Locations, ListDerivesNoEquations) {
    const Scratch scratch;
    write(scratch.path() / "systems/odd/system.toml",
          "[system]\nname = \"odd\"\ntitle = \"cannot be derived\"\n[variables]\nx = { role = \"fast\" }\n"
          "[coordinates]\nx = {}\n[constraints]\nc = \"x' = 0\"\n");
    const Outcome list = run("resonform list", scratch.path());
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_NE(list.out.find("cannot be derived"), std::string::npos) << list.out;
    EXPECT_EQ(run("resonform derive odd", scratch.path()).code, 2);
}

TEST(Locations, AnEmptyOrUnreadableFolderIsSaid) {
    const Scratch scratch;
    fs::create_directory(scratch.path() / "systems");
    for (const char* command : {"resonform list", "resonform regenerate"}) {
        const Outcome empty = run(command, scratch.path());
        EXPECT_EQ(empty.code, 2);
        EXPECT_EQ(in(empty), "resonform: systems: there must be a system: a folder with system.toml\n"
                             "  found: none\n"
                             "  hint:  add one, or go to a folder whose systems/ has one\n");
    }
    write(scratch.path() / "systems/swing/system.toml", system_text);
    write(scratch.path() / "systems/swing/scenes", "a file in the place of a folder");
    const Outcome blocked = run("resonform list", scratch.path());
    EXPECT_EQ(blocked.code, 2);
    EXPECT_NE(blocked.err.find("the folder must be readable\n  found: Not a directory"), std::string::npos)
        << blocked.err;
}

TEST(Locations, TheSourceTreeIsReadWhenThereIsNoneHereAndNeverWritten) {
    const Scratch scratch;
    const std::string note = "resonform: there is no systems/ here; the one used is " +
                             (fs::path(RESONFORM_SOURCE_DIR) / "systems").string() + "\n";
    const Outcome list = run("resonform list", scratch.path());
    EXPECT_EQ(list.code, 0);
    EXPECT_EQ(list.err, note);
    EXPECT_EQ(list.out, run("resonform list", RESONFORM_SOURCE_DIR).out);
    EXPECT_EQ(run("resonform derive henon_heiles --stage equations", scratch.path()).err, note);
    write(scratch.path() / "here/system.toml", system_text);
    EXPECT_EQ(run("resonform derive here --stage equations", scratch.path()).err,
              "resonform: here/system.toml calls the system 'swing', though its folder is 'here'\n");
    const Outcome regenerate = run("resonform regenerate", scratch.path());
    EXPECT_EQ(regenerate.code, 2);
    EXPECT_NE(regenerate.err.find("regenerate must be run in a folder with systems/"), std::string::npos);
}

} // namespace resonform::test
