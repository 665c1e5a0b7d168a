// SPDX-License-Identifier: GPL-3.0-or-later
// Two types of one name in one namespace are one type to the linker: their destructors and copies are mixed
// up as soon as two files with one of each become a program.
#include "house/tree.hpp"
#include "support/shell.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>

namespace resonform::test {

namespace {

// "resonform::kernel": of all namespaces that a header opens, one within the other.
std::string namespace_of(const SourceFile& file) {
    static const std::regex opens("^(inline )?namespace ([A-Za-z_:]+) \\{");
    std::string name;
    for (const std::string& line : file.lines)
        if (std::smatch found; std::regex_search(line, found, opens))
            name += (name.empty() ? "" : "::") + found[2].str();
    return name;
}

std::vector<std::string> names_of_two_types(const std::vector<SourceFile>& files) {
    static const std::regex defines("^(struct|class) ([A-Za-z_]+)( final)?( : .*)? \\{");
    std::map<std::string, std::string> known;
    std::vector<std::string> twice;
    for (const SourceFile& file : files)
        for (const std::string& line : file.lines) {
            std::smatch found;
            if (!std::regex_search(line, found, defines)) continue;
            const std::string name = namespace_of(file) + "::" + found[2].str();
            const auto [at, fresh] = known.emplace(name, file.path);
            if (!fresh && at->second != file.path)
                twice.push_back(fmt::format("{} in {} and {}", name, at->second, file.path));
        }
    return twice;
}

} // namespace

TEST(TypeNames, StandForOneType) {
    const auto headers = files_below({"engine"}, {".hpp"});
    ASSERT_GT(headers.size(), 100U);
    EXPECT_EQ(names_of_two_types(headers), std::vector<std::string>());
}

TEST(TypeNames, ATwinTwoLevelsDeepIsSeen) {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "engine/emit/display");
    write(scratch.path() / "engine/a.hpp", "namespace resonform {\nstruct Series {\n};\nclass Line;\n}\n");
    write(scratch.path() / "engine/emit/display/b.hpp",
          "namespace resonform {\nclass Series final {\n};\nclass Line {\n};\n}\n");
    write(scratch.path() / "engine/emit/c.hpp", "namespace resonform::report {\nstruct Series {\n};\n}\n");
    const std::vector<std::string> expected{
        "resonform::Series in engine/a.hpp and engine/emit/display/b.hpp"};
    EXPECT_EQ(names_of_two_types(files_below(scratch.path(), {"engine"}, {".hpp"})), expected);
}

} // namespace resonform::test
