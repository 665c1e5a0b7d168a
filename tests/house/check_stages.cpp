// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of scripts/test.sh: one that runs no test or reads no file fails, and what is skipped or slow is
// named.
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

// Ten of twelve, the slowest first, whatever became of them and whatever else stands in their lines.
TEST(Stages, NameTheTenSlowestTests) {
    const Scratch scratch;
    std::string log;
    const auto line = [&log](const std::string& test) { log += "echo '" + test + "'\n"; };
    for (int k = 1; k <= 8; ++k) {
        const std::string n = std::to_string(k);
        line("  " + n + "/12 Test  #" + n + ": Quick.Number" + n + " ....   Passed    0.0" + n + " sec");
    }
    line("        Start 9: A/Suite.Of/one  # GetParam() = \"dots ... 7 sec\"");
    line(" 9/12 Test  #9: A/Suite.Of/one  # GetParam() = \"dots ... 7 sec\" ...   Passed  100.26 sec");
    line("10/12 Test #10: Ends.Badly .....***Exception: SegFault  9.50 sec");
    line("11/12 Test #11: Takes.TooLong .....***Timeout 300.01 sec");
    line("12/12 Test #12: Fails .....***Failed   20.00 sec");
    line("100% tests passed, 0 tests failed out of 12");
    write(scratch.path() / "log.sh", log);
    const Outcome outcome = stage(scratch, "tests", "bash log.sh");
    EXPECT_NE(outcome.out.find("slowest of planted:\n"
                               "     300.0 s  Takes.TooLong\n"
                               "     100.3 s  A/Suite.Of/one\n"
                               "      20.0 s  Fails\n"
                               "       9.5 s  Ends.Badly\n"
                               "       0.1 s  Quick.Number8\n"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find(" s  Quick.Number3\nlogs: "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("s  Quick.Number2\n"), std::string::npos) << outcome.out;
    EXPECT_TRUE(ends_with(outcome, "1 passed, 0 failed")) << outcome.out;
}

// As the ctest of this machine writes its lines.
TEST(Stages, NameTheSlowestTestsOfCtest) {
    const Scratch scratch;
    write(scratch.path() / "CTestTestfile.cmake", "add_test(Runs true)\nadd_test(Waits sleep 0.2)\n");
    const Outcome outcome = stage(scratch, "tests", "ctest --test-dir .");
    EXPECT_NE(outcome.out.find("slowest of planted:\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" s  Waits\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" s  Runs\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(stage(scratch, "files", "echo '3 files read'").out.find("slowest"), std::string::npos);
}

} // namespace resonform::test
