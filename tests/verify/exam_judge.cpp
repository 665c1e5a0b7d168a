// SPDX-License-Identifier: GPL-3.0-or-later
// The judge on ladders whose answer is known.
#include "verify/judging/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace resonform {
namespace {

using ErrorLaw = std::function<double(double)>;

Rational rung(int digit, int decade) {
    return Rational(digit) / cln::expt_pos(cln::cl_I(10), cln::cl_I(decade));
}

// 0.2, 0.1, 0.05, 0.02, ... down to 10^-lowest, errors as given, floor for each rung.
OutputVerdict ladder(const ErrorLaw& error, int claim, double floor = 0, int lowest = 4) {
    OutputVerdict output;
    output.name = "psi";
    output.claimed_order = claim;
    std::vector<Rational> eps{rung(2, 1), rung(1, 1)};
    for (int decade = 2; decade <= lowest; ++decade)
        for (int digit : {5, 2, 1}) eps.push_back(rung(digit, decade));
    for (const Rational& e : eps) {
        LadderRung r;
        r.eps = e;
        r.max_error = error(to_double(e));
        r.floor = floor;
        output.ladder.push_back(r);
    }
    judge(output);
    return output;
}

TEST(Judge, CleanSlopes) {
    for (int order = 1; order <= 9; ++order) {
        const auto power = [order](double e) { return 0.7 * std::pow(e, order); };
        const OutputVerdict pass = ladder(power, order);
        EXPECT_EQ(pass.verdict, Verdict::pass);
        EXPECT_EQ(pass.found_order, order);
        EXPECT_NEAR(pass.slope, order, 1e-9);
        EXPECT_NEAR(pass.constant, 0.7, 1e-6);
        EXPECT_EQ(pass.reason, "");
        const OutputVerdict fail = ladder(power, order + 1);
        EXPECT_EQ(fail.verdict, Verdict::fail);
        EXPECT_EQ(fail.found_order, order);
        EXPECT_EQ(ladder(power, order - 1).verdict, Verdict::pass) << "better than claimed";
        EXPECT_TRUE(settled(pass));
    }
}

// Of a layer the ladder sees nothing here: its errors are smaller than those of the rest on every rung.
TEST(Judge, ALayerIsJudgedByItself) {
    const auto rest = [](double e) { return 100 * std::pow(e, 3); };
    const auto with_layer = [&](const ErrorLaw& within) {
        OutputVerdict output = ladder(rest, 3);
        output.layer = ladder(within, 3).ladder;
        judge(output);
        return output;
    };
    const OutputVerdict lost = with_layer([](double e) { return 1e-3 * e * e; });
    EXPECT_EQ(lost.verdict, Verdict::fail);
    EXPECT_EQ(lost.found_order, std::nullopt);
    EXPECT_NEAR(lost.layer_slope, 2, 1e-9);
    EXPECT_EQ(lost.reason.rfind("within the layer, t <= 20/|Re lambda|: claimed eps^3, found eps^2", 0), 0U)
        << lost.reason;
    EXPECT_EQ(with_layer([](double e) { return std::pow(e, 3); }).verdict, Verdict::pass);
    EXPECT_EQ(with_layer([](double e) { return std::pow(e, 4.5); }).verdict, Verdict::pass)
        << "any slope above";
    EXPECT_EQ(with_layer([](double) { return 0.0; }).verdict, Verdict::pass) << "an exact one";
}

// The psi of eq. (22) as measured: e/eps^3 -> 2.53e-3, slope 4.03 at 0.01, 3.25 at 5e-4.
TEST(Judge, BentSlopeOfThePublishedPsi) {
    const auto bent = [](double e) { return 2.53e-3 * std::pow(e, 3) + 0.77 * std::pow(e, 4); };
    const OutputVerdict output = ladder(bent, 4);
    EXPECT_EQ(output.verdict, Verdict::fail);
    EXPECT_EQ(output.found_order, 3);
    EXPECT_NEAR(output.constant, 2.53e-3, 2.53e-5);
    EXPECT_FALSE(settled(output)) << "at 1e-4 the slope still moves";
    EXPECT_TRUE(settled(ladder(bent, 4, 0, 6)));
    EXPECT_EQ(output.reason, "claimed eps^4, found eps^3: max|error| -> 0.00253 eps^3");
}

TEST(Judge, MeasuredPsiOfThePublishedFormula) {
    OutputVerdict output;
    output.claimed_order = 4;
    const std::vector<std::pair<Rational, double>> measured{{rung(1, 2), 2.06e-2}, {rung(3, 3), 6.9e-3},
                                                            {rung(1, 3), 3.3e-3},  {rung(3, 4), 2.69e-3},
                                                            {rung(1, 4), 2.55e-3}, {rung(3, 5), 2.54e-3}};
    for (const auto& [eps, ratio] : measured) {
        LadderRung r;
        r.eps = eps;
        r.max_error = ratio * std::pow(to_double(eps), 3);
        output.ladder.push_back(r);
    }
    judge(output);
    EXPECT_EQ(output.verdict, Verdict::fail);
    EXPECT_EQ(output.found_order, 3);
    EXPECT_NEAR(output.constant, 2.53e-3, 1.5e-5);
}

TEST(Judge, ACorrectResultWithABentSlopePasses) {
    const auto bent = [](double e) { return 1e-3 * std::pow(e, 4) + 0.5 * std::pow(e, 5); };
    const OutputVerdict output = ladder(bent, 4);
    EXPECT_EQ(output.verdict, Verdict::pass);
    EXPECT_EQ(output.found_order, 4);
    EXPECT_NEAR(output.constant, 1e-3, 2e-5);
}

TEST(Judge, FloorPollutionIsLeftOut) {
    const double floor = 1e-16;
    const auto polluted = [floor](double e) { return 1.5 * std::pow(e, 4) + floor; };
    const OutputVerdict output = ladder(polluted, 4, floor);
    EXPECT_EQ(output.verdict, Verdict::pass);
    EXPECT_EQ(output.found_order, 4);
    EXPECT_NEAR(output.constant, 1.5, 0.05);
    EXPECT_GE(output.slope_low_eps, 1e-4);
    EXPECT_TRUE(settled(output)) << "smaller eps would only show the floor";
}

TEST(Judge, NoiseOfOnePercentDoesNotChangeTheVerdict) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> noise(0.99, 1.01);
        const auto noisy = [&](double e) { return 0.3 * std::pow(e, 4) * noise(random); };
        const OutputVerdict output = ladder(noisy, 4);
        EXPECT_EQ(output.verdict, Verdict::pass) << "seed " << seed << ": " << output.reason;
        EXPECT_EQ(output.found_order, 4);
        EXPECT_NEAR(output.constant, 0.3, 0.02) << "seed " << seed;
    }
}

TEST(Judge, ExactOutputsPass) {
    const OutputVerdict zero = ladder([](double) { return 0.0; }, 4);
    EXPECT_EQ(zero.verdict, Verdict::pass);
    EXPECT_EQ(zero.reason,
              "the error stays below what the arithmetic can show at every eps: exact as far as can be seen");
    EXPECT_EQ(ladder([](double) { return 3e-31; }, 4, 1e-32).verdict, Verdict::pass);
    EXPECT_TRUE(settled(zero));
}

TEST(Judge, UndecidedSaysWhy) {
    const OutputVerdict few = ladder([](double e) { return std::pow(e, 12); }, 12, 1e-17);
    EXPECT_EQ(few.verdict, Verdict::undecided);
    EXPECT_FALSE(few.found_order);
    EXPECT_EQ(few.reason, "2 of 11 rungs lie clear of the arithmetic's floor, 3 are needed");

    const OutputVerdict half = ladder([](double e) { return std::pow(e, 3.5); }, 3);
    EXPECT_EQ(half.verdict, Verdict::undecided);
    EXPECT_FALSE(half.found_order);
    EXPECT_TRUE(std::isnan(half.constant));
    EXPECT_EQ(half.reason, "the slope 3.50 is not near an integer");

    const OutputVerdict bending = ladder([](double e) { return std::pow(e, 2) * std::exp(3000 * e); }, 2);
    EXPECT_EQ(bending.verdict, Verdict::undecided);
    EXPECT_FALSE(bending.found_order);
    EXPECT_EQ(bending.reason.substr(0, 21), "the slope still bends");

    const OutputVerdict refused = ladder([](double) { return std::numeric_limits<double>::infinity(); }, 4);
    EXPECT_EQ(refused.verdict, Verdict::undecided);
    EXPECT_EQ(refused.reason, "the evaluator refuses points of the interval at eps = 0.2: no error to judge");
}

// Every rung lies below 100 times the noise, yet the noise is as large as what the claim forbids.
TEST(Judge, WhatNoiseHidesDoesNotPass) {
    const auto hidden = [](const ErrorLaw& error, int claim, const ErrorLaw& reference, double scale) {
        OutputVerdict output = ladder(error, claim);
        for (LadderRung& r : output.ladder) {
            r.reference_error = reference(to_double(r.eps));
            r.scale = scale;
        }
        judge(output);
        return output;
    };
    const auto line = [](double factor, int power) {
        return [=](double e) { return factor * std::pow(e, power); };
    };
    const OutputVerdict poor = hidden(line(1, 1), 4, line(0.02, 1), 1);
    EXPECT_EQ(poor.verdict, Verdict::undecided);
    EXPECT_FALSE(poor.found_order);
    EXPECT_EQ(poor.reason,
              "no error is seen, but noise hides what eps^4 allows: it is small enough on 0 of 11 rungs, "
              "6 are needed (at eps = 0.2: noise 0.4, at most 1.6e-06)");
    EXPECT_EQ(hidden(line(1e-3, 3), 4, line(2e-5, 3), 1).verdict, Verdict::undecided);
    EXPECT_EQ(hidden(line(1e6, 0), 9, line(1e6, 0), 1e40).verdict, Verdict::undecided) << "a large output";
    EXPECT_EQ(hidden(line(1e-32, 0), 4, line(1e-32, 0), 1e-20).verdict, Verdict::undecided) << "a small one";
    EXPECT_EQ(hidden(line(1e-32, 0), 4, line(1e-32, 0), 1e-3).verdict, Verdict::pass);
    EXPECT_EQ(hidden(line(1e-30, 0), 4, line(1e-30, 0), 1e6).verdict, Verdict::pass);
}

TEST(Judge, AStraightSlopeBelowAnIntegerNamesNoOrder) {
    const OutputVerdict output = ladder([](double e) { return std::pow(e, 3.75); }, 4);
    EXPECT_EQ(output.verdict, Verdict::undecided);
    EXPECT_FALSE(output.found_order);
    EXPECT_EQ(output.reason, "the slope 3.75 is not near an integer");
}

TEST(Judge, RefusedPointsBelowGoodRungsAreUndecided) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const auto last = [bad](double e) { return e < 0.004 ? bad : std::pow(e, 4); };
        const auto between = [bad](double e) { return std::abs(e - 0.01) < 1e-6 ? bad : std::pow(e, 4); };
        EXPECT_EQ(ladder(last, 4).verdict, Verdict::undecided);
        EXPECT_EQ(ladder(last, 4).reason, "the evaluator refuses points of the interval at eps = 0.002");
        EXPECT_EQ(ladder(between, 4).verdict, Verdict::undecided);
        EXPECT_EQ(ladder(between, 4).reason, "the evaluator refuses points of the interval at eps = 0.01");
        const auto first = [bad](double e) { return e > 0.06 ? bad : std::pow(e, 4); };
        EXPECT_EQ(ladder(first, 4).verdict, Verdict::pass) << "large eps may be out of reach";
    }
}

TEST(Judge, SlopesThatLeaveTheirIntegerAreUndecided) {
    const auto error = [](double e) { return 1e-5 * std::pow(e, 3) + std::pow(e, 4); };
    const OutputVerdict output = ladder(error, 4);
    EXPECT_EQ(output.verdict, Verdict::undecided);
    EXPECT_EQ(output.reason.substr(0, 21), "the slope still bends");
    EXPECT_FALSE(settled(output)) << "a default ladder goes on";
    EXPECT_EQ(ladder(error, 4, 0, 7).verdict, Verdict::fail);
    EXPECT_EQ(ladder(error, 4, 0, 7).found_order, 3);
}

TEST(Judge, AZeroOfTheErrorDoesNotHideSmallerRungs) {
    const auto error = [](double e) {
        return std::abs(e - 1e-3) < 1e-9 ? 0.0 : std::abs(1e-3 * std::pow(e, 3) - std::pow(e, 4));
    };
    const OutputVerdict output = ladder(error, 4, 1e-30);
    EXPECT_EQ(output.slope_low_eps, 1e-4);
    EXPECT_EQ(output.verdict, Verdict::fail) << output.reason;
    EXPECT_EQ(output.found_order, 3);
}

// A liar: one coefficient of weight 3 with the wrong sign leaves an error 2 c eps^3.
TEST(Judge, APlantedErrorFails) {
    const auto right = [](double e) { return 1.48 * std::pow(e, 4); };
    EXPECT_EQ(ladder(right, 4).verdict, Verdict::pass);
    for (double planted : {1e-3, -1.0, 30.0}) {
        const auto wrong = [&](double e) { return std::abs(right(e) + planted * std::pow(e, 3)); };
        EXPECT_EQ(ladder(wrong, 4).verdict, Verdict::fail) << planted;
        EXPECT_EQ(ladder(wrong, 4).found_order, 3) << planted;
    }
}

// Measured at eps = 0.1 ... 0.002 where the true order is 5: slopes near 6 that leave it faster and
// faster name no order.
TEST(Judge, SlopesThatBendAwayAreUndecided) {
    OutputVerdict output;
    output.claimed_order = 6;
    const std::vector<Rational> eps{rung(1, 1), rung(5, 2), rung(2, 2), rung(1, 2), rung(5, 3), rung(2, 3)};
    const std::vector<double> slopes{6.03, 6.02, 6.017, 6.002, 5.889};
    double error = 1e-3;
    for (std::size_t i = 0; i < eps.size(); ++i) {
        if (i > 0) error *= std::pow(to_double(eps[i]) / to_double(eps[i - 1]), slopes[i - 1]);
        LadderRung r;
        r.eps = eps[i];
        r.max_error = error;
        output.ladder.push_back(r);
    }
    judge(output);
    EXPECT_EQ(output.verdict, Verdict::undecided);
    EXPECT_TRUE(std::isnan(output.constant));
    EXPECT_EQ(output.reason, "the slope still bends (6.00, then 5.89) at eps = 0.002: add smaller eps");
}

} // namespace
} // namespace resonform
