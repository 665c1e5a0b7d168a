// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of scripts/test.sh: one that runs no test or reads no file fails, and what is skipped is named.
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

namespace {

// Runs one stage and the summary in a folder of its own.
Outcome stage(const Scratch& scratch, const std::string& unit, const std::string& command) {
    write(scratch.path() / "stage.sh", ". " RESONFORM_SOURCE_DIR
                                       "/scripts/stages.sh\nlogs=logs\nmkdir -p logs\n"
                                       "stage planted " +
                                           unit + " " + command + "\nsum_up\n");
    return run("bash stage.sh", scratch.path());
}

bool ends_with(const Outcome& outcome, const std::string& line) {
    const std::string text = line + "\n";
    return outcome.out.size() >= text.size() &&
           outcome.out.compare(outcome.out.size() - text.size(), text.size(), text) == 0;
}

} // namespace

TEST(Stages, WithoutTestsFail) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "empty");
    const Outcome outcome = stage(scratch, "tests", "ctest --test-dir empty");
    EXPECT_NE(outcome.out.find("No tests were found"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("planted: no tests were read"), std::string::npos) << outcome.out;
    EXPECT_TRUE(ends_with(outcome, "0 passed, 1 failed")) << outcome.out;
    EXPECT_EQ(outcome.code, 1);
}

TEST(Stages, WithoutFilesFail) {
    const Scratch scratch;
    for (const std::string command : {"true", "echo '0 files read'"}) {
        const Outcome outcome = stage(scratch, "files", command);
        EXPECT_TRUE(ends_with(outcome, "0 passed, 1 failed")) << command << ": " << outcome.out;
        EXPECT_EQ(outcome.code, 1) << command;
    }
    EXPECT_EQ(stage(scratch, "files", "echo '3 files read'").code, 0);
}

TEST(Stages, ThatFailAreNotMadeGoodByTheirCount) {
    const Scratch scratch;
    const Outcome outcome = stage(scratch, "files", "bash -c 'echo 3 files read; exit 4'");
    EXPECT_TRUE(ends_with(outcome, "0 passed, 1 failed")) << outcome.out;
    EXPECT_EQ(outcome.code, 1);
}

TEST(Stages, NameTheTestsThatWereSkipped) {
    const Scratch scratch;
    write(scratch.path() / "CTestTestfile.cmake",
          "add_test(Runs true)\n"
          "add_test(Waits bash -c \"exit 77\")\n"
          "set_tests_properties(Waits PROPERTIES SKIP_RETURN_CODE 77)\n");
    const Outcome outcome = stage(scratch, "tests", "ctest --test-dir .");
    EXPECT_NE(outcome.out.find("1 skipped tests:\n  planted: Waits\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("2 tests"), std::string::npos) << outcome.out;
    EXPECT_TRUE(ends_with(outcome, "1 passed, 0 failed")) << outcome.out;
}

} // namespace resonform::test
