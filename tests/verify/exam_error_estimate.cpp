// SPDX-License-Identifier: GPL-3.0-or-later
// Errors estimated from the first neglected weight, against direct integration and against what can be read
// off.
#include "model/files/read_scene.hpp"
#include "scene_line.hpp"
#include "support/shell.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

VerifyOptions estimating() {
    VerifyOptions options = test::options();
    options.compiled = false;
    options.estimate = [](const Scene& scene, const Solution& solution, const std::vector<Rational>& eps) {
        return error_estimates(scene, solution, eps, test::derive);
    };
    return options;
}

Verification estimated(const test::SceneLine& line) {
    return verify(line.system, line.scene, line.solution, estimating());
}

// x'' + x + force = 0 from amplitude eps; of x^3 all weights are odd, and z' = iz + 3i/8 |z|^2 z + ...
class Spring : public testing::Test {
protected:
    // head: keys of the scene such as order.
    ErrorEstimate estimate(const std::string& head, const std::string& interval,
                           const std::string& force = "x^3") {
        test::write(systems_ / "s/system.toml",
                    "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\n"
                    "[equations]\nx = \"x'' + x + " +
                        force + " = 0\"\n");
        test::write(systems_ / "s/scenes/s.toml",
                    head + "\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\neps = [0.1, 0.05]\n" +
                        "interval = \"" + interval + "\"\n");
        const Scene scene = this->scene();
        return error_estimates(scene, test::solution_of(scene), scene.verify.eps, test::derive).at("x");
    }
    [[nodiscard]] Scene scene() const { return read_scene(systems_ / "s/scenes/s.toml", systems_); }

private:
    test::Scratch scratch_;
    std::filesystem::path systems_ = scratch_.path() / "systems";
};

} // namespace

TEST(ErrorEstimate, IsTheErrorOfThePendulum) {
    for (const char* name : {"third_order", "as_published"}) {
        test::SceneLine line = test::pendulum(name);
        test::shorten_ladder(line.scene);
        const Verification v = estimated(line);
        for (const OutputVerdict& o : v.outputs) {
            ASSERT_TRUE(o.estimate_ratio) << o.name;
            // A constant of y at the next order is not that of this one: y = C_Y + ... moves by eps^4.
            EXPECT_NEAR(*o.estimate_ratio, 1, o.name == "y" ? 0.4 : 0.02) << name << " " << o.name;
            EXPECT_EQ(o.estimate->next_order, 4);
            EXPECT_EQ(o.estimate->reason, "");
            EXPECT_EQ(o.estimate->ladder.size(), o.ladder.size());
        }
    }
}

// What is left out of a mean motion is the oscillation: it is in the map.
TEST(ErrorEstimate, OfAMeanMotionIsTheOscillation) {
    test::SceneLine line = test::pendulum("mean_motion");
    test::shorten_ladder(line.scene);
    const Verification v = estimated(line);
    for (const OutputVerdict& o : v.outputs) {
        ASSERT_TRUE(o.estimate_ratio) << o.name;
        EXPECT_NEAR(*o.estimate_ratio, 1, 0.02) << o.name;
        EXPECT_GT(o.estimate->ladder.back().map, 100 * o.estimate->ladder.back().flow) << o.name;
        EXPECT_TRUE(o.estimate->best.empty()) << "at every order the oscillation is left out";
    }
}

TEST(ErrorEstimate, ALieOfTheFormulaIsInIt) {
    test::SceneLine line = test::pendulum("third_order");
    test::shorten_ladder(line.scene);
    for (SolutionOutput& output : line.solution.outputs)
        if (output.name == "x") output.value.set(2, -output.value.part(2));
    const Verification v = estimated(line);
    for (const OutputVerdict& o : v.outputs) {
        ASSERT_TRUE(o.estimate_ratio) << o.name;
        EXPECT_NEAR(*o.estimate_ratio, 1, 0.4) << o.name;
        EXPECT_EQ(o.found_order, o.name == "x" ? 2 : 4) << o.name;
    }
}

TEST(ErrorEstimate, JsonHasTheAgreedKeys) {
    test::SceneLine line = test::pendulum("xy_only");
    test::shorten_ladder(line.scene);
    const auto output = to_json(estimated(line))["outputs"][0];
    ASSERT_TRUE(output.contains("error_estimate"));
    const auto& estimate = output["error_estimate"];
    for (const char* key : {"map", "flow", "ratio", "next_order", "ladder"})
        EXPECT_TRUE(estimate.contains(key)) << key;
    ASSERT_EQ(estimate["ladder"].size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(estimate["ladder"][i]["eps"], output["ladder"][i]["eps"]);
        EXPECT_EQ(estimate["ladder"][i]["true"], output["ladder"][i]["max_error"]);
        EXPECT_GT(estimate["ladder"][i]["estimated"], 0);
    }
    EXPECT_FALSE(to_json(test::verified(line))["outputs"][0].contains("error_estimate"));
}

// Weight 1 lacks the shift 3/8 eps^2 of the frequency: after eps^-3 the phase is off by half a turn and more,
// and the error is twice the amplitude.
TEST_F(Spring, AnErrorOfThePhaseSaturates) {
    const ErrorEstimate e = estimate("order = 1\ntruncation = 1", "1/eps^3");
    EXPECT_EQ(e.next_order, 2);
    ASSERT_EQ(e.ladder.size(), 2U);
    for (const EstimatedRung& rung : e.ladder) EXPECT_NEAR(rung.flow / to_double(rung.eps), 2, 0.05);
}

// On t = O(1) weights 2 add nothing to weights 1, and weights 3 do.
TEST_F(Spring, AWeightThatVanishesIsPassedOver) {
    const ErrorEstimate e = estimate("order = 1\ntime_scale = 0", "5");
    EXPECT_EQ(e.next_order, 3);
    ASSERT_EQ(e.ladder.size(), 2U);
    EXPECT_NEAR(std::log2(e.ladder[0].error / e.ladder[1].error), 3, 0.1);
    EXPECT_EQ(e.reason, "");
}

TEST_F(Spring, OfAnExactFormulaThereIsNone) {
    const ErrorEstimate e = estimate("order = 1", "1/eps", "x");
    EXPECT_EQ(e.next_order, 0);
    EXPECT_EQ(e.reason, "the next two weights vanish identically");
    EXPECT_TRUE(e.best.empty());
}

// A refusal of the next weight is told; that of the one behind a weight that vanishes is a reason.
TEST_F(Spring, WhatCannotBeDerivedIsTold) {
    const auto refusing_above = [](int most) {
        return [most](const std::shared_ptr<const System>& system, int order, int truncation) {
            if (order > most) refuse({"it is derived", "", "", {}});
            return test::derive(system, order, truncation);
        };
    };
    (void)estimate("order = 1\ntime_scale = 0", "5");
    const Scene scene = this->scene();
    const Solution solution = test::solution_of(scene);
    EXPECT_THROW(error_estimates(scene, solution, scene.verify.eps, refusing_above(1)), Error);
    const ErrorEstimate e = error_estimates(scene, solution, scene.verify.eps, refusing_above(2)).at("x");
    EXPECT_EQ(e.next_order, 0);
    EXPECT_EQ(e.reason, "what comes after the next weight, which vanishes identically, cannot be derived: "
                        "it is derived");
}

// Reference and rounding are tested before anything else is blamed.
TEST(ErrorEstimateRatio, ReasonsAreTested) {
    const auto verdict = [](double error, double reference_error) {
        OutputVerdict o;
        o.name = "x";
        ErrorEstimate e;
        e.next_order = 2;
        for (const int inverse : {10, 20}) {
            LadderRung rung;
            rung.eps = Rational(1) / Rational(inverse);
            rung.max_error = error;
            rung.reference_error = reference_error;
            o.ladder.push_back(rung);
            e.ladder.push_back({rung.eps, 0, 1e-9, 1e-9, 0});
        }
        weigh_estimate(o, e);
        return o;
    };
    EXPECT_EQ(verdict(2e-9, 1e-12).estimate->reason, "");
    EXPECT_EQ(verdict(2e-9, 1e-12).estimate_ratio, 0.5);
    EXPECT_EQ(verdict(4e-9, 1e-12).estimate->reason, "no test tells why");
    EXPECT_EQ(verdict(4e-9, 1e-12).estimate_ratio, 0.25);
    EXPECT_EQ(verdict(4e-9, 1e-9).estimate->reason, "reference or rounding is above a third of it");
    EXPECT_FALSE(verdict(4e-9, 1e-9).estimate_ratio);
    EXPECT_EQ(verdict(4e-9, 1e-10).estimate->reason, "the ladder has no usable rung");
}

} // namespace resonform
