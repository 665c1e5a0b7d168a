// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever users call their things, emitted headers compile.
#include "emit/cpp/cpp.hpp"
#include "emit/cpp/names.hpp"

#include "model/files/read_scene.hpp"
#include "support/program.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

namespace resonform {

namespace {

// Every word that means something to C++ or to the emitted frame.
const std::vector<std::string>& taken_words() {
    static const std::vector<std::string> words = {
        "double",     "template",   "new",        "delete",    "and",       "xor",    "not_eq",
        "class",      "this",       "operator",   "namespace", "requires",  "int",    "long",
        "linux",      "unix",       "i386",       "M_PI",      "NAN",       "i",      "t",
        "c",          "a",          "w",          "T",         "values",    "status", "count",
        "none",       "prepared",   "Real",       "Number",    "Wide",      "start",  "begin",
        "outputs",    "parameters", "tables",     "given_eps", "batch",     "state",  "prepare",
        "finite",     "root",       "power",      "sqrt",      "sin",       "log",    "std",
        "math",       "size_t",     "resonform",  "Status",    "Evaluator", "Values", "Start",
        "Parameters", "Constants",  "Arguments",  "Interval",  "q_1",       "c_1",    "k_1",
        "c_2",        "theta",      "theta_rate", "cos_theta", "generated", "a__b",   "x_",
        "_X",         "phase"};
    return words;
}

Program oscillator() {
    const std::filesystem::path systems = test::source_dir() / "systems";
    const Scene scene =
        read_scene(systems / "slowly_stiffening_oscillator" / "scenes" / "third_order.toml", systems);
    return *test::program_of(scene);
}

// A parameter, a start value, a labelled quantity and an output for every word.
Program with_names(const std::vector<std::string>& words) {
    Program program = oscillator();
    Graph& graph = program.graph;
    const Graph::Node x = program.outputs.front().value;
    for (const std::string& word : words) {
        const Graph::Node parameter = graph.symbol("a parameter " + word);
        const Graph::Node start = graph.symbol("a start " + word);
        const Graph::Node named = graph.add({graph.multiply({parameter, program.slow_time}), start});
        program.parameters.push_back({word, "parameter", parameter, -1});
        program.start.push_back({word, "start", start, graph.rational(0)});
        program.names.push_back({word, named});
        program.outputs.push_back({word, graph.add({x, named, graph.multiply({named, named})})});
    }
    return program;
}

// The complaints of a compiler about the header and an evaluator of each real type.
std::string complaints(const Program& program, const std::string& compiler) {
    const test::Scratch scratch;
    test::write(scratch.path() / "scene.hpp", emit_cpp(program));
    test::write(scratch.path() / "main.cpp",
                "#include \"scene.hpp\"\nnamespace scene = " + cpp_namespace(program.system, program.scene) +
                    ";\ntemplate class scene::Evaluator<double>;\n"
                    "template class scene::Evaluator<resonform::Float128>;\n");
    const std::string engine = (test::source_dir() / "engine").string();
    const test::Outcome outcome = test::run(
        compiler + " -std=gnu++20 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -fsyntax-only -I" +
            engine + " main.cpp",
        scratch.path());
    return outcome.code == 0 ? "" : outcome.err.substr(0, 3000) + "\n(no message)";
}

} // namespace

TEST(SlowCppNames, EveryWordNamesAnything) {
    EXPECT_EQ(complaints(with_names(taken_words()), RESONFORM_CXX_COMPILER), "");
}

TEST(SlowCppNames, SystemsAndScenesAreNamespaces) {
    Program program = oscillator();
    const std::vector<std::pair<std::string, std::string>> names = {{"std", "int"},
                                                                    {"resonform", "math"},
                                                                    {"generated", "std"},
                                                                    {"linux", "third order\n#error \xc3\xa4"},
                                                                    {"Evaluator", "3/4\\"}};
    for (const auto& [system, scene] : names) {
        program.system = system;
        program.scene = scene;
        EXPECT_EQ(complaints(program, RESONFORM_CXX_COMPILER), "") << system << ", " << scene;
    }
}

TEST(CppNames, NamespacesKeepDifferentNamesApart) {
    std::set<std::string> all;
    const std::vector<std::string> scenes = {"a b", "a_b", "\xc3\xa4", "\xc3\xb6", "int", "a\nb", "a.b", "3"};
    for (const std::string& scene : scenes) all.insert(cpp_namespace("s", scene));
    EXPECT_EQ(all.size(), scenes.size());
    EXPECT_EQ(cpp_namespace("pendulum", "third-order"), "resonform::generated::pendulum::third_order");
    EXPECT_EQ(cpp_namespace("std", "int"), "resonform::generated::std_::int_");
}

TEST(CppNames, NoMacroIsAName) {
    const test::Scratch scratch;
    test::write(scratch.path() / "scene.hpp", emit_cpp(oscillator(), {true}));
    const test::Outcome outcome = test::run(
        std::string(RESONFORM_CXX_COMPILER) + " -std=gnu++20 -dM -E -x c++ scene.hpp", scratch.path());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    std::size_t seen = 0;
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_search(line, found, std::regex("^#define ([A-Za-z][A-Za-z0-9_]*)"))) continue;
        ++seen;
        EXPECT_NE(CppNames().unique(found[1]), found[1]) << line;
    }
    EXPECT_GT(seen, 50U);
}

TEST(CppNames, CommentsEndWithTheirLine) {
    Program program = oscillator();
    program.title = "one\ntwo\r\\";
    program.scene = "a\nb";
    program.notes = {"note\n#error\v"};
    std::istringstream lines(emit_cpp(program));
    for (std::string line; std::getline(lines, line) && line != "#pragma once";)
        EXPECT_EQ(line.rfind("//", 0), 0U) << line;
}

} // namespace resonform
