// SPDX-License-Identifier: GPL-3.0-or-later
// The ladder finds the orders of the pendulum's scenes by itself, and catches liars.
#include "scene_line.hpp"
#include "support/error_when.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// The factor of eps^weight in one output gets the opposite sign.
void plant_sign_error(Solution& solution, const std::string& name, int weight) {
    for (SolutionOutput& output : solution.outputs)
        if (output.name == name) output.value.set(weight, -output.value.part(weight));
}

TEST(Ladder, ThirdOrderSceneIsFourthOrderAccurate) {
    test::SceneLine line = test::pendulum("third_order");
    test::shorten_ladder(line.scene);
    const Verification v = test::verified_compiled(line);
    ASSERT_EQ(v.outputs.size(), 3U);
    const std::vector<double> constants{2.03, 1.48, 1.42};
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputVerdict& o = v.outputs[k];
        EXPECT_EQ(o.verdict, Verdict::pass) << o.name << ": " << o.reason;
        EXPECT_EQ(o.claimed_order, 4);
        EXPECT_EQ(o.found_order, 4);
        EXPECT_NEAR(o.constant, constants[k], 0.02) << o.name;
        for (const LadderRung& rung : o.ladder) {
            EXPECT_LT(rung.reference_error, 1e-24);
            EXPECT_LT(rung.rms_error, rung.max_error);
        }
    }
    EXPECT_TRUE(v.as_expected());
    EXPECT_EQ(v.emitted.verdict, Verdict::pass);
    EXPECT_LT(v.emitted.worst(), 4);
}

TEST(Ladder, LiarsFail) {
    struct Lie {
        const char* output;
        int weight;
    };
    for (const Lie& lie : {Lie{"psi", 1}, Lie{"psi", 3}, Lie{"x", 2}, Lie{"y", 3}}) {
        test::SceneLine line = test::pendulum("third_order");
        test::shorten_ladder(line.scene);
        plant_sign_error(line.solution, lie.output, lie.weight);
        const Verification v = test::verified(line);
        for (const OutputVerdict& o : v.outputs) {
            const bool lied = o.name == lie.output;
            EXPECT_EQ(o.verdict, lied ? Verdict::fail : Verdict::pass) << o.name << ", weight " << lie.weight;
            EXPECT_EQ(o.found_order, lied ? lie.weight : 4) << o.name;
        }
        EXPECT_FALSE(v.as_expected());
    }
}

TEST(Ladder, StartValuesAgainstTheGradingAreUndecided) {
    test::SceneLine line = test::pendulum("third_order");
    test::shorten_ladder(line.scene);
    for (StartValue& start : line.scene.start)
        if (start.name == "C_delta") {
            start.value = 1 + line.scene.system->eps;
            start.text = "1 + eps";
        }
    const Verification v = test::verified(line);
    for (const OutputVerdict& o : v.outputs) {
        EXPECT_EQ(o.verdict, Verdict::undecided);
        EXPECT_EQ(o.reason,
                  "C_delta starts at 1 + eps, which is not a constant: along a ladder of eps the error "
                  "has no order");
    }
}

TEST(Ladder, RefusesAParameterWithoutValue) {
    test::SceneLine line = test::pendulum("third_order");
    line.scene.fix.erase("r");
    const Error error = test::error_when([&] { test::verified(line); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.diagnostic().rule, "verification needs a value for every parameter");
    EXPECT_EQ(error.diagnostic().hint, "add r = ... under [fix]");
}

TEST(SlowLadder, IntervalsThatTakeHoursEndItAtOnce) {
    test::SceneLine line = test::pendulum("xy_only");
    test::shorten_ladder(line.scene);
    VerifyOptions options = test::options();
    options.compiled = false;
    options.emitted_starts = 1; // of 50 digits over 10^9, which is not the question here
    for (const int power : {9, 300}) {
        line.scene.verify.interval = GiNaC::pow(GiNaC::numeric(10), power);
        const Verification v = verify(line.system, line.scene, line.solution, options);
        ASSERT_TRUE(v.conditions.ladder_end);
        EXPECT_EQ(v.conditions.ladder_end->eps, Rational(1) / Rational(50));
        for (const OutputVerdict& o : v.outputs) {
            EXPECT_EQ(o.verdict, Verdict::undecided);
            EXPECT_EQ(o.reason, "the ladder has 0 rungs, 3 are needed");
        }
        EXPECT_EQ(to_json(v).dump().find("nan"), std::string::npos);
    }
}

TEST(Ladder, TextShowsNoSlopeOfNothing) {
    Verification v{"system", "scene", {}, {}, {}};
    v.outputs.emplace_back();
    v.outputs.front().name = "x";
    for (const int inverse : {10, 20, 50}) {
        LadderRung rung;
        rung.eps = Rational(1) / Rational(inverse);
        v.outputs.front().ladder.push_back(rung);
    }
    judge(v.outputs.front());
    EXPECT_EQ(to_text(v).find("nan"), std::string::npos) << to_text(v);
    EXPECT_EQ(to_json(v).dump().find("nan"), std::string::npos);
}

// What leaves out the oscillation claims the order of its first term, unless the scene says otherwise.
TEST(Ladder, AMeanMotionClaimsWhatItLeavesOut) {
    test::SceneLine line = test::pendulum("mean_motion");
    test::shorten_ladder(line.scene);
    line.scene.verify.claim.clear();
    const Verification v = test::verified(line);
    EXPECT_TRUE(v.as_expected()) << to_text(v);
    for (const OutputVerdict& o : v.outputs) EXPECT_EQ(o.claimed_order, 2) << o.name;
    line.scene.verify.claim["x"] = 4;
    const Verification claimed = test::verified(line);
    EXPECT_EQ(claimed.outputs[0].claimed_order, 4);
    EXPECT_EQ(claimed.outputs[0].verdict, Verdict::fail);
    EXPECT_EQ(claimed.outputs[0].found_order, 2);
}

TEST(Ladder, JsonHasTheAgreedKeys) {
    test::SceneLine line = test::pendulum("xy_only");
    test::shorten_ladder(line.scene);
    const auto json = to_json(test::verified(line));
    EXPECT_EQ(json["schema"], "resonform.verification/1");
    EXPECT_EQ(json["system"], "almost_holonomic_pendulum");
    EXPECT_EQ(json["scene"], "xy_only");
    ASSERT_EQ(json["outputs"].size(), 2U);
    for (const char* key : {"name", "claimed_order", "found_order", "verdict", "expected", "slope",
                            "slope_window", "constant", "ladder"})
        EXPECT_TRUE(json["outputs"][0].contains(key)) << key;
    EXPECT_EQ(json["outputs"][0]["verdict"], "pass");
    EXPECT_EQ(json["outputs"][0]["slope_window"][0], 0.001); // [lo, hi]
    ASSERT_EQ(json["outputs"][0]["ladder"].size(), 5U);
    for (const char* key : {"eps", "max_error", "rms_error", "digits", "reference_error"})
        EXPECT_TRUE(json["outputs"][0]["ladder"][0].contains(key)) << key;
}

TEST(Ladder, CurvesAreEmittedAndDirect) {
    const test::SceneLine line = test::pendulum("third_order");
    const ErrorCurves c = error_curves(line.system, line.scene, line.solution, Rational(1) / Rational(100),
                                       201, test::options());
    ASSERT_EQ(c.outputs, (std::vector<std::string>{"psi", "x", "y"}));
    ASSERT_EQ(c.times.size(), 201U);
    EXPECT_EQ(c.times.back(), 100.0);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 201; ++i) {
            EXPECT_NEAR(c.emitted[k][i] - c.direct[k][i], c.error[k][i], 1e-15);
            EXPECT_LT(std::abs(c.error[k][i]), 2.1e-8);
        }
}

// The whole default ladder, extended by the judge: what the issue asks to be found.
TEST(SlowLadder, PublishedPsiIsThirdOrderOnly) {
    const test::SceneLine line = test::pendulum("as_published");
    const Verification v = test::verified(line);
    EXPECT_TRUE(v.as_expected());
    ASSERT_EQ(v.outputs.size(), 3U);
    EXPECT_EQ(v.outputs[0].verdict, Verdict::fail);
    EXPECT_EQ(v.outputs[0].found_order, 3);
    EXPECT_NEAR(v.outputs[0].constant, 2.53e-3, 0.01e-3);
    for (std::size_t k : {1U, 2U}) {
        EXPECT_EQ(v.outputs[k].verdict, Verdict::pass) << v.outputs[k].reason;
        EXPECT_EQ(v.outputs[k].found_order, 4);
        EXPECT_NEAR(v.outputs[k].constant, 1.48, 0.01);
    }
    EXPECT_LE(to_double(v.outputs[0].ladder.back().eps), 5e-5) << "the ladder was extended until psi settled";
}

} // namespace
} // namespace resonform
