// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict of `resonform stability`, and what makes it another one.
#include "support/command.hpp"
#include "support/compiler.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace resonform::test {

namespace {

class StabilityCommand : public Command {
protected:
    StabilityCommand() {
        write(scratch_.path() / "systems/edge/system.toml",
              "[system]\nname = \"edge\"\n[parameters]\na = { positive = true }\n[variables]\n"
              "x = { role = \"fast\" }\ntau = { role = \"slow\" }\n[domain]\npositive = [\"a - tau\"]\n"
              "[equations]\nx = \"x'' + (a - tau)*x = 0\"\ntau = \"tau' = eps\"\n");
        write(scratch_.path() / "systems/edge/scenes/s.toml",
              "order = 1\n[fix]\na = 2\n[start]\ntau = 0\namplitude.x = 1\nphase.x = 0\n");
    }
    // An oscillator of this stiffness, a > 0, that starts with a velocity.
    void plant(const std::string& stiffness, const std::string& domain = "") const {
        write(scratch_.path() / "systems/edge/system.toml",
              "[system]\nname = \"edge\"\n[parameters]\na = { positive = true }\n[variables]\n"
              "x = { role = \"fast\" }\n" +
                  domain + "[equations]\nx = \"x'' + (" + stiffness + ")*x = 0\"\n");
        write(scratch_.path() / "systems/edge/scenes/s.toml",
              "order = 1\n[fix]\na = 1\n[start]\nx = \"eps\"\n\"x'\" = \"eps\"\n");
    }
    [[nodiscard]] Outcome swept(const std::string& options = "") const {
        return said("stability systems/edge/scenes/s.toml --points 150 " + options);
    }
    [[nodiscard]] nlohmann::json json(int code, const std::string& options = "") const {
        const Outcome outcome = swept("--format json " + options);
        EXPECT_EQ(outcome.code, code) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    }
};
using SlowStabilityCommand = StabilityCommand;

// Of the worst points, those that the inputs do not account for.
double largest_avoidable(const nlohmann::json& found) {
    double largest = 0;
    for (const auto& point : found["worst"])
        if (point["unavoidable_ulp"] == 0) largest = std::max(largest, point["ulp"].get<double>());
    return largest;
}

} // namespace

TEST_F(StabilityCommand, PassesAndSaysWhatItSwept) {
    const Outcome outcome = swept();
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    for (const char* part :
         {"edge / s: pass, double against 50 digits, threshold 16 ulp of the output's scale\n",
          "  150 points (seed 2), ", "; 0 without an explanation (at most 1 %)",
          "  a            1e-12 ... 1e+12 (24 of 24 decades)\n", " of 15 decades)\n"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
    EXPECT_EQ(json(0, "--seed 3")["seed"], 3);
    EXPECT_EQ(json(0, "--seed 3")["worst"], json(0, "--seed 3")["worst"]);
    EXPECT_NE(json(0, "--seed 3")["worst"], json(0)["worst"]);
}

TEST_F(StabilityCommand, WhatWasHardlySweptIsNotPassed) {
    const Outcome one = said("stability systems/edge/scenes/s.toml --points 1");
    EXPECT_EQ(one.code, 1);
    for (const char* part :
         {"edge / s: undecided, ", "  1 points (seed 2), 1 compared, 0 refused; ",
          "  undecided: every input is driven over half of the decades open to it or more: eps over 0.0 of "
          "11.7 (more "
          "--points)\n",
          "  a            2 ... 2 (0 of 24 decades)\n", "  tau_0        0 (0 of 15 decades)\n"})
        EXPECT_NE(one.out.find(part), std::string::npos) << part << "\n" << one.out;
    const nlohmann::json whole = json(0);
    EXPECT_EQ(whole["rule"], nullptr);
    EXPECT_EQ(whole["swept"]["a"], nlohmann::json({1e-12, 1e12}));
    EXPECT_EQ(whole["compared"].get<int>() + whole["refused"].get<int>() +
                  whole["beyond_reference"].get<int>() + whole["not_judged"].get<int>(),
              whole["cases"].get<int>());
}

// w > 100 is a sixth of what start values are driven over, and none of it may be asked for.
TEST_F(StabilityCommand, WhatTheDomainClosesIsNotMissed) {
    write(scratch_.path() / "systems/edge/system.toml",
          "[system]\nname = \"edge\"\n[variables]\nx = { role = \"fast\" }\n"
          "w = { role = \"slow\", positive = true }\n[domain]\npositive = [\"w - 100\"]\n"
          "[equations]\nx = \"x'' + w^2*x = 0\"\nw = \"w' = eps\"\n");
    write(scratch_.path() / "systems/edge/scenes/s.toml",
          "order = 1\n[start]\nw = 200\namplitude.x = 1\nphase.x = 0\n");
    const nlohmann::json found = json(0);
    EXPECT_EQ(found["verdict"], "pass") << found["rule"];
    EXPECT_GT(found["swept"]["w_0"][0], 100);
    EXPECT_LT(found["ranges"]["w_0"][0], 0.01);
}

// No input of the sweep lies outside of what the file declares.
TEST_F(StabilityCommand, NothingExplainsABadArgument) {
    const OtherCompiler liar(editing_compiler(
        scratch_.path() / "liar.sh",
        "if (const Cause bad = Interval::check(eps, end); bad.status != Status::ok) return bad;",
        "return {Status::bad_argument, \"eps\"};"));
    const nlohmann::json found = json(1);
    EXPECT_EQ(found["verdict"], "fail");
    EXPECT_EQ(found["refused_by"]["bad_argument"], found["refused"]);
    EXPECT_EQ(found["unexplained"], found["refused"]);
    EXPECT_EQ(found["rule"].get<std::string>().find("at most 1 % of the points have a status without an "),
              0U)
        << found["rule"];
}

// Of the amplitude, by 10^-12 of itself.
TEST_F(SlowStabilityCommand, AWrongNumberIsAFailure) {
    const OtherCompiler liar(
        editing_compiler(scratch_.path() / "liar.sh", "values.x = ", "values.x = Real(1.000000000002) * "));
    const nlohmann::json found = json(1);
    EXPECT_EQ(found["verdict"], "fail");
    EXPECT_EQ(found["unexplained"], 0);
    EXPECT_GT(found["worst"][0]["ulp"], 100);
    EXPECT_EQ(found["rule"].get<std::string>().find("no error is above 16 ulp times 1 + "), 0U)
        << found["rule"];
}

// e^(-600): a last bit of the slow time makes an exponent of 600 differ by 600 ulp of the result.
TEST_F(StabilityCommand, WhatTheSlowTimeLeavesOpenIsNoFault) {
    write(scratch_.path() / "systems/edge/system.toml",
          "[system]\nname = \"edge\"\n[variables]\nx = { role = \"fast\" }\n"
          "[equations]\nx = \"x'' + 2*eps*x' + x = 0\"\n");
    write(scratch_.path() / "systems/edge/scenes/s.toml",
          "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = \"600/eps\"\n");
    const nlohmann::json found = json(0);
    EXPECT_EQ(found["verdict"], "pass");
    double largest = 0, unavoidable = 0, by_slow_time = 0;
    for (const auto& point : found["worst"]) {
        if (std::abs(point["at"]["phase_x"].get<double>()) > 1e3) continue; // a last bit of it does more
        largest = std::max(largest, point["ulp"].get<double>());
        unavoidable = std::max(unavoidable, point["unavoidable_ulp"].get<double>());
        by_slow_time = std::max(by_slow_time, point["slow_time_ulp"].get<double>());
    }
    EXPECT_GT(by_slow_time, 100);
    EXPECT_LE(by_slow_time, unavoidable);
    EXPECT_GT(largest, 16);
    EXPECT_GT(unavoidable, 100);
    EXPECT_LT(unavoidable, 3000);
    EXPECT_NE(swept().out.find(" (a last bit of the slow time: "), std::string::npos);
}

// a - tau > 1 is no domain that the file declares.
TEST_F(SlowStabilityCommand, AStatusThatNothingExplainsIsAFailure) {
    const OtherCompiler liar(
        editing_compiler(scratch_.path() / "liar.sh", "(!(s > Real(0)))", "(!(s > Real(1e300)))"));
    const nlohmann::json found = json(1);
    EXPECT_EQ(found["verdict"], "fail");
    EXPECT_EQ(found["compared"], 0);
    EXPECT_GT(found["unexplained"], 30);
}

// The map leads back from hardly any start: all is explained, and nothing compared.
TEST_F(StabilityCommand, WithoutNumbersThereIsNoVerdict) {
    write(scratch_.path() / "systems/edge/system.toml",
          "[system]\nname = \"edge\"\n[variables]\nx = { role = \"fast\" }\n"
          "[equations]\nx = \"x'' + x + 10^40*x^2 = 0\"\n");
    write(scratch_.path() / "systems/edge/scenes/s.toml", "order = 1\n[start]\nx = \"eps\"\n\"x'\" = 0\n");
    const nlohmann::json found = json(1, "--seed 3");
    EXPECT_EQ(found["verdict"], "undecided") << found;
    EXPECT_EQ(found["unexplained"], 0);
    EXPECT_EQ(found["refused_by"].size(), 1U);
}

// a - sin(a) at a = 1e-6 has 4 of its 16 digits.
TEST_F(SlowStabilityCommand, ThePartThatLosesDigitsIsNamed) {
    plant("a - sin(a)", "[domain]\npositive = [\"a\", \"a - sin(a)\"]\n");
    const nlohmann::json found = json(1);
    EXPECT_EQ(found["verdict"], "fail");
    const nlohmann::json& worst = found["worst"][0];
    ASSERT_TRUE(worst.contains("lost")) << worst;
    EXPECT_GT(worst["ulp"], 1e4);
    EXPECT_EQ(worst["lost"]["expression"], "a - sin(a)");
    EXPECT_EQ(worst["lost"]["operands"][1]["expression"], "-sin(a)");
    EXPECT_GT(worst["lost"]["cancellation"], 1e4);
    EXPECT_NEAR(worst["lost"]["share"].get<double>(), 1, 0.1);
    for (const auto& point : found["worst"]) EXPECT_LE(point["ulp"], found["histogram_ulp"]["x"].back()[0]);
    const std::string text = swept().out;
    EXPECT_NE(text.find("           lost in a - sin(a) = "), std::string::npos) << text;
    EXPECT_NE(text.find(", of a = "), std::string::npos) << text;
}

// Off by 7e8, 1e5 and 2e11 ulp when they were emitted as they are written.
TEST_F(SlowStabilityCommand, WhatIsRewrittenLosesNone) {
    plant("1 - cos(a)", "[domain]\npositive = [\"1 - cos(a)\"]\n");
    EXPECT_LT(largest_avoidable(json(0)), 4) << "cos(10^12) may be no better than its argument";
    plant("sqrt(1 + a^2) - a");
    EXPECT_LT(largest_avoidable(json(0)), 4);
    plant("exp(a) - 1", "[domain]\npositive = [\"20 - a\", \"exp(a) - 1\"]\n");
    EXPECT_LT(largest_avoidable(json(0)), 4);
}

TEST_F(StabilityCommand, PointsAndSeedAreWholeNumbers) {
    for (const auto& [options, found] : {std::pair("--points 0", "0"), std::pair("--points 1e3", "1e3"),
                                         std::pair("--points 1000001", "1000001"),
                                         std::pair("--seed -1", "-1"), std::pair("--seed x", "x")}) {
        const Outcome outcome = said(std::string("stability systems/edge/scenes/s.toml ") + options);
        EXPECT_EQ(outcome.code, 2) << options;
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find("must be an integer from "), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find(std::string("\n  found: ") + found + "\n"), std::string::npos)
            << outcome.err;
    }
}

} // namespace resonform::test
