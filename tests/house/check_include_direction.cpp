// SPDX-License-Identifier: GPL-3.0-or-later
// Includes point downwards: cli -> verify -> runtime -> emit -> ... -> algebra, and the runtime, which
// emitted code includes, needs nothing but itself.
#include "house/tree.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace resonform::test {

namespace {

const std::vector<std::string> rooms = {"algebra", "model",   "expand", "normalize", "solve",
                                        "emit",    "runtime", "verify", "cli"};

std::optional<std::size_t> level(const std::string& room) {
    const auto at = std::find(rooms.begin(), rooms.end(), room);
    if (at == rooms.end()) return std::nullopt;
    return static_cast<std::size_t>(at - rooms.begin());
}

std::string room_of(const std::string& path) { return path.substr(0, path.find('/')); }

// The complaint about one include, empty when it is allowed.
std::string complaint(const std::string& from, const std::string& to) {
    if (!level(from)) return "stands in no room";
    if (!level(to)) return "is no room: includes are spelled \"room/file.hpp\"";
    if (from == "runtime" && to != "runtime") return "is not runtime: emitted code would need it";
    if (*level(to) > *level(from)) return "lies above";
    return "";
}

// "engine/algebra/ring.hpp: #include "model/names.hpp": lies above"
std::vector<std::string> complaints(const std::vector<SourceFile>& files) {
    std::vector<std::string> found;
    for (const SourceFile& file : files) {
        const std::string from = room_of(file.path.substr(std::string("engine/").size()));
        for (const std::string& line : file.lines) {
            const auto to = included_file(line);
            if (!to) continue;
            const std::string said = complaint(from, room_of(*to));
            if (!said.empty()) found.push_back(file.path + ": " + line + ": " + said);
        }
    }
    return found;
}

} // namespace

TEST(IncludeDirection, PointsDownwardsOnly) {
    const auto files = files_below({"engine"}, code);
    ASSERT_GT(files.size(), 50U);
    EXPECT_EQ(complaints(files), std::vector<std::string>());
}

TEST(IncludeDirection, SeesAnUpwardIncludeTwoLevelsDeep) {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "engine/algebra/ring/packed");
    write(scratch.path() / "engine/algebra/ring/packed/word.hpp",
          "#include \"model/text/lexer.hpp\" // why\n");
    const auto found = complaints(files_below(scratch.path(), {"engine"}, code));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front(),
              "engine/algebra/ring/packed/word.hpp: #include \"model/text/lexer.hpp\" // why: lies above");
}

TEST(IncludeDirection, KnowsWhatIsAllowed) {
    EXPECT_EQ(complaint("algebra", "model"), "lies above");
    EXPECT_EQ(complaint("runtime", "algebra"), "is not runtime: emitted code would need it");
    EXPECT_EQ(complaint("verify", "runtime"), "");
    EXPECT_EQ(complaint("attic", "algebra"), "stands in no room");
}

} // namespace resonform::test
