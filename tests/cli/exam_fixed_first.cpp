// SPDX-License-Identifier: GPL-3.0-or-later
// Values of [fix] are put in before anything is refused: a scene that cannot be solved with symbols has the
// same numbers as one whose equations are written with the values of [fix].
#include "support/command.hpp"

#include <nlohmann/json.hpp>

#include <regex>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

struct Line {
    std::string variable, role, equation, start;
};

class FixedFirst : public Command {
protected:
    void files(const std::string& parameters, const std::vector<Line>& lines, const std::string& fix,
               const std::string& more = "") const {
        std::string variables, equations, start;
        for (const Line& line : lines) {
            variables.append(line.variable + " = { role = \"" + line.role + "\" }\n");
            equations.append(line.variable + " = \"" + line.equation + "\"\n");
            start.append(line.start + "\n");
        }
        write(scratch_.path() / "systems/s/system.toml", "[system]\nname = \"s\"\n[parameters]\n" +
                                                             parameters + "[variables]\n" + variables +
                                                             "[equations]\n" + equations + more);
        write(scratch_.path() / "systems/s/scenes/a.toml",
              "order = 2\n[fix]\n" + fix + "[start]\n" + start + "[verify]\neps = [0.1, 0.05, 0.02, 0.01]\n");
    }
    [[nodiscard]] Json values() const {
        return Json::parse(
            printed("evaluate systems/s/scenes/a.toml --eps 0.1 --t 0,1,7 --format json"))["outputs"];
    }
    // `lines` hold k, whose value is fixed, and nothing that proves what the derivation asks of it.
    void expect_as_written(const std::string& k, std::vector<Line> lines,
                           const std::string& more = "") const {
        files("k = {}\n", lines, "k = \"" + k + "\"\n", more);
        const Outcome derived = said("derive s --order 2");
        EXPECT_NE(derived.code, 0) << "with symbols it is not refused:\n" << derived.out;
        const Json fixed = values();
        for (Line& line : lines)
            line.equation = std::regex_replace(line.equation, std::regex("\\bk\\b"), "(" + k + ")");
        files("", lines, "", std::regex_replace(more, std::regex("\\bk\\b"), "(" + k + ")"));
        EXPECT_EQ(fixed, values());
    }
};
using SlowFixedFirst = FixedFirst;

const Line clock = {"tau", "slow", "tau' = eps", "tau = 0"};

} // namespace

TEST_F(FixedFirst, FunctionsAndRootsOfAParameter) {
    const std::string start = "x = \"eps\"\n\"x'\" = 0";
    expect_as_written("2", {{"x", "fast", "x'' + log(k)*x + x^3 = 0", start}});
    expect_as_written("1/2", {{"x", "fast", "x'' + x + asin(k)*x^2 = 0", start}});
    expect_as_written("3", {{"x", "fast", "x'' + sqrt(k)*x + k^(1/3)*x^2 = 0", start}});
}

TEST_F(FixedFirst, SignsAndDivisorsThatAreNotProved) {
    const std::string start = "x = \"eps\"\n\"x'\" = 0";
    expect_as_written("5", {{"x", "fast", "x'' + (k - 1)*x + x^2 = 0", start}});
    expect_as_written("5", {{"x", "fast", "x'' + x + x^2/(k - 1) = 0", start}});
    expect_as_written("1/3", {{"x", "fast", "x'' + 2*k*x' + x + x^2 = 0", start}});
    expect_as_written("2", {{"x", "fast", "x'' + (k + sin(tau))*x + x^2 = 0", start}, clock});
}

TEST_F(FixedFirst, DampingAndRatesWhoseSignIsFixed) {
    const std::string start = "x = \"eps\"\n\"x'\" = 0";
    // y decays, or grows; its rate has one weight only. (Of what decays, the rate is cut at N.)
    const std::vector<Line> lines = {{"x", "fast", "x'' + x + x^3 = 0", start},
                                     {"y", "fast", "y' = -k*y + x^2", "y = \"eps\""}};
    files("k = { nonzero = true }\n", lines, "k = 2\n");
    const Json fixed = values();
    files("", {lines[0], {"y", "fast", "y' = -2*y + x^2", "y = \"eps\""}}, "");
    EXPECT_EQ(fixed, values());
}

TEST_F(FixedFirst, AResonanceOfFixedFrequencies) {
    const Line x = {"x", "fast", "x'' + x + x*y = 0", "x = \"eps\"\n\"x'\" = 0"};
    const std::string start = "y = \"eps\"\n\"y'\" = 0";
    files("k = { positive = true }\n", {x, {"y", "fast", "y'' + k^2*y + x^2 = 0", start}}, "k = 2\n");
    EXPECT_EQ(said("derive s --order 2").code, 0);
    const Json fixed = values();
    files("", {x, {"y", "fast", "y'' + 4*y + x^2 = 0", start}}, "");
    EXPECT_EQ(fixed, values());
}

// Proved, or solved for, when the file is read.
TEST_F(FixedFirst, AnEquilibrium) {
    const std::vector<Line> enzyme = {{"s", "slow", "s' = eps*(c - s)", "s = 1"},
                                      {"c", "fast", "c' = s - (s + k)*c", "c = 0"}};
    const std::string solve = "[domain]\npositive = [\"s\"]\n[equilibrium]\nc = \"solve\"\n";
    expect_as_written("2", enzyme, solve);
    files("k = {}\n", enzyme, "k = 2\n", solve);
    EXPECT_EQ(said("derive s --order 1").code, 3);
    EXPECT_NE(printed("derive s --order 1 --set k=2").find("  c = s/(s + 2)\n"), std::string::npos);
    EXPECT_NE(said("derive s --order 1 --set k=2 q=3").err.find("does not name a parameter"),
              std::string::npos);
}

TEST_F(FixedFirst, WhatVanishesWithItsParameter) {
    const std::string start = "x = \"eps\"\n\"x'\" = 0";
    // A drift with a rate of weight 0, a damping at weight 0, a term that is no expansion, all absent.
    const std::vector<Line> drift = {{"x", "fast", "x'' + x + x^3 = 0", start},
                                     {"X", "drift", "X' = k + x^2", "X = 0"}};
    files("k = {}\n", drift, "k = 0\n");
    const Json fixed = values();
    files("", {drift[0], {"X", "drift", "X' = x^2", "X = 0"}}, "");
    EXPECT_EQ(fixed, values());
    files("k = {}\n", drift, "k = 1\n");
    EXPECT_NE(said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1").err.find("found: X' = 1 + x^2"),
              std::string::npos);
    expect_as_written("0", {{"x", "fast", "x'' + k*x' + x + x^3 = 0", start}});
    expect_as_written("0", {{"x", "fast", "x'' + x + x^3 + k*log(k + 2) + x*sqrt(1 - k) = 0", start}});
}

// A parameter without a value under [fix] is still an argument of the emitted evaluator.
TEST_F(FixedFirst, OthersStayParameters) {
    files("k = {}\nw = { positive = true }\n",
          {{"x", "fast", "x'' + (w + k^2 - 1)*x + x^3 = 0", "x = \"k*eps\"\n\"x'\" = 0"}}, "k = 1\n");
    const std::string header = printed("generate systems/s/scenes/a.toml");
    EXPECT_NE(header.find("with k = 1"), std::string::npos);
    EXPECT_NE(header.find("w;"), std::string::npos);
    EXPECT_EQ(header.find(" k;"), std::string::npos);
}

TEST_F(SlowFixedFirst, AreVerified) {
    files("k = {}\n", {{"x", "fast", "x'' + (k - 1)*x + x^2/(k - 3) = 0", "x = \"eps\"\n\"x'\" = 0"}},
          "k = 5\n");
    const Json json = Json::parse(printed("verify systems/s/scenes/a.toml --format json"));
    EXPECT_EQ(json["outputs"][0]["verdict"], "pass");
}

// Refused all the same: with the values, for what is left.
TEST_F(FixedFirst, WhatIsLeftIsSaid) {
    files("k = {}\nl = {}\n", {{"x", "fast", "x'' + (k - l)*x + x^2 = 0", "x = \"eps\"\n\"x'\" = 0"}},
          "k = 5\n");
    const Outcome left = said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1");
    EXPECT_EQ(left.code, 3);
    EXPECT_NE(left.err.find("found: omega^2 = -l + 5 for x"), std::string::npos) << left.err;
    files("k = {}\n", {{"x", "fast", "x'' + x + x^2/(k - 1) = 0", "x = \"eps\"\n\"x'\" = 0"}}, "k = 1\n");
    const Outcome pole = said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1");
    EXPECT_EQ(pole.code, 2);
    EXPECT_NE(pole.err.find("the values of [fix] make no denominator zero"), std::string::npos) << pole.err;
    // Of numbers exp(-k^2) and tanh(k) have no common part; that is not why there is no solution.
    files("k = {}\n",
          {{"x", "fast", "x'' + 2*x' + x + tanh(k)*exp(-k^2)*x^3 = 0", "x = \"eps\"\n\"x'\" = 0"}},
          "k = 1.48561\n");
    const Outcome critical = said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1");
    EXPECT_EQ(critical.code, 3);
    EXPECT_NE(critical.err.find("at critical damping it is not"), std::string::npos) << critical.err;
}

} // namespace resonform::test
