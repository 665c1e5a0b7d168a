// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes about an equilibrium that is not the origin, against the equations as the user wrote them.
#include "own_system.hpp"
#include "verify/judging/start_scaling.hpp"
#include "verify/stability/stability.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

class AboutEquilibrium : public test::OwnSystem {
protected:
    Scene scene(const std::string& system, const std::string& text) { return written(system, text); }
    void expect_pass(const std::string& system, const std::string& text) {
        const Verification v = test::verified(
            test::line_of(scene(system, text + "[verify]\neps = [0.04, 0.02, 0.01, 0.005]\n")));
        for (const auto& output : v.outputs) EXPECT_EQ(output.verdict, Verdict::pass) << output.reason;
        EXPECT_TRUE(v.as_expected());
    }
};

const std::string resting_well = "[variables]\nx = { role = \"fast\" }\n[equilibrium]\nx = 1\n[equations]\n"
                                 "x = \"x'' = x - x^3\"\n";

// The well moves with q, and the velocity is measured from that of the well.
const std::string moving_well =
    "[parameters]\nv = { positive = true }\n[variables]\n"
    "q = { role = \"slow\", positive = true }\nx = { role = \"fast\" }\n[equilibrium]\n"
    "x = \"q\"\n[equations]\nq = \"q' = eps*v\"\nx = \"x'' = q^2*x - x^3\"\n";

TEST_F(AboutEquilibrium, ClosedSolutions) {
    expect_pass(resting_well, "order = 2\n[start]\nx = \"1 + 0.3*eps\"\n\"x'\" = \"0.1*eps\"\n");
    expect_pass(resting_well, "order = 2\n[start]\namplitude.x = 0.5\nphase.x = 0.3\n");
    expect_pass(moving_well,
                "order = 1\n[fix]\nv = 0.5\n[start]\nq = 1\nx = \"1 + 0.3*eps\"\n\"x'\" = \"0.1*eps\"\n");
}

TEST_F(AboutEquilibrium, SlowFlows) {
    expect_pass("[parameters]\nk = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                "y = { role = \"fast\" }\n[equilibrium]\nx = 1\ny = \"solve\"\n[equations]\n"
                "x = \"x'' = x - x^3\"\ny = \"y'' = -3*(y - k) + (x - 1)^2\"\n",
                "order = 1\n[fix]\nk = 2\n[start]\nx = \"1 + 0.3*eps\"\n\"x'\" = \"0.1*eps\"\n"
                "y = \"2 + 0.2*eps\"\n\"y'\" = 0\n");
}

TEST_F(AboutEquilibrium, StartsThatDoNotScale) {
    const auto complaint = [&](const std::string& x) {
        return start_scaling_complaint(scene(resting_well, "[start]\nx = " + x + "\n\"x'\" = 0\n"));
    };
    EXPECT_EQ(complaint("\"1 + eps/2\""), "");
    EXPECT_EQ(complaint("1"), "");
    EXPECT_EQ(complaint("1.5"),
              "x starts at 1.5, which is not its equilibrium plus eps times a constant: along "
              "a ladder of eps the error has no order");
}

TEST_F(AboutEquilibrium, IsSweptFromStartsAroundIt) {
    const test::SceneLine line =
        test::line_of(scene(resting_well, "order = 1\n[start]\nx = \"1 + 0.3*eps\"\n\"x'\" = \"eps\"\n"));
    StabilityOptions options;
    static_cast<VerifyOptions&>(options) = test::options();
    const Stability swept = stability(line.scene, line.solution, options);
    EXPECT_EQ(swept.verdict, Verdict::pass) << swept.rule;
    EXPECT_GT(swept.compared, swept.cases / 2);
}

// Where it rests is rounded, at k = 10^7 to as much as 10^-9: starts are within 10^-12 of it.
TEST_F(AboutEquilibrium, IsSweptFromStartsAroundARoundedOne) {
    const std::string well = "[parameters]\nk = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                             "[equilibrium]\nx = \"k + 1/k\"\n[equations]\n"
                             "x = \"x'' + (x - k - 1/k) + (x - k - 1/k)^3 = 0\"\n";
    const test::SceneLine line = test::line_of(
        scene(well, "order = 1\n[fix]\nk = 3\n[start]\nx = \"k + 1/k + 0.3*eps\"\n\"x'\" = \"eps\"\n"));
    StabilityOptions options;
    static_cast<VerifyOptions&>(options) = test::options();
    const Stability swept = stability(line.scene, line.solution, options);
    EXPECT_EQ(swept.verdict, Verdict::pass) << swept.rule;
    EXPECT_GT(swept.compared, swept.cases / 4);
    for (const WorstPoint& w : swept.worst) EXPECT_LT(w.ulp, 16);
}

} // namespace
} // namespace resonform
