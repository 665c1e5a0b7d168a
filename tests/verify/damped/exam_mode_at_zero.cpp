// SPDX-License-Identifier: GPL-3.0-or-later
// "amplitude.z2" = 0 beside physical values: the mode is 0, and the value that is left out follows.
#include "algebra/number/error.hpp"
#include "support/error_when.hpp"
#include "verify/own_system.hpp"
#include "verify/report/json.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace resonform {
namespace {

class ModeAtZero : public test::InterpretedSystem {
protected:
    std::string refusal(const std::string& system, const std::string& scene) {
        const Error error = test::error_when([&] { (void)test::program_of(written(system, scene)); });
        const Diagnostic& d = error.diagnostic();
        return d.place.key + ": " + d.rule + " | " + d.value;
    }
};

// y = (y0 + x0^2/3) e^t - x0^2 e^{-2t}/3, x = x0 e^{-t}
const std::string fed = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                        "x = \"x' = -x\"\ny = \"y' = y + x^2\"\n";

TEST_F(ModeAtZero, LeavesTheManifoldWithoutIt) {
    const double eps = 1e-3;
    for (const double t : {0.0, 1.0, 30.0}) {
        const double exact = -eps * eps * std::exp(-2 * t) / 3;
        const Answer answer = at(
            fed, "order = 2\noutputs = [\"x\", \"y\"]\n[start]\nx = \"eps\"\n\"amplitude.z2\" = 0\n", eps, t);
        EXPECT_EQ(answer.status, Status::ok);
        EXPECT_NEAR(answer.values[0], eps * std::exp(-t), 1e-18);
        EXPECT_NEAR(answer.values[1], exact, 1e-14 * std::abs(exact));
    }
}

TEST_F(ModeAtZero, TellsWhatIsWrong) {
    const std::string head = "order = 2\noutputs = [\"x\", \"y\"]\n[start]\n";
    EXPECT_EQ(refusal(fed, head + "y = \"eps\"\namplitude.z2 = 0\n"),
              "start.amplitude.z2: the value that is left out follows from the mode that is 0 | z2 does not "
              "depend on x");
    EXPECT_EQ(refusal(fed, head + "y = \"eps\"\namplitude.z7 = 0\n"),
              "start.amplitude.z7: a mode that is 0 at the start is one of those that derive prints | 'z7'");
    EXPECT_EQ(
        refusal(fed, head + "x = \"eps\"\namplitude.z2 = 1\n"),
        "start.amplitude.z2: the amplitude of a mode that decays or grows is 0, or follows from physical "
        "values | 1");
    const std::string one =
        "start.amplitude.z2: a mode that is 0 takes the place of one physical value of the "
        "fast variables | ";
    EXPECT_EQ(refusal(fed, head + "x = \"eps\"\ny = 0\namplitude.z2 = 0\n"), one + "every value is given");
    EXPECT_EQ(refusal(fed, head + "amplitude.z2 = 0\n"), one + "no value of x, y");
    EXPECT_EQ(refusal(fed, head + "x = \"eps\"\namplitude.z1 = 0\namplitude.z2 = 0\n"),
              "start.amplitude.z2: one mode is 0 at the start | 'amplitude.z2' beside the amplitude of z1");
    const std::string swinging =
        "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
        "x = \"x'' + x + x*y = 0\"\ny = \"y'' - y' + 3*y = x^2\"\n";
    const std::string without = "[start]\nx = \"eps\"\n\"x'\" = 0\ny = 0\n";
    for (const char* mode : {"z1", "z2"})
        EXPECT_EQ(
            refusal(swinging, fmt::format("{}amplitude.{} = 0\n", without, mode)),
            fmt::format("start.amplitude.{0}: a mode that is 0 at the start decays or grows at eps = 0 | "
                        "{0} oscillates",
                        mode));
    EXPECT_EQ(
        refusal(swinging, without + "amplitude.z3 = 0\n"),
        "start.amplitude.z3: a mode that is 0 at the start is real, for it takes the place of one value | "
        "z3 is a spiral");
    EXPECT_EQ(refusal(swinging, "[start]\namplitude.x = 1\nphase.x = 0\ny = 0\namplitude.z3 = 0\n"),
              "start.amplitude.x: beside a mode that is 0 fast variables start from physical values | "
              "'amplitude.x'");
}

// At rates 1 and 2 u^2 stays in the rate of v.
TEST_F(ModeAtZero, IsRefusedWhereAResonanceDrivesIt) {
    EXPECT_EQ(
        refusal("[variables]\nu = { role = \"fast\" }\nv = { role = \"fast\" }\n[equations]\n"
                "u = \"u' = u\"\nv = \"v' = 2*v + u^2\"\n",
                "order = 2\n[start]\nu = \"eps\"\namplitude.z2 = 0\n"),
        "start.amplitude.z2: a mode that is 0 at the start stays 0 | z2 is driven by a resonance of other "
        "modes");
}

// A saddle that oscillators and a slow variable drive, in variables that mix its modes; each of its two
// modes, each of the values that hold it.
class SlowModeAtZero : public ModeAtZero {};
TEST_F(SlowModeAtZero, PassesItsLadderBesideOscillators) {
    const std::string system =
        "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
        "s = { role = \"slow\", positive = true }\n[equations]\n"
        "x = \"x'' + s*x + x*y = 0\"\ny = \"y'' - s*y = x^2 + y^2\"\ns = \"s' = eps*(1 + x^2)\"\n";
    for (const std::string mode : {"z3", "z4"})
        for (const std::string given : {"y = \"eps/3\"", "\"y'\" = \"eps/3\""}) {
            const Scene scene = written(
                system,
                fmt::format("order = 2\noutputs = [\"x\", \"y\", \"s\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\n"
                            "s = 1\n{}\namplitude.{} = 0\n[verify]\n"
                            "eps = [0.02, 0.01, 0.005, 0.0025, 0.00125]\n",
                            given, mode));
            const Verification v = test::verified(test::line_of(scene));
            for (const OutputVerdict& o : v.outputs)
                EXPECT_EQ(o.verdict, Verdict::pass) << mode << given << o.name << o.reason;
            EXPECT_EQ(v.emitted.verdict, Verdict::pass) << mode << given << to_text(v.emitted);
            const std::string missing = given.front() == 'y' ? "y'" : "y";
            ASSERT_EQ(v.conditions.moved.size(), 1U);
            EXPECT_EQ(v.conditions.moved.front().state, missing);
            EXPECT_FALSE(v.conditions.moved.front().given);
            EXPECT_NE(to_text(v).find("found at the smallest eps: " + missing + "(0) = "), std::string::npos)
                << to_text(v);
            EXPECT_TRUE(to_json(v)["projected"][missing]["given"].is_null());
            for (const OutputVerdict& d : v.defects) EXPECT_GE(d.slope, 2.9) << mode << given << d.name;
        }
}

} // namespace
} // namespace resonform
