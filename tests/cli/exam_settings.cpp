// SPDX-License-Identifier: GPL-3.0-or-later
// --set, two oscillators whose frequencies are symbols or numbers, and a slow law with a parameter that the
// ring holds as a power of a root.
#include "support/command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

class Settings : public Command {
protected:
    Settings() {
        write(scratch_.path() / "systems/two/system.toml",
              "[system]\nname = \"two\"\n[parameters]\np = { positive = true }\nq = { positive = true }\na = "
              "{}\n"
              "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
              "[equations]\nx = \"x'' + p^2*x + 2*a*x*y = 0\"\ny = \"y'' + q^2*y + a*x^2 = 0\"\n");
    }
};

} // namespace

TEST_F(Settings, AreShownInTextAndJson) {
    const std::string text = printed("derive two --set p=1 q=2 a=1/3");
    EXPECT_EQ(text.rfind("normal form of two with p = 1, q = 2, a = 1/3 through weight 3", 0), 0U) << text;
    EXPECT_NE(text.find("z1' = I*z1 + I/6*z2*z3"), std::string::npos) << text; // 1:2, resonant
    const Json json = Json::parse(printed("derive two --format json --set p=1 --set q=2"));
    EXPECT_EQ(json["set"], (Json{{"p", "1"}, {"q", "2"}}));
    EXPECT_EQ(json["certificate"]["holds"], true);
    EXPECT_FALSE(Json::parse(printed("derive two --order 2 --format json")).contains("set"));
    EXPECT_EQ(Json::parse(printed("certify two --order 3 --set p=1 q=3 --format json"))["set"]["q"], "3");
}

TEST_F(Settings, StandInTheEquations) {
    EXPECT_EQ(printed("derive two --stage equations --set p=1/2 'a=1+log(2)'"),
              "equations of two with p = 1/2, a = 1+log(2)\n\n"
              "x'' + (1/2)^2*x + 2*(1 + log(2))*x*y = 0\n"
              "y'' + q^2*y + (1 + log(2))*x^2 = 0\n");
}

TEST_F(Settings, StandInTheLinesBetweenAMechanismAndItsEquations) {
    const std::string edge = std::string(RESONFORM_SOURCE_DIR) + "/systems/steered_knife_edge";
    const std::string text = printed("derive " + edge + " --stage accelerations --set m=2 J=1/2");
    EXPECT_NE(text.find("\n  theta'' = -2*k*theta\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nrelations:\n  k = c/4\n"), std::string::npos) << text;
    const Json json =
        Json::parse(printed("derive " + edge + " --stage accelerations --set J=1/2 --format json"));
    EXPECT_EQ(json["sections"].back()["equations"].back(), "theta'' = -k*theta/(1/2)");
}

TEST_F(Settings, ThatAreWrongAreBadInput) {
    for (const char* wrong :
         {"--set g=1", "--set p", "--set p=-1", "--set p=0", "--set p=q", "--set p=1 p=2"}) {
        const Outcome outcome = said(std::string("derive two ") + wrong);
        EXPECT_EQ(outcome.code, 2) << wrong;
        EXPECT_EQ(outcome.out, "") << wrong;
        EXPECT_EQ(outcome.err.rfind("resonform: --set", 0), 0U) << outcome.err;
    }
}

TEST_F(Settings, StyleOfTheCommandLineStandsInPlaceOfThatOfTheFile) {
    EXPECT_EQ(printed("derive two --style poincare"), printed("derive two"));
    const Outcome wrong = said("derive two --style poincar");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.err.find("did you mean poincare?"), std::string::npos) << wrong.err;
    const Outcome graph = said("derive two --style inner_product --format json --coefficients graph");
    EXPECT_EQ(graph.code, 3);
    EXPECT_NE(graph.err.find("leave out --coefficients"), std::string::npos) << graph.err;
    for (const char* command :
         {"derive two --style hamiltonian", "certify two --order 3 --style hamiltonian"}) {
        const Outcome refused = said(command);
        EXPECT_EQ(refused.code, 2) << command;
        EXPECT_NE(refused.err.find("take style = \"poincare\""), std::string::npos) << refused.err;
    }
}

TEST_F(Settings, OptionsWithoutAnEffectAreBadInput) {
    for (const char* stage :
         {"equations", "expand", "manifold", "solution", "transgression", "normal_form"}) {
        const Outcome graph = said(std::string("derive two --coefficients graph --stage ") + stage);
        EXPECT_EQ(graph.code, 2) << stage;
        EXPECT_NE(graph.err.find("--coefficients: coefficients in a graph go with"), std::string::npos)
            << graph.err;
    }
    for (const char* stage : {"equations", "expand"})
        for (const char* option : {"--style hamiltonian", "--coefficients ring"}) {
            const Outcome outcome = said(fmt::format("derive two --stage {} {}", stage, option));
            EXPECT_EQ(outcome.code, 2) << outcome.out;
            EXPECT_NE(outcome.err.find(fmt::format("goes with a normal form, and --stage {}", stage)),
                      std::string::npos)
                << outcome.err;
        }
    EXPECT_EQ(said("derive two --stage divisors --coefficients graph").code, 0);
}

TEST_F(Settings, OfAParameterThatARelationGives) {
    write(scratch_.path() / "systems/given/system.toml",
          "[system]\nname = \"given\"\n[parameters]\na = {}\nb = { positive = true }\n[relations]\n"
          "a = \"2*b\"\n[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + b^2*x = a*x^2\"\n");
    EXPECT_EQ(
        said("derive given --set a=2").err,
        "resonform: --set: a parameter computed by [relations] is given a value of its own\n"
        "  found: a = 2*b\n"
        "  hint:  set the parameters on the right side, or take the relation from line 7 of the file\n");
}

TEST_F(Settings, ThatDivideByZeroInAModeNameItsEntry) {
    write(scratch_.path() / "systems/pole/system.toml",
          "[system]\nname = \"pole\"\n[parameters]\nw = { positive = true }\n[variables]\n"
          "x = { role = \"fast\" }\n[equations]\nx = \"x'' + w^2*x = x^2\"\n[modes]\n"
          "z1 = { eigenvalue = \"I*w\", u = { x = \"1/2\", \"x'\" = \"I*w/(w - 3)\" } }\n");
    const Outcome mode = said("derive pole --set w=3");
    EXPECT_EQ(mode.code, 2);
    EXPECT_NE(mode.err.find("modes.z1.u.x': the values of --set make no denominator zero"), std::string::npos)
        << mode.err;
}

TEST_F(Settings, TakeAllWordsBehindThem) {
    const Outcome outcome = said("derive --set p=1 q=2 two --order 2");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("--set: takes all words that follow it, and derive needs SYSTEM"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(
        outcome.err.find("  found: --set p=1 q=2 two\n  hint:  write resonform derive SYSTEM --set ...\n"),
        std::string::npos)
        << outcome.err;
    EXPECT_NE(printed("derive --help").find("Usage: resonform derive SYSTEM [OPTIONS]\n"), std::string::npos);
}

TEST_F(Settings, SmallDivisorsOfSymbolsAreNamed) {
    const std::string text = printed("derive two");
    EXPECT_NE(text.find("small divisors, taken to vanish nowhere: "), std::string::npos) << text;
    EXPECT_NE(text.find("2*p - q"), std::string::npos) << text;
    EXPECT_EQ(printed("derive two --set p=1 q=3").find("small divisors"), std::string::npos);
    EXPECT_EQ(printed("derive two"), text);
}

// In a scene: neither "divisor 9 = 0" nor a refusal.
TEST_F(Settings, ThatMakeADivisorZeroKeepItsMonomial) {
    write(scratch_.path() / "systems/two/scenes/s.toml",
          "order = 2\n[fix]\np = 1\nq = 2\na = 1\n[start]\namplitude.x = 1\nphase.x = 0\namplitude.y = "
          "1\nphase.y = 0\n");
    const std::string header = printed("generate systems/two/scenes/s.toml");
    EXPECT_NE(header.find("// with p = 1, q = 2, a = 1\n"), std::string::npos) << header;
    EXPECT_NE(printed("derive two --set p=1 q=2 a=1 --order 2").find("*z2*z3"), std::string::npos);
}

// Before anything is derived, with the place.
TEST_F(Settings, AManifoldIsForModesThatDecayOrGrow) {
    const Outcome refused = said("derive two --stage manifold --order 2");
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("system.toml:11:"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("equations.x: a centre manifold is for systems"), std::string::npos)
        << refused.err;
}

// u'' + k (1 + s) u = 0, s' = eps k: the frequency makes k the square of a root.
TEST_F(Settings, ParameterOfASlowLawUnderARoot) {
    write(scratch_.path() / "systems/law/system.toml",
          "[system]\nname = \"law\"\n[parameters]\nk = { positive = true }\n[variables]\nu = { role = "
          "\"fast\" }\n"
          "s = { role = \"slow\" }\n[domain]\npositive = [\"1 + s\"]\n[equations]\nu = \"u'' + k*u*(1 + s) = "
          "0\"\n"
          "s = \"s' = eps*k\"\n");
    write(scratch_.path() / "systems/law/scenes/s.toml",
          "order = 1\n[fix]\nk = 2\n[start]\ns = 0\namplitude.u = 1\nphase.u = 0\n");
    const Json values =
        Json::parse(printed("evaluate systems/law/scenes/s.toml --eps 0.01 --t 0,50 --format json"));
    ASSERT_EQ(values["status"], (Json{"ok", "ok"}));
    // u = eps C (1 + s)^(-1/4) cos theta, s = eps k t, theta = integral of sqrt(k (1 + s))
    const double theta = std::sqrt(2.0) * 2 / 3 / 0.02 * (std::pow(2.0, 1.5) - 1);
    EXPECT_NEAR(values["outputs"]["u"][0].get<double>(), 0.01, 1e-4);
    EXPECT_NEAR(values["outputs"]["u"][1].get<double>(), 0.01 * std::pow(2.0, -0.25) * std::cos(theta), 1e-4);
    const Outcome generated = said("generate systems/law/scenes/s.toml -o law.hpp");
    EXPECT_EQ(generated.code, 0) << generated.err;
}

} // namespace resonform::test
