// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing stands in an emitted header on which no number and no status depends: each statement and each row
// of three scenes is deleted in turn.
#include "emit/deletions/deletions.hpp"
#include "support/shell.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace resonform::test {
namespace {

namespace fs = std::filesystem;

const fs::path source = RESONFORM_SOURCE_DIR;

std::string runtime_text() {
    std::string text;
    for (const auto& entry : fs::recursive_directory_iterator(source / "engine" / "runtime"))
        if (entry.path().extension() == ".hpp") text += read(entry.path());
    return text;
}

// The fields of a struct of a header.
std::vector<std::string> fields(const std::string& header, const std::string& name) {
    const std::size_t begin = header.find("struct " + name + " {");
    const std::string body = header.substr(begin, header.find("\n    };", begin) - begin);
    static const std::regex field(R"(Real (\w+)\{\};)");
    std::vector<std::string> names;
    for (std::sregex_iterator it(body.begin(), body.end(), field), end; it != end; ++it)
        names.push_back((*it)[1]);
    return names;
}

std::string listed(const std::vector<std::string>& names, const std::string& type) {
    std::string text;
    for (const std::string& name : names) text += fmt::format("&E::{}::{}, ", type, name);
    return text;
}

// What a statement sets is another number without it, not whatever lies there, which may be the same; and the
// probe decides whether constants are in range.
std::string for_probe(const std::string& header) {
    std::string once =
        std::regex_replace(header, std::regex(R"((\n        Number \w+);)"), "$1{Number(1.25)};");
    once = std::regex_replace(once, std::regex(R"(std::array<(\w+), (\d+)> start;)"),
                              "std::array<$1, $2> start = probe::filled<$1, $2>();");
    once = std::regex_replace(once, std::regex(R"(resonform::in_range<)"), "probe::in_range<");
    const std::size_t begin = once.find("struct Start {"), end = once.find("\n    };", begin);
    return once.substr(0, begin) +
           std::regex_replace(once.substr(begin, end - begin), std::regex(R"(\{\};)"), "{Real(1.25)};") +
           once.substr(end);
}

// A program that prints the numbers of the deletions that change nothing.
std::string program(const std::string& header, const std::string& scene, const Deletions& deletions) {
    std::string columns;
    for (const std::string& name : fields(header, "Start"))
        columns += fmt::format("all.emplace_back(n, at.{0});\n"
                               "for (std::size_t i = 0; i < n; ++i) all.back()[i] += 0.01 * i;\n"
                               "members.{0} = all.back().data();\n",
                               name);
    const std::vector<std::string> values = fields(header, "Values");
    return fmt::format(
        "#include \"emit/deletions/probe.hpp\"\n"
        "static int chosen = 0;\n"
        "inline bool gone(int n) {{ return n == chosen; }}\n{0}\n"
        "using E = resonform::generated::{1}::Evaluator<double>;\n"
        "std::vector<std::vector<double>> columns(std::size_t n, const E::Start& at, E::Members& members) "
        "{{\n"
        "std::vector<std::vector<double>> all;\n{2}return all;\n}}\n"
        "int main() {{\n"
        "return probe::tell_survivors({3}, chosen, [] {{\n"
        "return probe::Probe<E, {4}>{{columns, {{{5}}}, {{{6}}}, {{{7}}}, {{}}}}.all(); }});\n}}\n",
        deletions.text, std::regex_replace(scene, std::regex("/"), "::"), columns, deletions.places.size(),
        values.size(), listed(values, "Values"), listed(fields(header, "Start"), "Start"),
        listed(fields(header, "Parameters"), "Parameters"));
}

// What is known to change nothing, and why it stands there.
struct Spared {
    std::string scene, statement, reason;
};

const std::vector<Spared>& spared() {
    static const std::vector<Spared> list{
        {"crossing_rates/through_one_rate", "if (!(from.c_18 > From(0)))",
         "the condition 2*(s + 1) implies it"},
        {"crossing_rates/through_one_rate", "if (!(from.c_5 > From(0)))", "the condition 2*s implies it"},
        {"crossing_rates/through_one_rate", "if (fits) return {};",
         "saves constants in numbers of any range"},
        {"crossing_rates/through_one_rate", "if (probe::in_range<Number>(compute,",
         "saves the constants that phases do not read"},
        {"almost_holonomic_pendulum/third_order", "if (probe::in_range<Real>(hold,",
         "saves the conditions in numbers of any range"},
        {"almost_holonomic_pendulum/third_order", R"(if (!(holds[0] > resonform::Scaled<Real>(0))))",
         "where it fails another one does, of the same quantity"},
        {"almost_holonomic_pendulum/third_order", "c.c_28 = Number(1) / Number(64) * c.c_2;",
         "of such a condition"}};
    return list;
}

const Spared* spared(const std::string& scene, const std::string& statement) {
    for (const Spared& s : spared())
        if (s.scene == scene && statement.starts_with(s.statement)) return &s;
    return nullptr;
}

struct SlowDeletion : ::testing::TestWithParam<std::string> {};

} // namespace

TEST_P(SlowDeletion, OfEachStatementChangesANumberOrAStatus) {
    const std::string header = read(source / "generated" / (GetParam() + ".hpp"));
    const Deletions deletions = planted_deletions(for_probe(header), runtime_text());
    for (const std::string& declaration : deletions.unused) ADD_FAILURE() << "unused: " << declaration;
    ASSERT_GT(deletions.places.size(), 20U);
    const Scratch scratch;
    write(scratch.path() / "mutants.cpp", program(header, GetParam(), deletions));
    const Outcome made = run(fmt::format("{} -std=c++20 -O1 -w -I{}/engine -I{}/tests mutants.cpp -o mutants",
                                         RESONFORM_CXX_COMPILER, source.string(), source.string()),
                             scratch.path());
    ASSERT_EQ(made.code, 0) << made.err;
    const Outcome found = run("./mutants", scratch.path());
    ASSERT_EQ(found.code, 0) << found.err;
    std::istringstream survivors(found.out);
    std::set<const Spared*> seen;
    for (std::size_t n = 0; survivors >> n;) {
        const Spared* known = spared(GetParam(), deletions.places[n - 1]);
        EXPECT_NE(known, nullptr) << "without it nothing changes: " << deletions.places[n - 1];
        seen.insert(known);
    }
    for (const Spared& s : spared())
        EXPECT_TRUE(s.scene != GetParam() || seen.count(&s) > 0)
            << "without it something changes by now: " << s.statement << "  (" << s.reason << ")";
}

INSTANTIATE_TEST_SUITE_P(SlowScenes, SlowDeletion,
                         ::testing::Values("nonholonomic_particle/uniform_rise",
                                           "crossing_rates/through_one_rate",
                                           "almost_holonomic_pendulum/third_order"));

} // namespace resonform::test
