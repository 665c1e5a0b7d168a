// SPDX-License-Identifier: GPL-3.0-or-later
// No units include each other in a loop, and no folder has more files than one can take in.
#include "house/include_graph.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace resonform::test {

namespace {

constexpr std::size_t most_files = 42; // of a folder

// Folders with too many files -> how many they have.
std::map<std::string, std::size_t> crowded(const std::vector<SourceFile>& files) {
    std::map<std::string, std::size_t> count;
    for (const SourceFile& file : files) ++count[file.path.substr(0, file.path.rfind('/'))];
    for (auto folder = count.begin(); folder != count.end();)
        folder = folder->second > most_files ? std::next(folder) : count.erase(folder);
    return count;
}

} // namespace

TEST(Order, NoUnitsIncludeEachOther) {
    const std::vector<std::vector<std::string>> none;
    EXPECT_EQ(loops(include_graph(files_below({"engine"}, code))), none);
}

TEST(Order, ALoopTwoLevelsDeepIsSeen) {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "engine/algebra/ring/packed");
    const auto file = [&](const std::string& name, const std::string& text) {
        write(scratch.path() / "engine/algebra" / name, text);
    };
    file("ring/packed/word.hpp", "#pragma once\n");
    file("ring/packed/word.cpp",
         "#include \"algebra/ring/packed/word.hpp\"\n#include \"algebra/ring/ring.hpp\"\n");
    file("ring/ring.hpp", "#include \"algebra/sum.hpp\"\n");
    file("sum.hpp", "#include \"algebra/ring/packed/word.hpp\"\n");
    file("above.cpp", "#include \"algebra/sum.hpp\"\n#include <vector>\n");
    const std::vector<std::vector<std::string>> expected{
        {"algebra/ring/packed/word", "algebra/ring/ring", "algebra/sum"}};
    EXPECT_EQ(loops(include_graph(files_below(scratch.path(), {"engine"}, code))), expected);
}

TEST(Order, NoFolderIsCrowded) {
    const std::map<std::string, std::size_t> none;
    EXPECT_EQ(crowded(files_below({"engine", "tests", "generated"}, code)), none);
}

TEST(Order, ACrowdedFolderTwoLevelsDeepIsSeen) {
    const Scratch scratch;
    const std::string folder = "engine/algebra/ring/packed";
    std::filesystem::create_directories(scratch.path() / folder);
    for (std::size_t i = 0; i <= most_files; ++i)
        write(scratch.path() / folder / fmt::format("f{}.hpp", i), "#pragma once\n");
    const std::map<std::string, std::size_t> expected{{folder, most_files + 1}};
    EXPECT_EQ(crowded(files_below(scratch.path(), {"engine"}, code)), expected);
}

} // namespace resonform::test
