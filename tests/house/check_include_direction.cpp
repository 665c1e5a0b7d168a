// SPDX-License-Identifier: GPL-3.0-or-later
// Includes point downwards: cli -> verify -> runtime -> emit -> ... -> algebra, and the runtime, which
// emitted code includes, needs nothing but itself.
#include "house/tree.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace resonform::test {

namespace {

// Bottom up. A folder of a room that is not listed counts as the room that holds it.
const std::vector<std::string> rooms = {"algebra/number",
                                        "algebra/ring",
                                        "algebra/signs",
                                        "algebra/graph",
                                        "algebra/series",
                                        "model/text",
                                        "model/system",
                                        "model/signs",
                                        "model/exact",
                                        "model/integrals",
                                        "model/mechanics",
                                        "model/files",
                                        "expand/ring",
                                        "expand/modes",
                                        "expand/expansion",
                                        "normalize/recursion",
                                        "normalize/styles",
                                        "certify/points",
                                        "certify",
                                        "solve/flow",
                                        "solve",
                                        "emit/display",
                                        "emit/derive",
                                        "emit/graph",
                                        "emit/program",
                                        "emit/cpp",
                                        "runtime",
                                        "verify/run",
                                        "verify/integrate",
                                        "verify/evaluate",
                                        "verify/symbolic",
                                        "verify/estimate",
                                        "verify/judging",
                                        "verify/stability",
                                        "verify/comparison",
                                        "verify/report",
                                        "verify/sweep",
                                        "cli",
                                        "mpi"};

bool lies_in(const std::string& path, const std::string& room) {
    return path.compare(0, room.size() + 1, room + "/") == 0;
}

// Of "algebra/ring/ring.hpp".
std::optional<std::size_t> level(const std::string& path) {
    const auto at = std::find_if(rooms.begin(), rooms.end(),
                                 [&](const std::string& room) { return lies_in(path, room); });
    if (at == rooms.end()) return std::nullopt;
    return static_cast<std::size_t>(at - rooms.begin());
}

// The complaint about one include, empty when it is allowed.
std::string complaint(const std::string& from, const std::string& to) {
    if (!level(from)) return "stands in no room";
    if (!level(to)) return "is in no room: includes are spelled \"room/file.hpp\"";
    if (lies_in(from, "runtime") && !lies_in(to, "runtime"))
        return "is not runtime: emitted code would need it";
    if (*level(to) > *level(from)) return "lies above";
    return "";
}

// "engine/algebra/ring/ring.hpp: #include "model/system/names.hpp": lies above"
std::vector<std::string> complaints(const std::vector<SourceFile>& files) {
    std::vector<std::string> found;
    for (const SourceFile& file : files) {
        const std::string from = file.path.substr(std::string("engine/").size());
        for (const std::string& line : file.lines) {
            const auto to = included_file(line);
            if (!to) continue;
            const std::string said = complaint(from, *to);
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

TEST(IncludeDirection, IsWhatTheDocumentOfTheRoomsSays) {
    std::ifstream document(RESONFORM_SOURCE_DIR "/docs/architecture.md");
    std::vector<std::string> listed;
    for (std::string line; std::getline(document, line);)
        if (line.compare(0, 3, "| `") == 0) listed.push_back(line.substr(3, line.find('`', 3) - 3));
    EXPECT_EQ(listed, rooms);
}

TEST(IncludeDirection, IsWhatTheDrawingOfTheRoomsShows) {
    std::ifstream document(RESONFORM_SOURCE_DIR "/docs/architecture.md");
    std::string drawn;
    bool inside = false;
    for (std::string line; std::getline(document, line);) {
        if (line == "```") inside = false;
        if (inside) drawn += line + "\n";
        if (line == "```mermaid") inside = true;
    }
    EXPECT_EQ(drawn, run("scripts/draw_rooms.sh", RESONFORM_SOURCE_DIR).out);
}

TEST(IncludeDirection, SeesAnUpwardIncludeTwoLevelsDeep) {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "engine/algebra/ring/packed");
    write(scratch.path() / "engine/algebra/ring/packed/word.hpp",
          "#include \"algebra/graph/leaf_polynomial.hpp\" // why\n#include \"algebra/number/number.hpp\"\n");
    const auto found = complaints(files_below(scratch.path(), {"engine"}, code));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front(), "engine/algebra/ring/packed/word.hpp: "
                             "#include \"algebra/graph/leaf_polynomial.hpp\" // why: lies above");
}

TEST(IncludeDirection, KnowsWhatIsAllowed) {
    EXPECT_EQ(complaint("algebra/ring/ring.hpp", "model/text/lexer.hpp"), "lies above");
    EXPECT_EQ(complaint("runtime/flow.hpp", "algebra/number/number.hpp"),
              "is not runtime: emitted code would need it");
    EXPECT_EQ(complaint("verify/run/child.cpp", "runtime/flow.hpp"), "");
    EXPECT_EQ(complaint("attic/old.hpp", "algebra/number/number.hpp"), "stands in no room");
    EXPECT_EQ(complaint("algebra/number/number.hpp", "modular.hpp"),
              "is in no room: includes are spelled \"room/file.hpp\"");
}

} // namespace resonform::test
