// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ladder looks: times that no layer escapes, and the rate that sets the first.
#include "verify/estimate/times.hpp"

#include "scene_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace resonform {
namespace {

TEST(Times, HalfAreEvenAndTheOthersCrowdAtBothEnds) {
    const double interval = 400;
    const SampleTimes times = crowded_times(interval, 2000, 1);
    EXPECT_EQ(times.first, 1e-9 * interval) << "below 1e-3 of a period";
    EXPECT_TRUE(std::is_sorted(times.all.begin(), times.all.end()));
    EXPECT_EQ(std::adjacent_find(times.all.begin(), times.all.end()), times.all.end());
    EXPECT_EQ(times.all.front(), 0);
    EXPECT_EQ(times.all.back(), interval);
    EXPECT_EQ(times.all[1], times.first);
    EXPECT_LE(times.all.size(), 2000U);
    EXPECT_GE(times.all.size(), 1990U);
    ASSERT_EQ(times.even.size(), 1000U);
    for (std::size_t i = 0; i < times.even.size(); ++i)
        EXPECT_DOUBLE_EQ(times.all[times.even[i]], interval * static_cast<double>(i) / 999);
    // A layer of any length down to the first time holds dozens of times, at either end.
    for (double layer = 1e-8 * interval; layer < interval; layer *= 10) {
        const auto within = [&](double from, double to) {
            return std::count_if(times.all.begin(), times.all.end(),
                                 [&](double t) { return t > from && t <= to; });
        };
        EXPECT_GE(within(layer / 10, layer), 50) << layer;
        EXPECT_GE(within(interval - layer, interval - layer / 10), 50) << layer;
    }
}

TEST(Times, AFastRateSetsTheFirst) {
    EXPECT_DOUBLE_EQ(crowded_times(400, 2000, 1e8).first, 1e-11);
    EXPECT_DOUBLE_EQ(crowded_times(400, 2000, 0).first, 4e-7);
}

TEST(Times, MayBeginBehindALayer) {
    const SampleTimes times = crowded_times(400, 2000, 1, 100);
    EXPECT_EQ(times.all.front(), 100);
    EXPECT_EQ(times.all.back(), 400);
    EXPECT_NEAR(times.first - 100, 3e-7, 1e-12);
    ASSERT_EQ(times.even.size(), 1000U);
    for (std::size_t i = 0; i < times.even.size(); ++i)
        EXPECT_DOUBLE_EQ(times.all[times.even[i]], 100 + 300 * static_cast<double>(i) / 999);
}

// c decays as e^{-2t} at the start: of 1 is left 10^-3 eps^3.
TEST(Times, ALayerEndsWhereNothingIsLeft) {
    test::SceneLine line = test::line_of(test::scene_of("michaelis_menten", "from_no_complex"));
    const auto end = [&] {
        return layer_end(*line.solution.normalization->normal_form.field, line.scene,
                         Rational(1) / Rational(100));
    };
    EXPECT_EQ(end(), 0);
    line.scene.transients = false;
    EXPECT_NEAR(std::exp(-2 * end()), 1e-9, 1e-15);
}

TEST(Times, TheLargestRateIsAFrequencyToo) {
    const auto rate = [](const test::SceneLine& line) {
        return largest_rate(*line.solution.normalization->normal_form.field, line.scene,
                            Rational(1) / Rational(100));
    };
    EXPECT_DOUBLE_EQ(rate(test::pendulum("third_order")), 1);
    EXPECT_DOUBLE_EQ(rate(test::line_of(test::scene_of("spring_pendulum", "exchange"))),
                     2); // 2 w1
    EXPECT_DOUBLE_EQ(rate(test::line_of(test::scene_of("rotating_pendulum", "fast_rotation"))), 1)
        << "of an angle, where J starts at 1";
}

} // namespace
} // namespace resonform
