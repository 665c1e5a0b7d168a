// SPDX-License-Identifier: GPL-3.0-or-later
// Equal accuracy and break-even, of costs and errors that are known.
#include "support/program.hpp"
#include "verify/comparison/break_even.hpp"
#include "verify/comparison/equal_accuracy.hpp"
#include "verify/comparison/judged_times.hpp"
#include "verify/comparison/members.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace resonform {
namespace {

TEST(EqualAccuracy, FindsTheToleranceOfAPowerLaw) {
    for (const double slope : {0.5, 1.0, 1.3})
        for (const double wanted : {3e-3, 2.2e-7, 8e-12}) {
            int calls = 0;
            const auto found = loosest_tolerance([&](double tolerance) {
                ++calls;
                return std::pow(tolerance / wanted, slope);
            });
            ASSERT_TRUE(found);
            EXPECT_LE(found->ratio, 1);
            EXPECT_GE(found->ratio, 0.9) << slope << ' ' << wanted;
            EXPECT_NEAR(std::log(found->tolerance / wanted), 0, 0.2);
            EXPECT_LE(calls, 20);
        }
}

// An error in steps has no tolerance at which it is just right: the next better step is taken, and the
// loosest tolerance on it.
TEST(EqualAccuracy, TakesTheBetterSideOfAStep) {
    int calls = 0;
    const auto found = loosest_tolerance([&](double tolerance) {
        ++calls;
        return tolerance < 4.7e-6 ? 0.2 : 3.0;
    });
    ASSERT_TRUE(found);
    EXPECT_EQ(found->ratio, 0.2);
    EXPECT_LT(found->tolerance, 4.7e-6);
    EXPECT_GT(found->tolerance, 4e-6);
    EXPECT_LE(calls, 25);
}

TEST(EqualAccuracy, EndsOfTheRange) {
    EXPECT_FALSE(loosest_tolerance([](double) { return 1.01; }));
    EXPECT_FALSE(loosest_tolerance([](double) { return std::numeric_limits<double>::infinity(); }));
    EXPECT_EQ(loosest_tolerance([](double) { return 0.0; })->tolerance, 0.1);
    // a method that does not reach the end at loose tolerances
    const auto found = loosest_tolerance([](double tolerance) {
        return tolerance > 3e-8 ? std::numeric_limits<double>::infinity() : tolerance / 1e-7;
    });
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::log(found->tolerance / 3e-8), 0, 0.1);
}

TEST(EqualAccuracy, TheWorstOutputCounts) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(error_ratio({1, 6}, {2, 3}), 2);
    EXPECT_EQ(error_ratio({0, 1}, {0, 2}), 0.5);
    EXPECT_TRUE(std::isinf(error_ratio({1e-300, 1}, {0, 2})));
    EXPECT_TRUE(std::isinf(error_ratio({nan, 1}, {1, 1})));
    EXPECT_TRUE(std::isinf(error_ratio({1, nan}, {1, 1})));
}

ComparisonRow row(Task task, Form form, std::size_t points, double seconds, double construction) {
    ComparisonRow row;
    row.method = "emitted";
    row.task = task;
    row.form = form;
    row.order = 3;
    row.points = points;
    row.seconds.median = seconds;
    row.construction_seconds = construction;
    return row;
}

RivalAtEqualAccuracy rival(double seconds, double to_end) {
    RivalAtEqualAccuracy r{"Taylor", seconds};
    r.to_end = to_end;
    return r;
}

// 10 + n against 4 + 3 (n - 1): from n = 5 on.
TEST(BreakEvenOf, PointsFromWhichOnTheEvaluatorWins) {
    const auto own = row(Task::dense, Form::batch, 1001, 1001, 10);
    const BreakEven even = break_even({own}, {rival(3004, 4)}, {3, 1000, 994});
    EXPECT_EQ(even.winner, "emitted");
    EXPECT_EQ(even.points, 5);
    EXPECT_EQ(even.runs, 2); // of 1994 seconds a run wins back 1993
    EXPECT_EQ(break_even({own}, {rival(3004, 4)}, {3, 1000, 993}).runs, 1);
    EXPECT_EQ(break_even({own}, {rival(3004, 20)}, {}).points, 1);
    // the last of the rivals to be beaten counts; one that does not reach the accuracy does not
    EXPECT_EQ(break_even({own}, {rival(3004, 4), rival(2004, 4), {"none", {}}}, {}).points, 8);
    const BreakEven lost = break_even({own}, {rival(3004, 4), rival(1000, 4)}, {});
    EXPECT_EQ(lost.winner, "Taylor");
    EXPECT_FALSE(lost.points);
    EXPECT_FALSE(lost.runs);
    const BreakEven alone = break_even({own}, {{"none", {}}}, {});
    EXPECT_EQ(alone.winner, "emitted");
    EXPECT_FALSE(alone.points) << "there is nobody to be compared with";
}

TEST(BreakEvenOf, TheFastestFormThatHasNumbersCounts) {
    ComparisonRow refused = row(Task::final, Form::at_end, 1, 1, 0);
    refused.failure = "overflow";
    const BreakEven even = break_even({row(Task::final, Form::scalar, 1, 2, 3), refused}, {rival(7, 7)}, {});
    EXPECT_EQ(even.form, Form::scalar);
    EXPECT_EQ(even.emitted_seconds, 5);
    EXPECT_EQ(even.points, 1);
    EXPECT_EQ(break_even({refused}, {rival(7, 7)}, {}).failure, "overflow");
}

TEST(BreakEvenOf, TheLargestEpsBelowWhichItAlwaysWins) {
    const auto at = [](int inverse, bool wins) {
        const auto own = row(Task::final, Form::at_end, 1, 2, 0);
        return BreakEvenAtEps{Rational(1) / inverse, {break_even({own}, {rival(wins ? 3 : 1, 1)}, {})}};
    };
    std::vector<BreakEvenAtEps> by_eps{at(10, true), at(1000, true), at(50, false), at(100, true)};
    find_break_even_eps(by_eps);
    for (const BreakEvenAtEps& one : by_eps) EXPECT_EQ(one.tasks.front().eps, Rational(1) / 100);
    by_eps = {at(10, true), at(100, false)};
    find_break_even_eps(by_eps);
    EXPECT_FALSE(by_eps.front().tasks.front().eps);
}

TEST(JudgedTimes, HoldBothEndsAndAreAllDifferent) {
    for (const std::size_t points : {2U, 3U, 1000U, 2001U, 2002U, 5000U, 1000000U}) {
        const auto times = evenly_judged(7, points);
        EXPECT_EQ(times->all.size(), points);
        ASSERT_EQ(times->judged.size(), std::min<std::size_t>(points, 2001));
        EXPECT_EQ(times->judged.front(), 0U);
        EXPECT_EQ(times->judged.back(), points - 1);
        for (std::size_t j = 1; j < times->judged.size(); ++j)
            ASSERT_LT(times->judged[j - 1], times->judged[j]) << points;
    }
    EXPECT_EQ(evenly_judged(7, 1)->all, std::vector<double>{7});
}

// The pendulum starts with xi = 0, C_delta = 1, theta_0 = 0.
TEST(MembersOfAnEnsemble, SurroundTheStartOfTheScene) {
    const Scene scene = test::pendulum_scene("third_order");
    const auto program = test::program_of(scene);
    constexpr std::size_t count = 300;
    const Members members(*program, 0.01, count);
    const std::vector<double> own = default_start<double>(*program, 0.01, {});
    const std::vector<std::vector<double>> arrays = members.arrays_for(*program);
    ASSERT_EQ(arrays.size(), own.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
        const std::string& name = program->start[k].canonical;
        EXPECT_EQ(arrays[k][0], own[k]) << name;
        double low = arrays[k][0], high = low;
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(members.start_of(i).at(name), arrays[k][i]);
            low = std::min(low, arrays[k][i]);
            high = std::max(high, arrays[k][i]);
        }
        const double width = name.rfind("phase.", 0) == 0 ? 2 * std::acos(-1) : 0.2 * std::abs(own[k]);
        EXPECT_LE(high - low, width) << name;
        EXPECT_GE(high - low, 0.97 * width) << name;
    }
    EXPECT_EQ(members.some(3), (std::vector<std::size_t>{0, 149, 299}));
    EXPECT_EQ(members.some(1), std::vector<std::size_t>{0});
    EXPECT_EQ(Members(*program, 0.01, 2).some(8), (std::vector<std::size_t>{0, 1}));
}

} // namespace
} // namespace resonform
