// SPDX-License-Identifier: GPL-3.0-or-later
// Modes that grow at eps = 0: followed as long as they leave digits, or projected away, and judged by
// their defect.
#include "solve/flow/slow_flow.hpp"
#include "support/error_when.hpp"
#include "verify/estimate/times.hpp"
#include "verify/own_system.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

class GrowingModes : public test::InterpretedSystem {};

// y = (y0 + x0^2/3) e^t - x0^2 e^{-2t}/3, x = x0 e^{-t}
const std::string drained = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                            "x = \"x' = -x\"\ny = \"y' = y + x^2\"\n";
const std::string from_beside = "order = 2\noutputs = [\"x\", \"y\"]\n[start]\nx = \"eps\"\ny = \"eps/8\"\n";

TEST_F(GrowingModes, AreFollowed) {
    const double eps = 1e-3, t = 1;
    const Answer answer = at(drained, from_beside, eps, t);
    EXPECT_EQ(answer.status, Status::ok);
    EXPECT_NEAR(answer.values[0], eps * std::exp(-t), 1e-18);
    EXPECT_NEAR(answer.values[1], (eps / 8 + eps * eps / 3) * std::exp(t) - eps * eps * std::exp(-2 * t) / 3,
                1e-17);
}

TEST_F(GrowingModes, AreProjectedOntoTheManifold) {
    for (const double t : {0.0, 1.0, 30.0}) {
        const double eps = 1e-3, exact = -eps * eps * std::exp(-2 * t) / 3;
        const Answer answer = at(drained, "growing = \"project\"\n" + from_beside, eps, t);
        EXPECT_EQ(answer.status, Status::ok);
        EXPECT_NEAR(answer.values[0], eps * std::exp(-t), 1e-18);
        EXPECT_NEAR(answer.values[1], exact, 1e-14 * std::abs(exact));
    }
}

// Linear in what grows: 10^3 eps^2 e^t <= 1.
TEST_F(GrowingModes, LoseTheirDigitsInTime) {
    const double eps = 1e-4, most = 1 / (1000 * eps * eps);
    const std::string scene = "order = 2\noutputs = [\"x\", \"y\"]\n[start]\nx = \"eps\"\ny = 0\n";
    EXPECT_EQ(at(drained, scene, eps, std::log(most) - 1e-9).status, Status::ok);
    const Answer beyond = at(drained, scene, eps, std::log(most) + 1e-9);
    EXPECT_EQ(beyond.status, Status::low_precision);
    EXPECT_EQ(beyond.why, "chi_2");
    EXPECT_NEAR(beyond.values[1], eps * eps / 3 * most, 1e-5 * most * eps * eps) << "a number all the same";
    EXPECT_EQ(at(drained, scene, eps, 800).status, Status::overflow);
}

// y = eps e^t/(1 + 100 eps (1 - e^t)) has a pole; of r = 100 eps, (r e^t)^3 <= 10^-3, as its
// quadratic and its cubic corrections have it, added.
TEST_F(GrowingModes, EndBeforeTheirSeriesDoes) {
    const std::string system =
        "[variables]\ny = { role = \"fast\" }\n[equations]\ny = \"y' = y + 100*y^2\"\n";
    const std::string scene = "order = 3\noutputs = [\"y\"]\n[start]\ny = \"eps\"\n";
    const double eps = 1e-5, last = std::log(1e-1 / (100 * eps));
    const Answer answer = at(system, scene, eps, last - 1.5);
    EXPECT_EQ(answer.status, Status::ok);
    const double growth = std::exp(last - 1.5), exact = eps * growth / (1 + 100 * eps * (1 - growth));
    EXPECT_NEAR(answer.values[0], exact, 1e-3 * exact);
    EXPECT_EQ(at(system, scene, eps, last).status, Status::low_precision);
}

// e^{2t} is no double before y + y^2 is none: no disagreement with the exact solution.
TEST_F(GrowingModes, OverflowInTheirPowers) {
    const Verification v = test::verified(test::line_of(written(
        "[variables]\ny = { role = \"fast\" }\n[equations]\ny = \"y' = 0.27*y - 0.2*y^2\"\n",
        "order = 2\noutputs = [\"y\"]\n[start]\ny = \"-0.37*eps\"\n[verify]\neps = [0.05, 0.02, 0.01]\n")));
    EXPECT_EQ(v.emitted.verdict, Verdict::pass) << to_text(v.emitted);
}

// Of weight 0: e^{3t} at order 1, though normal form and map are used through weight 2.
TEST_F(GrowingModes, OverflowInPowersThatWeighNothing) {
    const Verification v = test::verified(test::line_of(written(
        "[variables]\ny = { role = \"fast\", weight = 0 }\n[equations]\ny = \"y' = 0.27*y - 0.2*eps*y^3\"\n",
        "order = 1\ntime_scale = 1\noutputs = [\"y\"]\n[start]\ny = \"-0.001\"\n[verify]\neps = [0.05, 0.02, "
        "0.01]\n")));
    EXPECT_EQ(v.emitted.verdict, Verdict::pass) << to_text(v.emitted);
}

// At 2 tau between rates, |D|^2 <= D' = 2 eps, a start is not taken apart, whether they decay or grow.
TEST_F(GrowingModes, AResonanceOfRatesAtTheStartIsOutside) {
    for (const std::string sign : {"", "-"})
        for (const double tau : {-0.02, -0.2}) {
            const Answer answer = at(
                "[variables]\ntau = { role = \"slow\" }\nu = { role = \"fast\" }\nv = { role = \"fast\" }\n"
                "[domain]\npositive = [\"1 + tau\"]\n[equations]\ntau = \"tau' = eps\"\nu = \"u' = " +
                    sign + "(1 + tau)*u\"\nv = \"v' = " + sign + "2*v + u^2\"\n",
                "order = 3\noutputs = [\"v\"]\n[start]\ntau = " + std::to_string(tau) +
                    "\nu = \"eps\"\nv = \"eps/10\"\n",
                1e-3, 0);
            EXPECT_EQ(answer.status, tau < -0.1 ? Status::ok : Status::outside_domain) << sign << tau;
            if (tau < -0.1) {
                EXPECT_NEAR(answer.values[0], 1e-4, 5e-9);
            }
        }
}

// A slow variable that nothing drives keeps its start when the others are projected.
TEST_F(GrowingModes, BesideASlowVariableOfItsOwn) {
    expect_pass(
        written("[variables]\ntau = { role = \"slow\", positive = true }\ny = { role = \"fast\" }\n"
                "[equations]\ntau = \"tau' = eps\"\ny = \"y' = (1 + tau)*y - eps\"\n",
                "order = 2\noutputs = [\"y\"]\ngrowing = \"project\"\n[start]\ntau = 0.5\ny = \"eps\"\n"
                "[verify]\neps = [0.04, 0.02, 0.01, 0.005]\n"));
}

TEST_F(GrowingModes, AreNotProjectedWhereNoneGrows) {
    const Scene scene =
        written("[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x^3 = 0\"\n",
                "order = 2\ngrowing = \"project\"\n[start]\namplitude.x = 1\nphase.x = 0\n");
    EXPECT_THROW((void)test::solution_of(scene), Error);
}

// A spiral that grows and is driven by an oscillator, with the slow variable that they move.
const std::string growing_spiral =
    "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\ns = { role = \"slow\" }\n[equations]\n"
    "x = \"x'' + x + s*x*y = 0\"\ny = \"y'' - y' + 3*y = x^2\"\ns = \"s' = eps*(1 + y)\"\n";
const std::string started_off = "[start]\nx = \"eps\"\n\"x'\" = 0\ny = 0\n\"y'\" = \"eps\"\ns = 1\n"
                                "[verify]\neps = [0.04, 0.02, 0.01, 0.005]\n";

TEST_F(GrowingModes, ThatTurnPassWithTheirDefect) {
    for (const std::string head :
         {"growing = \"project\"\n", "transients = false\n", "growing = \"status\"\n"}) {
        const Scene scene =
            written(growing_spiral, "order = 2\noutputs = [\"x\", \"y\", \"s\"]\n" + head + started_off);
        const Verification v = test::verified(test::line_of(scene));
        for (const OutputVerdict& o : v.outputs) EXPECT_EQ(o.verdict, Verdict::pass) << head << o.reason;
        EXPECT_EQ(v.emitted.verdict, Verdict::pass) << head << to_text(v.emitted);
        ASSERT_EQ(v.defects.size(), 3U);
        for (const OutputVerdict& d : v.defects) EXPECT_GE(d.slope, 2.9) << head << d.name;
        EXPECT_NEAR(v.conditions.growth_end.value(), 6, 1e-9) << "3/Re lambda, lambda = (1 + i sqrt 11)/2";
        const bool moved = head != "growing = \"status\"\n";
        EXPECT_EQ(v.conditions.moved.size(), moved ? 5U : 0U) << head;
        const auto json = to_json(v);
        EXPECT_EQ(json["outputs"][0]["defect"].size(), json["outputs"][0]["ladder"].size());
        EXPECT_EQ(json.contains("projected"), moved);
    }
}

TEST_F(GrowingModes, AWrongRateLeavesADefect) {
    const std::string text =
        "order = 3\ntime_scale = 1\noutputs = [\"x\"]\ngrowing = \"project\"\n" + started_off;
    test::SceneLine line = test::line_of(written(growing_spiral, text));
    SlowFlow wrong = *line.solution.flow;
    Series& rate = wrong.modes[0].rate;
    const Polynomial part = rate.part(3);
    ASSERT_FALSE(part.empty());
    rate.set(3, Rational(2) * part);
    line.solution.flow = std::make_shared<const SlowFlow>(wrong);
    const Verification v = test::verified(line);
    EXPECT_EQ(v.outputs[0].verdict, Verdict::fail);
    EXPECT_NEAR(v.defects[0].slope, 3, 0.1);
}

TEST_F(GrowingModes, AnAngleIsNotProjected) {
    const Scene scene =
        written("[variables]\nphi = { role = \"angle\" }\ny = { role = \"fast\" }\n[equations]\n"
                "phi = \"phi' = 1 + y\"\ny = \"y' = y\"\n",
                "order = 1\noutputs = [\"y\"]\ngrowing = \"project\"\n[start]\nphi = 0\n"
                "y = \"eps\"\n");
    const Error e = test::error_when([&] { (void)test::solution_of(scene); });
    EXPECT_EQ(e.diagnostic().rule, "a start is projected where no angle moves with the mode that grows");
    EXPECT_EQ(e.diagnostic().value, "phi");
}

} // namespace
} // namespace resonform
