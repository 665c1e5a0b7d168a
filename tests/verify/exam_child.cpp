// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that are run beside this one: what they print, how they end, and that they are not waited for
// forever.
#include "verify/run/child.hpp"
#include "verify/run/drafts.hpp"

#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

TEST(Child, PrintsAndEnds) {
    const Finished finished = run_child("echo text; exit 3", {}, 60);
    EXPECT_EQ(finished.output, "text\n");
    EXPECT_EQ(WEXITSTATUS(finished.status), 3);
    EXPECT_FALSE(finished.late);
    EXPECT_EQ(run_child("printf %s " + shell_quoted("it's $HOME"), {}).output, "it's $HOME");
}

// Whether it keeps its output open or not, and whatever it started: else this test is ended by its own time.
TEST(Child, IsEndedWithItsTime) {
    const test::Scratch scratch;
    const std::filesystem::path draft = scratch.path() / "draft";
    for (const char* command :
         {"sleep 10000", "exec >/dev/null 2>&1; sleep 10000", "trap '' TERM; sleep 10000 & wait"}) {
        test::write(draft, "half");
        const Finished finished = run_child(command, {draft}, 0.2);
        EXPECT_TRUE(finished.late) << command;
        EXPECT_NE(finished.status, 0) << command;
        EXPECT_FALSE(std::filesystem::exists(draft)) << command;
    }
}

TEST(Drafts, AreAllInPlaceOrNone) {
    const test::Scratch scratch;
    const auto one = scratch.path() / "one", other = scratch.path() / "absent/other";
    {
        Drafts drafts;
        EXPECT_FALSE(drafts.write(one, "text"));
        EXPECT_TRUE(drafts.write(other, "text"));
        EXPECT_TRUE(std::filesystem::exists(draft_of(one)));
    }
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
    Drafts drafts;
    EXPECT_FALSE(drafts.write(one, "text"));
    EXPECT_FALSE(drafts.put_in_place());
    EXPECT_EQ(test::read(one), "text");
    EXPECT_FALSE(std::filesystem::exists(draft_of(one)));
}

} // namespace
} // namespace resonform
