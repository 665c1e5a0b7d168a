// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every source file: its licence line, its length, and that the engine knows no system.
#include "house/tree.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace resonform::test {

namespace {

bool starts_with(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
}

std::string licence_of(const std::string& path) {
    // What emitted programs contain is MIT, all else GPL.
    return starts_with(path, "engine/runtime/") || starts_with(path, "generated/") ? "MIT"
                                                                                   : "GPL-3.0-or-later";
}

} // namespace

TEST(Files, BeginWithTheirLicence) {
    for (const SourceFile& file : files_below({"engine", "tests", "generated"}, code)) {
        ASSERT_FALSE(file.lines.empty()) << file.path;
        EXPECT_EQ(file.lines.front(), "// SPDX-License-Identifier: " + licence_of(file.path)) << file.path;
    }
}

TEST(Files, HaveOneReasonToExist) {
    constexpr std::size_t longest = 400;
    for (const SourceFile& file : files_below({"engine", "tests"}, code))
        EXPECT_LE(file.lines.size(), longest) << file.path << ": split it by its ideas";
}

TEST(Files, NameNoPlaceOfOneMachine) {
    const std::regex place("(^|[^A-Za-z0-9_.])/(work|root|home)/");
    for (const SourceFile& file :
         files_below({"engine", "tests", "generated", "systems", "docs", "scripts", "cmake"},
                     {".hpp", ".cpp", ".toml", ".md", ".sh", ".cmake", ".txt"}))
        for (const std::string& line : file.lines)
            EXPECT_FALSE(std::regex_search(line, place)) << file.path << ": " << line;
}

// Of a merge that was not finished.
TEST(Files, HoldNoTwoVersions) {
    const auto one = [](const std::string& name, const std::string& line) {
        EXPECT_FALSE(starts_with(line, "<<<<<<< ") || starts_with(line, ">>>>>>> ")) << name << ": " << line;
    };
    for (const SourceFile& file :
         files_below({"engine", "tests", "generated", "systems", "docs", "scripts", "cmake"},
                     {".hpp", ".cpp", ".toml", ".md", ".sh", ".cmake", ".txt"}))
        for (const std::string& line : file.lines) one(file.path, line);
    for (const char* name : {"README.md", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json"}) {
        std::istringstream lines(read(std::filesystem::path(RESONFORM_SOURCE_DIR) / name));
        for (std::string line; std::getline(lines, line);) one(name, line);
    }
}

// Systems are files of the user: no name or constant of one may stand in the engine's code. (Comments may
// show an example; single Greek letters stand in the alphabets of the printers.)
TEST(Files, OfTheEngineKnowNoSystem) {
    const std::regex known("pendulum|almost.?holonomic|stiffening|\"(psi'|theta_0|C_[A-Za-z]+)\"",
                           std::regex::icase);
    for (const SourceFile& file : files_below({"engine"}, code))
        for (const std::string& line : file.lines)
            EXPECT_FALSE(std::regex_search(without_comment(line), known)) << file.path << ": " << line;
}

TEST(Files, CommentsAreCutOff) {
    EXPECT_EQ(without_comment("int a; // b"), "int a; ");
    EXPECT_EQ(without_comment("f(\"http://x\");"), "f(\"http://x\");");
}

} // namespace resonform::test
