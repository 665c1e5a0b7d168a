// SPDX-License-Identifier: GPL-3.0-or-later
// Every mistake on the command line and in files: one message, exit code 2 or 3, nothing written.
#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace resonform::test {

namespace {

const std::string scene = "systems/almost_holonomic_pendulum/scenes/third_order.toml";

// What the command says on stderr, once: code, no output, one short message.
std::string complaint(const std::string& command, int code = 2) {
    const Outcome outcome = run(command, RESONFORM_SOURCE_DIR);
    EXPECT_EQ(outcome.code, code) << command << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_LE(outcome.err.size(), 2100U) << command;
    EXPECT_EQ(outcome.err.compare(0, 11, "resonform: "), 0) << command << "\n" << outcome.err;
    return outcome.err;
}

bool says(const std::string& text, const std::vector<std::string>& parts) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const std::string& part) { return text.find(part) != std::string::npos; });
}

} // namespace

#define EXPECT_SAYS(text, ...) EXPECT_TRUE(says(text, __VA_ARGS__)) << (text)

TEST(BadInput, CommandLine) {
    EXPECT_SAYS(complaint("resonform"), {"a command must be given", "resonform --help"});
    EXPECT_SAYS(complaint("resonform derve x"), {"derve", "did you mean derive?"});
    EXPECT_EQ(
        complaint("resonform derive"),
        "resonform: SYSTEM: derive needs it, a folder with system.toml, that file, or a name in systems/\n"
        "  hint:  see resonform derive --help\n");
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --ordr 3"),
                {"--ordr", "did you mean --order?"});
    EXPECT_EQ(complaint("resonform derive a b"), "resonform: derive takes no such argument\n"
                                                 "  found: b\n"
                                                 "  hint:  see resonform derive --help\n");
    EXPECT_EQ(complaint("resonform derive almost_holonomic_pendulum --order 3 --order 4"),
              "resonform: --order: must be given at most once\n"
              "  found: 3, 4\n"
              "  hint:  leave out all but one\n");
    EXPECT_EQ(complaint("resonform derive almost_holonomic_pendulum --order"),
              "resonform: --order: must be followed by its value\n"
              "  hint:  see resonform derive --help\n");
    // The next word is not its value, if it names an option; wherever the words stand.
    const std::string order_of_nothing = "resonform: --order: must be followed by its value\n"
                                         "  found: --stage, another option\n"
                                         "  hint:  see resonform derive --help\n";
    for (const char* words : {"henon_heiles --order --stage equations", "--order --stage equations",
                              "--order --stage=equations henon_heiles", "--order --stage"})
        EXPECT_SAYS(complaint(std::string("resonform derive ") + words),
                    {"--order: must be followed by its value", "found: --stage", ", another option"});
    EXPECT_EQ(complaint("resonform derive henon_heiles --order --stage equations"), order_of_nothing);
    EXPECT_SAYS(complaint("resonform derive henon_heiles --order -1"), {"--order", "from 1 to 99", "-1"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --format txt"), {"txt", "text"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --stage normal"),
                {"normal", "normal_form"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --stage solution --format maxima"),
                {"maxima"});
    EXPECT_SAYS(complaint("resonform verify " + scene + " --format yaml"), {"yaml", "text, json"});
}

TEST(BadInput, OptionsAndTheirPlaces) {
    for (const char* option : {"--digits", "--style", "--time-limit", "--memory-limit", "--term-limit"})
        EXPECT_SAYS(complaint(std::string("resonform derive henon_heiles ") + option + " ''"),
                    {option, "must be followed by its value"});
    for (const char* terms : {"0.5", "0", "-1", "1.5", "nan", "many"})
        EXPECT_SAYS(complaint(std::string("resonform derive henon_heiles --term-limit ") + terms),
                    {"--term-limit: must be a whole number >= 1, or none", terms});
    EXPECT_EQ(complaint("resonform --order 3 derive henon_heiles"),
              "resonform: an option follows its command, derive\n"
              "  found: --order\n"
              "  hint:  write resonform derive ... --order\n");
    EXPECT_SAYS(complaint("resonform derive --hlp"), {"--hlp", "did you mean --help?"});
}

TEST(BadInput, Orders) {
    for (const char* order : {"0", "-1", "100", "3.5", "1e3", "''", "three", "99999999999999999999"})
        EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --order " + std::string(order)),
                    {"--order", "from 1 to 99"});
    EXPECT_SAYS(complaint("resonform certify almost_holonomic_pendulum --order 0"),
                {"--order", "from 1 to 99"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --order 5/2"),
                {"--order: must be an integer from 1 to 99", "5/2"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --stage solution --truncation 2"),
                {"--truncation: must not be below the order, 3", "2", "--truncation 3"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulum --truncation 4"), {"--stage solution"});
}

// Weights in multiples of 1/2.
TEST(BadInput, RationalOrders) {
    for (const char* order : {"7/3", "-1/2", "1/0", "0", "1/4", "199/2", "x", "''"})
        EXPECT_EQ(
            complaint(std::string("resonform derive brusselator --order ") + order),
            "resonform: --order: must be a multiple of 1/2, as weights and powers of eps are, from 1/2 to "
            "99\n  found: " +
                std::string(order) + "\n  hint:  give for example --order 3 or --order 5/2\n");
    EXPECT_SAYS(complaint("resonform certify brusselator --order 7/3"), {"--order", "multiple of 1/2"});
    EXPECT_EQ(complaint("resonform derive brusselator --stage solution --order 3/2 --truncation 1"),
              "resonform: --truncation: must not be below the order, 3/2\n  found: 1\n"
              "  hint:  give --truncation 3/2 or more\n");
    const std::string compare = "resonform compare systems/brusselator/scenes/onto_the_cycle.toml --orders ";
    EXPECT_SAYS(complaint(compare + "1/2,7/3"), {"--orders: must be a multiple of 1/2", "to 63", "7/3"});
    EXPECT_SAYS(complaint(compare + "1,2/2"), {"--orders: each number must be given once", "second 2/2"});
}

TEST(BadInput, EpsAndTimes) {
    for (const char* eps : {"0", "-0.1", "nan", "inf", "''", "0.1x", "1/0", "1e9999", "'sqrt(2)'"})
        EXPECT_SAYS(complaint("resonform evaluate " + scene + " --t 1 --eps " + eps),
                    {"--eps", "must be a decimal number or a fraction > 0"});
    for (const char* eps : {"5", "0.51", "1e-13", "1e999", "2/3"})
        EXPECT_EQ(
            complaint("resonform evaluate " + scene + " --t 1 --eps " + eps),
            "resonform: --eps: eps lies in 1e-12 <= eps <= 0.5, where the expansion in eps has a meaning\n"
            "  found: " +
                std::string(eps) + "\n  hint:  give for example --eps 0.01 or --eps 1/100\n");
    for (const char* times : {"''", "1,,2", "1,two", "'1;2'", ","})
        EXPECT_SAYS(complaint("resonform evaluate " + scene + " --eps 0.1 --t " + times),
                    {"--t", "separated by commas"});
    for (const char* beyond : {"1e400", "-1e400", "1e-400", "1e5000", "1e400/1", "1/0"})
        complaint("resonform evaluate " + scene + " --eps 0.1 --t 1," + beyond);
    EXPECT_EQ(complaint("resonform evaluate " + scene + " --eps 0.1 --t 1,1e400"),
              "resonform: --t: a number is 0, or of size 1e-307 ... 1e308, as a double can be\n"
              "  found: 1e400\n"
              "  hint:  give a number of moderate size\n");
    EXPECT_SAYS(complaint("resonform derive henon_heiles --time-limit 1e400"),
                {"--time-limit: a number is 0, or of size", "1e400"});
}

TEST(BadInput, MissingFiles) {
    EXPECT_SAYS(complaint("resonform derive no_such_system"), {"no_such_system", "resonform list"});
    EXPECT_SAYS(complaint("resonform derive almost_holonomic_pendulun"), {"almost_holonomic_pendulum"});
    EXPECT_SAYS(complaint("resonform verify systems/no/scenes/such.toml"),
                {"SCENE must be the path of a scene file", "systems/no/scenes/such.toml"});
    EXPECT_SAYS(
        complaint("resonform evaluate --eps 0.1 --t 1 xy_onli"),
        {"did you mean systems/almost_holonomic_pendulum/scenes/xy_only.toml? All scenes: resonform list"});
    EXPECT_SAYS(complaint("resonform verify systems"), {"SCENE must be the path of a scene file"});
    EXPECT_SAYS(complaint("resonform derive README.md"), {"README.md"});
    EXPECT_SAYS(complaint("resonform verify ''"),
                {"SCENE must be the path of a scene file", "\n  found: ''\n"});
    EXPECT_SAYS(complaint("resonform ''"), {"the command must be one of", "\n  found: ''\n"});
}

// A folder that cannot be looked into hides none of the others.
TEST(BadInput, ALinkToItselfAmongTheSystems) {
    const Scratch scratch;
    write(scratch.path() / "systems/duffing/system.toml",
          "[system]\nname = \"duffing\"\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
          "x = \"x'' + x + x^3 = 0\"\n");
    std::filesystem::create_directories(scratch.path() / "systems/loop");
    std::filesystem::create_symlink("system.toml", scratch.path() / "systems/loop/system.toml");
    const Outcome outcome = run("resonform list", scratch.path());
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(outcome.out.compare(0, 7, "duffing"), 0) << outcome.out;
    EXPECT_SAYS(outcome.err, {"systems/loop/system.toml"});
    EXPECT_EQ(outcome.err.find("fault of the engine"), std::string::npos) << outcome.err;
}

// near = 1/5 keeps what omega = 1/10 divides: the normal form holds it, a closed solution does not.
TEST(BadInput, NearAboveAFrequency) {
    const Scratch scratch;
    write(scratch.path() / "systems/soft/system.toml",
          "[system]\nname = \"soft\"\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
          "x = \"x'' + x/100 = x^2\"\n[normal_form]\nnear = 0.2\n");
    const Outcome derived = run("resonform derive soft --order 2", scratch.path());
    EXPECT_EQ(derived.code, 0) << derived.err;
    const Outcome solved = run("resonform derive soft --order 2 --stage solution", scratch.path());
    EXPECT_EQ(solved.code, 3);
    EXPECT_SAYS(solved.err, {"normal_form.near: ", "is only near zero"});
    write(scratch.path() / "systems/soft/system.toml",
          "[system]\nname = \"soft\"\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
          "x = \"x'' + 4*x = x^2\"\n[normal_form]\nnear = 1e-400\n");
    EXPECT_EQ(run("resonform derive soft --order 2", scratch.path()).code, 0);
}

TEST(BadInput, OutputsThatCannotBeWritten) {
    const Scratch scratch;
    const std::string file = (scratch.path() / "file").string();
    write(file, "in the way");
    EXPECT_SAYS(complaint("resonform generate " + scene + " -o " + file + "/x.hpp"), {file, "folder"});
    EXPECT_SAYS(complaint("resonform generate " + scene + " -o " + scratch.path().string()),
                {"not a regular file"});
    EXPECT_SAYS(complaint("resonform generate " + scene + " -o " + scratch.path().string() + "/no/x.hpp"),
                {"folder"});
    EXPECT_SAYS(complaint("resonform verify " + scene + " --report " + file), {file, "Not a directory"});
    EXPECT_SAYS(complaint("resonform generate " + scene + " -o /dev/null"), {"not a regular file"});
    EXPECT_EQ(read(file), "in the way");
    const auto entries = std::filesystem::directory_iterator(scratch.path());
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 1) << "a half-written file was left";
}

// Said at once, not after the integrations; what was made to find out is gone.
TEST(BadInput, APlaceForTheReportIsTriedFirst) {
    const Scratch scratch;
    write(scratch.path() / "report/figures", "in the way");
    EXPECT_SAYS(complaint("resonform verify " + scene + " --report " + (scratch.path() / "report").string()),
                {"report/figures", "Not a directory"});
    if (std::filesystem::exists("/proc/self")) {
        EXPECT_SAYS(complaint("resonform verify " + scene + " --report /proc"),
                    {"/proc", "made and written"});
        EXPECT_SAYS(complaint("resonform verify " + scene + " --report /proc/a/b"),
                    {"/proc/a/b", "made and written"});
    }
    const auto bad = scratch.path() / "bad.toml";
    write(bad, "order = 0");
    complaint("resonform verify " + bad.string() + " --report " + (scratch.path() / "new/folder").string());
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "new"));
    if (geteuid() == 0) return; // who may write everywhere
    write(scratch.path() / "locked/file", "");
    std::filesystem::permissions(scratch.path() / "locked", std::filesystem::perms(0555));
    EXPECT_SAYS(complaint("resonform verify " + scene + " --report " + (scratch.path() / "locked").string()),
                {"locked", "Permission denied"});
    std::filesystem::permissions(scratch.path() / "locked", std::filesystem::perms(0755));
}

TEST(BadInput, WhatWasReadIsNotOverwritten) {
    const Scratch scratch;
    scratch.copy_systems();
    const auto folder = scratch.path() / "systems/almost_holonomic_pendulum";
    std::filesystem::create_hard_link(folder / "system.toml", scratch.path() / "linked.hpp");
    const std::string before = read(scratch.path() / scene), system = read(folder / "system.toml");
    for (const std::string& output : {scene, std::string("linked.hpp")}) {
        const Outcome outcome = run("resonform generate " + scene + " -o " + output, scratch.path());
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_SAYS(outcome.err, {output, "must not be a file that was read"});
    }
    EXPECT_EQ(read(scratch.path() / scene), before);
    EXPECT_EQ(read(folder / "system.toml"), system);
}

TEST(BadInput, EmptyPaths) {
    EXPECT_SAYS(complaint("resonform generate " + scene + " -o ''"), {"--output: ", "must not be empty"});
    EXPECT_SAYS(complaint("resonform verify " + scene + " --report ''"), {"--report", "must not be empty"});
}

TEST(BadInput, EvaluationNeedsEveryParameter) {
    const Scratch scratch;
    scratch.copy_systems();
    ASSERT_EQ(run("sed -i '/^g *=/d' " + scene, scratch.path()).code, 0);
    const Outcome outcome = run("resonform evaluate " + scene + " --eps 0.1 --t 1", scratch.path());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              "resonform: " + scene +
                  ":7:1: fix: evaluation needs a value for every parameter that the outputs depend "
                  "on\n    [fix]\n    ^\n  found: no value of g\n  hint:  add g = ... under [fix]\n");
    ASSERT_EQ(run("sed -i '/^[rv] *=/d' " + scene, scratch.path()).code, 0);
    for (const char* command : {"evaluate --eps 0.1 --t 1 ", "verify ", "compare "}) {
        const std::string said = run(std::string("resonform ") + command + scene, scratch.path()).err;
        EXPECT_SAYS(said, {scene + ":7:1: fix: ", "  found: no value of g, r, v\n",
                           "  hint:  add g = ... and r = ... and v = ... under [fix]\n"});
    }
    ASSERT_EQ(run("sed -i '/^.fix/d' " + scene, scratch.path()).code, 0);
    EXPECT_SAYS(run("resonform verify " + scene, scratch.path()).err, {scene + ": fix: ", "g, r, v"});
}

} // namespace resonform::test
