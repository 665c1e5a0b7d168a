// SPDX-License-Identifier: GPL-3.0-or-later
// Liars: every coefficient of a scene is changed, and what catches it is told.
#include "verify/judging/lies.hpp"
#include "verify/judging/verification.hpp"
#include "verify/scene_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace resonform {
namespace {

std::size_t caught_by(const std::vector<Lie>& lies, const std::string& check) {
    return static_cast<std::size_t>(
        std::count_if(lies.begin(), lies.end(), [&](const Lie& lie) { return lie.caught_by == check; }));
}

TEST(Liars, InEveryCoefficientAreCaughtByTheCertificateAndASurvivorIsAFailure) {
    const test::SceneLine line = test::pendulum("mean_motion");
    Verification verification;
    verification.emitted.verdict = Verdict::pass;
    Lies lies;
    lies.threshold = 16;
    lies.all = lies_in_formulas(*line.solution.normalization);
    EXPECT_GT(lies.all.size(), 20U);
    EXPECT_EQ(caught_by(lies.all, "certificate"), lies.all.size());
    EXPECT_EQ(lies.survivors(), 0U);
    verification.lies = lies;
    EXPECT_TRUE(verification.as_expected());

    lies.all.back().caught_by = "";
    EXPECT_EQ(lies.survivors(), 1U);
    EXPECT_NE(to_text(lies).find("survives: " + lies.all.back().where + ", sign\n"), std::string::npos);
    verification.lies = lies;
    EXPECT_FALSE(verification.as_expected());
}

TEST(Liars, BelowIsWhatNothingCatchesUpToTwiceTheThreshold) {
    Lies lies;
    lies.threshold = 16;
    lies.all = {{"x", "outputs: Real(1)", "sign", 32, ""},
                {"x", "outputs: Real(2)", "sign", 33, ""},
                {"x", "outputs: Real(3)", "sign", 1e9, "emitted = exact"}};
    EXPECT_TRUE(lies.is_below(lies.all[0]));
    EXPECT_TRUE(lies.survives(lies.all[1]));
    EXPECT_FALSE(lies.is_below(lies.all[2]));
    EXPECT_FALSE(lies.survives(lies.all[2]));
    EXPECT_EQ(lies.survivors(), 1U);
}

// Every kind of lie, each with a name.
TEST(SlowLiars, OfASceneAreCaught) {
    const test::SceneLine line = test::line_of(test::scene_of("nonholonomic_particle", "uniform_rise"));
    const Lies lies = liars(line.system, line.scene, line.solution, test::options());
    EXPECT_FALSE(lies.honest_fails);
    EXPECT_EQ(lies.survivors(), 0U) << to_text(lies);
    for (const char* check : {"certificate", "emitted = exact"}) // of a closed solution also by the ladder
        EXPECT_GT(caught_by(lies.all, check), 0U) << check;
    for (const Lie& lie : lies.all) {
        EXPECT_TRUE(lie.planted == "sign" || lie.planted == "2^-20");
        EXPECT_EQ(lie.where.find("lied"), std::string::npos) << lie.where;
        EXPECT_EQ(std::isnan(lie.effect_ulp), lie.output.empty()) << lie.where;
        if (lie.caught_by == "emitted = exact") {
            EXPECT_GT(lie.effect_ulp, 0) << lie.where;
        }
    }
}

TEST(SlowLiars, InAClosedSolutionAreCaughtByTheLadder) {
    const test::SceneLine line = test::line_of(test::scene_of("airy", "waves"));
    Lies lies;
    lies.threshold = 16;
    lies_in_solution(line.system, line.scene, line.solution, test::options(), lies);
    EXPECT_EQ(lies.survivors(), 0U) << to_text(lies);
    EXPECT_GE(caught_by(lies.all, "ladder"), 5U);
}

// Those in a weight that moves no output at a claimed order, which no ladder sees, too.
TEST(Liars, InASlowFlowAreCaughtByItsCertificate) {
    const test::SceneLine line = test::line_of(test::scene_of("driven_duffing", "forced_oscillation"));
    const std::vector<Lie> lies = lies_in_flow(line.solution);
    EXPECT_GT(lies.size(), 20U);
    EXPECT_EQ(caught_by(lies, "certificate"), lies.size());
    for (const char* place : {"solution, rate of mode 0, weight 5", "solution, phase rate 0",
                              "solution, x, weight 1", "solution, start of x', weight 3"})
        EXPECT_TRUE(std::any_of(lies.begin(), lies.end(), [&](const Lie& lie) {
            return lie.where.find(place) == 0;
        })) << place;
}

} // namespace
} // namespace resonform
