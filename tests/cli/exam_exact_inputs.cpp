// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are taken as a mathematician writes them: 1/10, sqrt(2), asin(1/2).
#include "support/command.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

class ExactInputs : public Command {
protected:
    void system(const std::string& parameters, const std::string& equation) const {
        write(scratch_.path() / "systems/s/system.toml",
              "[system]\nname = \"s\"\n[parameters]\n" + parameters +
                  "\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n" +
                  equation + "\n");
    }
    // Two uncoupled or coupled oscillators, the first hardening.
    void oscillators(const std::string& x, const std::string& y) const {
        system("w = { positive = true }\nv = { positive = true }",
               "x = \"x'' + " + x + " + x^3 = 0\"\ny = \"y'' + " + y + " = 0\"");
    }
    void scene(const std::string& fix, const std::string& start = "amplitude.x = 1\nphase.x = 0\n"
                                                                  "amplitude.y = 1\nphase.y = 0") const {
        write(scratch_.path() / "systems/s/scenes/a.toml",
              "order = 2\noutputs = [\"x\"]\n[fix]\n" + fix + "\n[start]\n" + start + "\n");
    }
    [[nodiscard]] std::vector<double> values(const std::string& eps = "0.1") const {
        return Json::parse(printed("evaluate systems/s/scenes/a.toml --eps " + eps +
                                   " --t 0,1,7 --format json"))["outputs"]["x"];
    }
    void expect_same(const std::vector<double>& a, const std::vector<double>& b) const {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 4e-16) << i;
    }
};
using SlowExactInputs = ExactInputs;

} // namespace

TEST_F(ExactInputs, EpsIsAFraction) {
    oscillators("w^2*x", "v^2*y");
    scene("w = 2\nv = 3.5");
    EXPECT_EQ(values("1/10"), values("0.1"));
    EXPECT_EQ(values("1/30"), values("0.033333333333333333333"));
}

TEST_F(ExactInputs, TimesAreFractions) {
    oscillators("w^2*x", "v*y");
    scene("w = 2\nv = 3.5");
    const auto at = [&](const std::string& times) {
        return Json::parse(printed("evaluate systems/s/scenes/a.toml --eps 0.1 --format json --t " + times));
    };
    const Json exact = at("1/3,20/10,0/7"), decimal = at("0.33333333333333333333,2,0");
    EXPECT_EQ(exact["t"], Json({1.0 / 3, 2, 0}));
    EXPECT_EQ(exact["outputs"], decimal["outputs"]);
}

TEST_F(ExactInputs, FixedValuesAreRootsAndFunctionsOfNumbers) {
    oscillators("w*x", "v*y");
    scene("w = 2\nv = 3");
    const std::vector<double> two = values();
    oscillators("w^2*x", "v*y");
    scene("w = \"sqrt(2)\"\nv = 3");
    expect_same(values(), two);
    scene("w = \"2*sqrt(1 + 1/2 - 1)\"\nv = \"atan(1/3)\"");
    expect_same(values(), two);
    scene("w = \"log(exp(sqrt(2)))\"\nv = \"pi\"");
    expect_same(values(), two);
    scene("w = \"tanh(atan(3))\"\nv = 3");
    const std::vector<double> irrational = values();
    scene("w = 0.8480158436643183\nv = 3"); // tanh(atan(3))
    expect_same(values(), irrational);
}

// The header holds the root, which every real type takes with its own digits.
TEST_F(ExactInputs, GeneratedCodeHoldsTheRoot) {
    oscillators("w^2*x", "v*y");
    scene("w = \"1 + sqrt(2)\"\nv = 3");
    const std::string header = printed("generate systems/s/scenes/a.toml");
    EXPECT_NE(header.find("with w = (2)^(1/2) + 1, v = 3"), std::string::npos) << header;
    EXPECT_NE(header.find("sqrt(Number(2))"), std::string::npos) << header;
    EXPECT_EQ(header.find("1.41"), std::string::npos) << header;
}

TEST_F(SlowExactInputs, WhatIsFixedIsVerified) {
    oscillators("w^2*x", "v*y");
    scene("w = \"sqrt(2)\"\nv = \"pi\"");
    const std::filesystem::path file = scratch_.path() / "systems/s/scenes/a.toml";
    write(file, read(file) + "[verify]\neps = [0.1, 0.05, 0.02, 0.01]\n");
    const Json json = Json::parse(printed("verify systems/s/scenes/a.toml --format json"));
    EXPECT_EQ(json["outputs"][0]["verdict"], "pass");
}

// 1:2 resonance of two irrational frequencies: seen, though no two decimals show it, and kept; or refused.
TEST_F(ExactInputs, AResonanceOfExactValuesIsSeen) {
    const std::string parameters = "w = { positive = true }\nv = { positive = true }",
                      equations = "x = \"x'' + w^2*x + x*y = 0\"\ny = \"y'' + v^2*y + x^2 = 0\"";
    system(parameters, equations + "\n[relations]\nv = \"2*w\"");
    scene("w = \"1 + sqrt(2)\"");
    const std::vector<double> declared = values();
    system(parameters, equations);
    for (const char* v : {"2 + 2*sqrt(2)", "2/(sqrt(2) - 1)"}) {
        scene(std::string("w = \"1 + sqrt(2)\"\nv = \"") + v + "\"");
        const std::vector<double> fixed = values();
        for (std::size_t i = 0; i < declared.size(); ++i) EXPECT_NEAR(fixed[i], declared[i], 1e-14) << v;
    }
    scene("w = \"1 + sqrt(2)\"\nv = \"sqrt(12 + 8*sqrt(2))\"");
    const Outcome outcome = said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1");
    EXPECT_EQ(outcome.code, 3) << outcome.out;
    EXPECT_NE(outcome.err.find("D(z2*z3) of z1"), std::string::npos) << outcome.err;
    scene("w = \"1 + sqrt(2)\"\nv = \"sqrt(12 + 7*sqrt(2))\"");
    EXPECT_EQ(said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1").code, 0);
}

TEST_F(ExactInputs, FixedValuesObeyTheirDeclaration) {
    oscillators("w^2*x", "v*y");
    const auto complaint = [&](const std::string& value) {
        scene("w = \"" + value + "\"\nv = 3");
        const Outcome outcome = said("evaluate systems/s/scenes/a.toml --eps 0.1 --t 1");
        EXPECT_EQ(outcome.out, "") << value;
        return std::to_string(outcome.code) + outcome.err;
    };
    for (const char* negative : {"1 - sqrt(2)", "log(1/2)", "3 - pi"})
        EXPECT_EQ(
            complaint(negative).rfind(
                "2resonform: systems/s/scenes/a.toml:4:6: fix.w: the parameter 'w' is declared positive", 0),
            0U)
            << complaint(negative);
    EXPECT_NE(complaint("sqrt(2)^2 - 2").find("declared positive"), std::string::npos);
    EXPECT_EQ(complaint("sqrt(1 - sqrt(2))")[0], '3');
    EXPECT_NE(complaint("sqrt(2)*10^100").find("nor between 1e-100 and 1e100"), std::string::npos);
    EXPECT_NE(complaint("w").find("unknown symbol"), std::string::npos);
}

TEST_F(ExactInputs, StartValuesTakeFunctionsOfNumbers) {
    oscillators("w^2*x", "v*y");
    const std::string fix = "w = 2\nv = 3";
    scene(fix, "x = \"eps*pi/6\"\n\"x'\" = 0\ny = 0\n\"y'\" = 0");
    const std::vector<double> sixth = values();
    for (const char* same : {"asin(1/2)", "acos(sqrt(3)/2)", "atan(1/sqrt(3))"}) {
        scene(fix, std::string("x = \"eps*") + same + "\"\n\"x'\" = 0\ny = 0\n\"y'\" = 0");
        expect_same(values(), sixth);
    }
    scene(fix, "x = \"eps*sinh(asin(1/2))\"\n\"x'\" = 0\ny = 0\n\"y'\" = 0");
    const std::vector<double> sinh = values();
    scene(fix, "x = \"0.5478534738880397*eps\"\n\"x'\" = 0\ny = 0\n\"y'\" = 0"); // sinh(pi/6)
    expect_same(values(), sinh);
    scene(fix, "x = \"asin(eps)\"\n\"x'\" = 0\ny = 0\n\"y'\" = 0");
    const std::vector<double> of_eps = values();
    scene(fix, "x = 0.1001674211615598\n\"x'\" = 0\ny = 0\n\"y'\" = 0"); // asin(1/10)
    expect_same(values(), of_eps);
}

TEST_F(ExactInputs, TimeIsAnAngle) {
    for (const char* force : {"eps*cos(t)", "eps*t*x", "cos(2*t)*x^2"}) {
        write(scratch_.path() / "systems/s/system.toml",
              std::string("[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\n[equations]\nx = "
                          "\"x'' + 2*x = ") +
                  force + "\"\n");
        const Outcome outcome = said("derive s");
        EXPECT_EQ(outcome.code, 2);
        EXPECT_NE(
            outcome.err.find("  found: t\n  hint:  declare an angle phi with phi' = 1 and write phi for t"),
            std::string::npos)
            << outcome.err;
    }
}

// systems/ is laid out by names; elsewhere another name is only said.
TEST_F(ExactInputs, ANameThatIsNotThatOfItsFolderIsSaid) {
    const std::string text =
        "[system]\nname = \"duffing\"\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
        "x = \"x'' + x + x^3 = 0\"\n";
    write(scratch_.path() / "systems/duffing/system.toml", text);
    write(scratch_.path() / "systems/other/system.toml", text);
    write(scratch_.path() / "elsewhere/system.toml", text);
    write(scratch_.path() / "elsewhere/duffing_oscillator.toml", text);
    EXPECT_EQ(said("derive duffing").err, "");
    for (const char* same :
         {"other", "systems/other", "systems/other/system.toml", "./systems/../systems/other"}) {
        const Outcome outcome = said(std::string("derive ") + same);
        EXPECT_EQ(outcome.code, 2) << same;
        EXPECT_NE(outcome.err.find("a system in systems/ must have the name of its folder, 'other'"),
                  std::string::npos)
            << outcome.err;
    }
    const Outcome elsewhere = said("derive elsewhere");
    EXPECT_EQ(elsewhere.code, 0);
    EXPECT_EQ(elsewhere.err,
              "resonform: elsewhere/system.toml calls the system 'duffing', though its folder is "
              "'elsewhere'\n");
    EXPECT_EQ(said("derive elsewhere/duffing_oscillator.toml").err, "");
    EXPECT_EQ(run("resonform certify . --order 2", scratch_.path() / "systems/duffing").err, "");
}

} // namespace resonform::test
