// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in emitted headers and what does not.
#include "emit/cpp/cpp.hpp"

#include "support/program.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace resonform {

namespace {

// The identifiers of a C++ text, comments left out.
std::set<std::string> identifiers(const std::string& text) {
    const std::string code = std::regex_replace(text, std::regex("//[^\n]*"), "");
    const std::regex word("[A-Za-z_][A-Za-z_0-9]*");
    std::set<std::string> result;
    for (std::sregex_iterator it(code.begin(), code.end(), word), end; it != end; ++it)
        result.insert(it->str());
    return result;
}

bool contains(const std::set<std::string>& words, const std::string& part) {
    for (const std::string& word : words)
        if (word.find(part) != std::string::npos) return true;
    return false;
}

int operations(const OperationCount& c) {
    return c.add + c.multiply + c.divide + c.root + c.sincos + c.other + c.tables;
}

// Compiles a header alone, with every warning an error; the compiler's complaints.
std::string complaints(const std::string& compiler, const std::string& header) {
    const test::Scratch scratch;
    test::write(scratch.path() / "scene.hpp", header);
    test::write(scratch.path() / "main.cpp",
                "#include \"scene.hpp\"\n"
                "namespace scene = resonform::generated::almost_holonomic_pendulum::third_order;\n"
                "template class scene::Evaluator<double>;\n"
                "template class scene::Evaluator<long double>;\n"
                "int main() { return 0; }\n");
    const test::Outcome outcome = test::run(
        compiler + " -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror "
                   "-fsyntax-only main.cpp",
        scratch.path());
    return outcome.code == 0 ? "" : outcome.err.substr(0, 2000) + "\n(no message)";
}

} // namespace

TEST(EmittedHeader, IsTheSameEachTime) {
    const Scene scene = test::pendulum_scene("third_order");
    EXPECT_EQ(emit_cpp(*test::program_of(scene)), emit_cpp(*test::program_of(scene)));
}

// Names of what a status says are texts, and no code.
std::string without_texts(const std::string& code) {
    return std::regex_replace(code, std::regex("\"[^\"\n]*\""), "\"\"");
}

TEST(EmittedHeader, OfThePathAloneHoldsNoPsi) {
    const auto program = test::program_of(test::pendulum_scene("xy_only"));
    EXPECT_EQ(without_texts(emit_cpp(*program)).find("psi"), std::string::npos);
    EXPECT_LT(operations(program->after), operations(program->before) / 4);
}

TEST(EmittedHeader, OfTheMeanMotionHoldsNoPhase) {
    const auto program = test::program_of(test::pendulum_scene("mean_motion"));
    const std::set<std::string> words = identifiers(without_texts(emit_cpp(*program)));
    for (const char* absent : {"cos", "theta", "psi", "phase", "Phase"})
        EXPECT_FALSE(contains(words, absent)) << absent;
    EXPECT_EQ(words.count("sin"), 0U);
    EXPECT_TRUE(program->phases.empty());
    EXPECT_EQ(program->after.sincos, 0);
    EXPECT_GT(program->before.sincos, 0);
    for (const ProgramInput& input : program->start) EXPECT_NE(input.name, "theta_0");
}

TEST(EmittedHeader, TakesAngleAmplitudeAndConstantsFromTheNotation) {
    const auto program = test::program_of(test::pendulum_scene("third_order"));
    std::vector<std::string> names;
    for (const ProgramInput& input : program->start) names.push_back(input.name);
    EXPECT_EQ(names, (std::vector<std::string>{"xi_0", "C_delta", "theta_0", "C_X", "C_Y"}));
    EXPECT_TRUE(program->parameters.empty()); // all are fixed
    const auto open = test::program_of(test::pendulum_scene("third_order"), {false, false});
    ASSERT_EQ(open->parameters.size(), 3U);
    EXPECT_EQ(open->parameters[0].name, "g");
}

// log((xi + sqrt(xi^2 + r^2))/r) loses its digits for xi < 0; asinh does not.
TEST(EmittedHeader, CancellingLogarithmsAreRewritten) {
    const std::set<std::string> words =
        identifiers(emit_cpp(*test::program_of(test::pendulum_scene("mean_motion"))));
    EXPECT_EQ(words.count("asinh"), 1U);
    EXPECT_EQ(words.count("log"), 0U);
}

// A file that brings the runtime along and one that includes it, of two scenes, in one program.
TEST(EmittedHeader, InlinedAndIncludedRuntimeGoTogether) {
    const test::Scratch scratch;
    test::write(scratch.path() / "inlined.hpp",
                emit_cpp(*test::program_of(test::pendulum_scene("xy_only")), {true}));
    test::write(scratch.path() / "also_inlined.hpp",
                emit_cpp(*test::program_of(test::pendulum_scene("as_published")), {true}));
    test::write(scratch.path() / "included.hpp",
                emit_cpp(*test::program_of(test::pendulum_scene("mean_motion"))));
    const std::string inlined = "#include \"inlined.hpp\"\n#include \"also_inlined.hpp\"\n",
                      included = "#include \"included.hpp\"\n";
    for (const std::string& both : {inlined + included, included + inlined}) {
        test::write(scratch.path() / "main.cpp", both + R"(
namespace scenes = resonform::generated::almost_holonomic_pendulum;
int main() {
    const scenes::xy_only::Evaluator<> path(0.1);
    const scenes::mean_motion::Evaluator<> mean(0.1);
    const scenes::as_published::Evaluator<> published(0.1);
    return path.construction_status() == mean.construction_status() ? 0 : 1;
}
)");
        const test::Outcome outcome = test::run(std::string(RESONFORM_CXX_COMPILER) + " -std=c++20 -I'" +
                                                    RESONFORM_SOURCE_DIR + "/engine' -fsyntax-only main.cpp",
                                                scratch.path());
        EXPECT_EQ(outcome.code, 0) << outcome.err.substr(0, 2000);
    }
}

// Compilers: the one that builds the engine, and the clang of packages_test.txt.
TEST(SlowEmittedHeader, CompilesWithoutWarnings) {
    const auto program = test::program_of(test::pendulum_scene("third_order"), {false, true});
    const std::string inlined = emit_cpp(*program, {true});
    EXPECT_EQ(inlined.find("#include \"runtime"), std::string::npos);
    EXPECT_EQ(complaints(RESONFORM_CXX_COMPILER, inlined), "");
    EXPECT_EQ(complaints("clang++-14", inlined), "");
}

} // namespace resonform
