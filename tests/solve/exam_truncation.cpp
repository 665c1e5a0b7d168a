// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/truncation.hpp"

#include "solve/line.hpp"
#include "solve/systems.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

Scene scene(int order, std::optional<int> time_scale, std::optional<int> truncation = std::nullopt) {
    Scene s;
    s.order = order;
    s.time_scale = time_scale;
    s.truncation = truncation;
    s.file = "scene.toml";
    return s;
}

TEST(Truncation, CountsOneWeightMoreOnOneOverEps) {
    const auto field = field_of(pendulum());
    const auto count = count_truncation(*field, scene(3, 1));
    EXPECT_EQ(count.truncation, 4);
    EXPECT_EQ(count.reason, "order 3 on t = O(1/eps): rates neglected at weight 5 act over 1/eps, so M = "
                            "max(N + p, N + 2p - 2) = 4");
    EXPECT_EQ(count_truncation(*field, scene(3, std::nullopt)).truncation, 4);
    EXPECT_EQ(count_truncation(*field, scene(3, 0)).truncation, 3);
}

TEST(Truncation, TakesThePlainOneOnRequest) {
    const auto count = count_truncation(*field_of(pendulum()), scene(3, std::nullopt, 3));
    EXPECT_EQ(count.truncation, 3);
    EXPECT_EQ(count.reason, "plain truncation: M = 3");
}

TEST(Truncation, CountsTheTwistOnLongerTimes) {
    const auto field = field_of(read_system_text(conservative, "test.toml"));
    EXPECT_EQ(count_truncation(*field, scene(3, 2)).truncation, 5);
    EXPECT_EQ(count_truncation(*field, scene(3, 3)).truncation, 7);
}

TEST(Truncation, RefusesLongerTimesForASlowVariableThatRunsAway) {
    try {
        count_truncation(*field_of(pendulum()), scene(3, 2));
        FAIL() << "not refused";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), Kind::refused);
        EXPECT_EQ(e.diagnostic().value, "time_scale = 2, xi' = O(eps) of constant sign");
        EXPECT_EQ(e.diagnostic().mend, "use time_scale = 1, or give the truncation yourself");
        EXPECT_EQ(e.diagnostic().place.file, "scene.toml");
    }
}

TEST(Truncation, RefusesLongerTimesForADrift) {
    const auto field = field_of(read_system_text(duffing, "test.toml"));
    try {
        count_truncation(*field, scene(3, 2));
        FAIL() << "not refused";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), Kind::refused);
        EXPECT_EQ(e.diagnostic().value, "time_scale = 2, X drifts");
    }
}

TEST(Truncation, RefusesLongerTimesForAnAmplitudeThatChanges) {
    EXPECT_NO_THROW(check_time_scale(solution_of_text(conservative, 2, 4), scene(2, 2)));
    EXPECT_NO_THROW(check_time_scale(solution_of_text(damped, 2, 3), scene(2, 1)));
    try {
        check_time_scale(solution_of_text(damped, 2, 4), scene(2, 2));
        FAIL() << "not refused";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), Kind::refused);
        EXPECT_EQ(e.diagnostic().value, "time_scale = 2, the amplitude of x changes with eps*t");
    }
}

} // namespace
