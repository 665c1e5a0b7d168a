// SPDX-License-Identifier: GPL-3.0-or-later
// Streams that are closed or full: results must arrive or the exit code says that they did not; what is
// said on standard error may be lost, and nothing else with it.
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

namespace {

const std::string quick_scene = "systems/almost_holonomic_pendulum/scenes/xy_only.toml";

Outcome run_here(const std::string& command) { return run(command, RESONFORM_SOURCE_DIR); }

} // namespace

TEST(Streams, ResultsThatCannotBePrinted) {
    for (const std::string& command :
         {std::string("--help"), std::string("--version"), std::string("list"), std::string("list --help"),
          std::string("derive almost_holonomic_pendulum"), std::string("list --format json"),
          std::string("certify almost_holonomic_pendulum --order 2"), "generate " + quick_scene,
          "evaluate " + quick_scene + " --eps 0.1 --t 1"})
        for (const auto& [redirection, reason] :
             {std::pair(" >/dev/full", "No space left on device"), {" >&-", "Bad file descriptor"}}) {
            const Outcome outcome = run_here("resonform " + command + redirection);
            EXPECT_EQ(outcome.code, 2) << command << redirection;
            const std::string message =
                std::string("resonform: standard output: the results must be writable\n") +
                "  found: " + reason + "\n" + "  hint:  free space, or redirect them elsewhere\n";
            EXPECT_NE(outcome.err.find(message), std::string::npos) << command << "\n" << outcome.err;
        }
}

TEST(Streams, MessagesThatCannotBePrintedChangeNoExitCode) {
    for (const char* redirection : {" 2>&-", " 2>/dev/full", " 2>&- <&-"}) {
        EXPECT_EQ(run_here(std::string("resonform derive nope") + redirection).code, 2) << redirection;
        EXPECT_EQ(run_here(std::string("resonform derive nope >&-") + redirection).code, 2) << redirection;
        const Outcome header = run_here("resonform generate " + quick_scene + redirection);
        EXPECT_EQ(header.code, 0) << redirection;
        EXPECT_NE(header.out, "") << redirection;
    }
}

// A file that is opened while standard error is closed would take its number, and the messages.
TEST(Streams, MessagesDoNotGoIntoTheUsersFile) {
    const Scratch scratch;
    const std::string file = (scratch.path() / "xy.hpp").string();
    EXPECT_EQ(run_here("resonform generate " + quick_scene + " -o " + file + " 2>&-").code, 0);
    EXPECT_EQ(read(file), run_here("resonform generate " + quick_scene).out);
}

} // namespace resonform::test
