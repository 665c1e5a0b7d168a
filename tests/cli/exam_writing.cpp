// SPDX-License-Identifier: GPL-3.0-or-later
// Files that cannot be written for want of room, and strings of the user that are not fit to be printed.
#include "support/command.hpp"

#include <nlohmann/json.hpp>

namespace resonform::test {

namespace {

class Writing : public CommandOfSpring {
protected:
    // With files of at most so many kB.
    [[nodiscard]] Outcome limited(int size, const std::string& command) const {
        return run("unset RESONFORM_CACHE; ulimit -f " + std::to_string(size) + "; resonform " + command,
                   scratch_.path());
    }
    void expect_no_draft() const {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch_.path()))
            EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    }
};

} // namespace

TEST_F(Writing, AFileThatGrowsTooLargeIsSaid) {
    write(scratch_.path() / "old.hpp", "of before");
    for (const char* file : {"new.hpp", "old.hpp"}) {
        const Outcome outcome = limited(1, std::string("generate systems/spring/scenes/s.toml -o ") + file);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, std::string("resonform: ") + file +
                                   ": the output must be a file in a folder that exists and can be written\n"
                                   "  found: File too large\n"
                                   "  hint:  make the folder, free space, or give another path\n");
    }
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "new.hpp"));
    EXPECT_EQ(file("old.hpp"), "of before");
    expect_no_draft();
    const Outcome printed = limited(1, "generate systems/spring/scenes/s.toml >printed");
    EXPECT_EQ(printed.code, 2);
    EXPECT_NE(printed.err.find("standard output: the results must be writable\n  found: File too large"),
              std::string::npos)
        << printed.err;
}

// The compiler has no room either, and is not to blame.
TEST_F(Writing, ACacheWithoutRoomIsSaid) {
    for (const int size : {1, 60}) { // for the source; for what is compiled
        const Outcome outcome = limited(size, "verify systems/spring/scenes/s.toml --format json");
        EXPECT_EQ(outcome.code, 2) << size << outcome.err;
        const auto document = nlohmann::json::parse(outcome.out);
        EXPECT_EQ(document["reason"], "file");
        EXPECT_EQ(document["rule"], "the folder of cached results can be written");
        EXPECT_EQ(document["found"], "File too large");
        EXPECT_EQ(std::filesystem::canonical(scratch_.path() / document["file"].get<std::string>()),
                  std::filesystem::canonical(scratch_.path() / "build/cache"));
        EXPECT_NE(document["hint"].get<std::string>().find("RESONFORM_CACHE"), std::string::npos);
        expect_no_draft();
    }
}

// Escape sequences, line breaks in a comment of emitted code, a mark that turns the direction of writing.
TEST_F(Writing, TitlesAreFitToBePrinted) {
    const std::string hostile = "\"a\\u001b[31m\\u0000b\\n#error c\\u202e <i>\"\n";
    const std::string clean = "a?[31m?b #error c??? <i>";
    write(scratch_.path() / "systems/spring/system.toml",
          "[system]\nname = \"spring\"\ntitle = " + hostile + "source = " + hostile +
              "[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x^3 = 0\"\n");
    const auto scene = scratch_.path() / "systems/spring/scenes/s.toml";
    write(scene, "title = " + hostile + read(scene) + "ulp = 20\nulp_reason = " + hostile);
    const auto systems = nlohmann::json::parse(printed("list --format json"))["systems"];
    EXPECT_EQ(systems[0]["title"], clean);
    EXPECT_EQ(systems[0]["scenes"][0]["title"], clean);
    for (const char* command :
         {"list", "generate systems/spring/scenes/s.toml", "verify systems/spring/scenes/s.toml"}) {
        const std::string text = printed(command);
        EXPECT_NE(text.find(clean), std::string::npos) << command << text;
        EXPECT_EQ(text.find('\x1b'), std::string::npos) << command;
        EXPECT_EQ(text.find("\n#error c"), std::string::npos) << command;
    }
}

} // namespace resonform::test
