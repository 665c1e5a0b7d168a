// SPDX-License-Identifier: GPL-3.0-or-later
// A unit of resonform::batch that is compiled for a wider processor gives the linker nothing but the code of
// its own width: a function that another unit may hold, too, could be taken from here for a processor without
// the instructions.
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace resonform::test {

namespace {

// The functions that a unit gives to the linker: the sanitizers add data (the types of functions), which
// holds no instruction.
std::vector<std::string> functions_of(const std::string& object) {
    const Outcome outcome = run("nm -C -g --defined-only " + object, RESONFORM_BINARY_DIR);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> result;
    std::istringstream lines(outcome.out);
    for (std::string address, type, name; lines >> address >> type && std::getline(lines >> std::ws, name);)
        if (type == "T" || type == "W" || type == "i") result.push_back(name);
    return result;
}

std::vector<std::string> foreign(const std::vector<std::string>& functions, const std::string& width) {
    std::vector<std::string> result;
    for (const std::string& function : functions)
        if (function.find("resonform::kernel::batch_" + width + "::") == std::string::npos)
            result.push_back(function);
    return result;
}

// The object of a small source, compiled as the units are.
std::string compiled(const Scratch& scratch, const std::string& text) {
    write(scratch.path() / "unit.cpp", text);
    const Outcome outcome =
        run(std::string(RESONFORM_CXX_COMPILER) + " -std=c++20 -c unit.cpp -o unit.o", scratch.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return (scratch.path() / "unit.o").string();
}

} // namespace

TEST(Widths, HoldNothingButTheirOwnCode) {
    for (const std::string width : {"baseline", "avx2", "avx512"}) {
        const std::string object = "CMakeFiles/batch.dir/engine/runtime/widths/" + width + ".cpp.o";
        if (width != "baseline" && run("test -e " + object, RESONFORM_BINARY_DIR).code != 0)
            GTEST_SKIP() << "this processor has no width " << width;
        const std::vector<std::string> functions = functions_of(object);
        EXPECT_FALSE(functions.empty());
        EXPECT_EQ(foreign(functions, width), std::vector<std::string>());
    }
}

TEST(Widths, AFunctionOfAllUnitsIsSeen) {
    const Scratch scratch;
    const std::string object = compiled(scratch, "inline double twice(double x) { return 2*x; }\n"
                                                 "namespace resonform::kernel { inline namespace batch_avx2 "
                                                 "{ double f(double x) { return twice(x); } } }\n");
    EXPECT_EQ(foreign(functions_of(object), "avx2"), std::vector<std::string>{"twice(double)"});
}

} // namespace resonform::test
