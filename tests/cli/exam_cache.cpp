// SPDX-License-Identifier: GPL-3.0-or-later
// Where results are kept from run to run, and what happens where they cannot be.
#include "support/command.hpp"

namespace resonform::test {

namespace {

class CacheOfTheCommand : public CommandOfSpring {
protected:
    [[nodiscard]] Outcome verified(const std::string& environment) const {
        return run("unset RESONFORM_CACHE; " + environment + " resonform verify systems/spring/scenes/s.toml",
                   scratch_.path());
    }
    [[nodiscard]] std::filesystem::path in(const char* name) const { return scratch_.path() / name; }
};
using SlowCacheOfTheCommand = CacheOfTheCommand;

} // namespace

TEST_F(SlowCacheOfTheCommand, StandsBesideTheSystemsOrWhereTheUserSays) {
    const Outcome first = verified("");
    EXPECT_NE(first.err.find("integrating directly"), std::string::npos) << first.err;
    EXPECT_TRUE(std::filesystem::exists(in("build/cache")));
    const Outcome second = verified("");
    EXPECT_EQ(second.err.find("integrating directly"), std::string::npos) << second.err;
    EXPECT_EQ(first.out, second.out);

    const Outcome elsewhere = verified("RESONFORM_CACHE=own/place");
    EXPECT_NE(elsewhere.err.find("integrating directly"), std::string::npos);
    EXPECT_FALSE(std::filesystem::is_empty(in("own/place")));
    EXPECT_EQ(elsewhere.out, first.out);
}

TEST_F(SlowCacheOfTheCommand, WithoutAPlaceOfItsOwnNothingIsKept) {
    write(in("build"), "in the way");
    std::filesystem::create_directories(in("temporary"));
    const Outcome outcome = verified("TMPDIR=$PWD/temporary");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(
        outcome.err.compare(0, 95,
                            "resonform: nothing is kept for the next run, build/cache cannot be written "
                            "(Not a directory); R"),
        0)
        << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(in("temporary"))) << "the temporary folder was left";
}

TEST_F(CacheOfTheCommand, APlaceThatTheUserNamesMustBeWritable) {
    write(in("file"), "in the way");
    const Outcome outcome = verified("RESONFORM_CACHE=file");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "resonform: file: the cache must be a folder that can be written\n"
                           "  found: Not a directory\n"
                           "  hint:  set RESONFORM_CACHE to another folder, or unset it\n");
}

} // namespace resonform::test
