// SPDX-License-Identifier: GPL-3.0-or-later
// Every ```console block of README.md and docs/ is run, and what it shows is what the program prints.
//
//   $ command            run by bash, in a folder with copies of systems/ and generated/, and build/release
//   > more               the command goes on
//   output               standard output, line for line
//   ...                  any number of lines
//   took … s             … stands for any text within a line
//
// The blocks of one document are run in order in one folder.
#include "house/tree.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace resonform::test {

namespace {

struct Step {
    std::string command;
    std::vector<std::string> expected;
    std::size_t line = 0; // of the document, for the message
};

std::vector<Step> steps_of(const SourceFile& document) {
    std::vector<Step> steps;
    bool inside = false;
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
        const std::string& line = document.lines[i];
        if (line.compare(0, 3, "```") == 0) {
            inside = line == "```console";
        } else if (inside && line.compare(0, 2, "$ ") == 0) {
            steps.push_back({line.substr(2), {}, i + 1});
        } else if (inside && steps.back().expected.empty() && line.compare(0, 1, ">") == 0) {
            steps.back().command += "\n" + (line.size() > 2 ? line.substr(2) : "");
        } else if (inside) {
            steps.back().expected.push_back(line);
        }
    }
    return steps;
}

std::vector<std::string> split_lines(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// `pattern` with … for any text; matching is greedy from the left, piece by piece.
bool line_matches(const std::string& pattern, const std::string& line) {
    const std::string gap = "…";
    std::size_t from = 0, at = 0;
    for (bool first = true;; first = false) {
        const std::size_t end = pattern.find(gap, from);
        const std::string piece = pattern.substr(from, end == std::string::npos ? end : end - from);
        if (end == std::string::npos) { // the last piece ends the line
            if (first) return line == pattern;
            return line.size() >= at + piece.size() &&
                   line.compare(line.size() - piece.size(), piece.size(), piece) == 0;
        }
        const std::size_t found = line.find(piece, at);
        if (found == std::string::npos || (first && found != 0)) return false;
        at = found + piece.size();
        from = end + gap.size();
    }
}

using Lines = std::vector<std::string>;
bool matches(Lines::const_iterator pattern, Lines::const_iterator pattern_end, Lines::const_iterator line,
             Lines::const_iterator line_end) {
    if (pattern == pattern_end) return line == line_end;
    if (*pattern == "...") {
        for (auto rest = line;; ++rest) {
            if (matches(pattern + 1, pattern_end, rest, line_end)) return true;
            if (rest == line_end) return false;
        }
    }
    return line != line_end && line_matches(*pattern, *line) &&
           matches(pattern + 1, pattern_end, line + 1, line_end);
}
bool matches(const Lines& pattern, const Lines& lines) {
    return matches(pattern.begin(), pattern.end(), lines.begin(), lines.end());
}

std::vector<SourceFile> documents() {
    std::vector<SourceFile> found = files_below({"docs", "systems"}, {".md"});
    const std::string readme = read(std::filesystem::path(RESONFORM_SOURCE_DIR) / "README.md");
    found.push_back({"README.md", split_lines(readme)});
    return found;
}

} // namespace

TEST(Documents, ShowWhatTheProgramPrints) {
    std::size_t commands = 0;
    for (const SourceFile& document : documents()) {
        const Scratch scratch;
        scratch.copy_systems();
        std::filesystem::create_directory(scratch.path() / "build");
        std::filesystem::create_directory_symlink(RESONFORM_BINARY_DIR, scratch.path() / "build/release");
        for (const Step& step : steps_of(document)) {
            const Outcome outcome = run(step.command, scratch.path());
            EXPECT_TRUE(matches(step.expected, split_lines(outcome.out)))
                << document.path << ":" << step.line << ": $ " << step.command << "\nprints\n"
                << outcome.out << outcome.err;
            ++commands;
        }
    }
    EXPECT_GT(commands, 5U);
}

TEST(Documents, AWrongOutputWouldBeSeen) {
    EXPECT_TRUE(matches({"a", "...", "d"}, {"a", "b", "c", "d"}));
    EXPECT_TRUE(matches({"took … s, … points"}, {"took 1.5 s, 10 points"}));
    EXPECT_TRUE(matches({"..."}, {}));
    EXPECT_FALSE(matches({"took … s"}, {"took 1.5 minutes"}));
    EXPECT_FALSE(matches({"a"}, {"a", "b"}));
    EXPECT_FALSE(matches({"a", "b"}, {"a"}));
    EXPECT_FALSE(matches({"…b"}, {"ab "}));
}

} // namespace resonform::test
