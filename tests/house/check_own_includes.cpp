// SPDX-License-Identifier: GPL-3.0-or-later
// Who calls a function includes its header: unity builds would let a file live off those before it.
#include "house/calls.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

TEST(OwnIncludes, WhoCallsAFunctionIncludesItsHeader) {
    const auto files = files_below({"engine"}, code);
    ASSERT_GT(files.size(), 50U);
    EXPECT_EQ(calls_without_include(files), std::vector<std::string>());
}

TEST(OwnIncludes, ACallTwoLevelsDeepIsSeen) {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "engine/algebra/ring/packed");
    const auto file = [&](const std::string& name, const std::string& text) {
        write(scratch.path() / "engine/algebra" / name, "namespace resonform {\n" + text + "}\n");
    };
    file("error.hpp", "[[noreturn]] void refuse(const Diagnostic& d);\nint size_of(int x);\n");
    file("sum.hpp", "#include \"algebra/error.hpp\"\nstruct Sum {\n    int total(int x) const;\n};\n");
    file("ring/packed/word.cpp", "#include \"algebra/sum.hpp\"\nvoid check(const Sum& s) {\n"
                                 "    if (s.total(1) > 0) refuse({\"refuse(\"}); // size_of(2)\n}\n");
    file("ring/packed/bits.cpp", "#include \"algebra/error.hpp\"\nvoid f() { refuse({size_of(1)}); }\n");
    file("ring/packed/pair.hpp", "#include \"algebra/error.hpp\"\n");
    file("ring/packed/pair.cpp",
         "#include \"algebra/ring/packed/pair.hpp\"\nint g() { return size_of(3); }\n");
    const std::vector<std::string> expected{"algebra/ring/packed/word.cpp calls refuse of algebra/error.hpp"};
    EXPECT_EQ(calls_without_include(files_below(scratch.path(), {"engine"}, code)), expected);
}

} // namespace resonform::test
