// SPDX-License-Identifier: GPL-3.0-or-later
// Includes point downwards: cli -> verify -> runtime -> emit -> ... -> algebra, and the runtime, which
// emitted code includes, needs nothing but itself.
#include "house/tree.hpp"

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

// "model" of `#include "model/expression.hpp"`; nothing for other lines and for <...>.
std::optional<std::string> included_room(const std::string& line) {
    const std::string start = "#include \"";
    if (line.compare(0, start.size(), start) != 0) return std::nullopt;
    const std::string path = line.substr(start.size(), line.rfind('"') - start.size());
    return path.substr(0, path.find('/'));
}

// The complaint about one include, empty when it is allowed.
std::string complaint(const std::string& from, const std::string& to) {
    if (!level(to)) return "is no room: includes are spelled \"room/file.hpp\"";
    if (from == "runtime" && to != "runtime") return "is not runtime: emitted code would need it";
    if (*level(to) > *level(from)) return "lies above";
    return "";
}

} // namespace

TEST(IncludeDirection, PointsDownwardsOnly) {
    const auto files = files_below({"engine"}, {".hpp", ".cpp"});
    ASSERT_GT(files.size(), 50U);
    for (const SourceFile& file : files) {
        const std::string from = file.path.substr(7, file.path.find('/', 7) - 7);
        ASSERT_TRUE(level(from)) << file.path << " stands in no room";
        for (const std::string& line : file.lines) {
            const auto to = included_room(line);
            if (to) {
                EXPECT_EQ(complaint(from, *to), "") << file.path << ": " << line;
            }
        }
    }
}

TEST(IncludeDirection, SeesAnUpwardInclude) {
    EXPECT_EQ(included_room("#include \"verify/ladder.hpp\" // why"), "verify");
    EXPECT_EQ(complaint("algebra", "model"), "lies above");
    EXPECT_EQ(complaint("runtime", "algebra"), "is not runtime: emitted code would need it");
    EXPECT_EQ(complaint("verify", "runtime"), "");
}

} // namespace resonform::test
