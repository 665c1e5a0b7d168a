// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/truncation.hpp"

#include "model/files/read_system.hpp"
#include "solve/line.hpp"
#include "solve/systems.hpp"
#include "solve/time_scale.hpp"
#include "support/error_when.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

Scene scene(int order, std::optional<int> time_scale, std::optional<int> truncation = std::nullopt) {
    Scene s;
    s.order = order;
    s.time_scale = time_scale;
    s.truncation = truncation;
    s.time_scale_place = {"scene.toml", 2, 14, "time_scale", "time_scale = 2"};
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
    const Error e = test::error_when([&] { count_truncation(*field_of(pendulum()), scene(3, 2)); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().value, "time_scale = 2, xi' = O(eps) of constant sign");
    EXPECT_EQ(e.diagnostic().hint, "use time_scale = 1, or give the truncation yourself");
    EXPECT_EQ(e.diagnostic().place.file, "scene.toml");
    EXPECT_EQ(e.diagnostic().place.line, 2);
}

void expect_refused(const Solution& solution, const Scene& scene, const std::string& value,
                    const std::string& hint) {
    const Error e = test::error_when([&] { check_time_scale(solution, scene); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().value, value);
    EXPECT_EQ(e.diagnostic().hint, hint);
}

const char* const to_one = "use time_scale = 1, or give the truncation yourself";

// Of a drift that is an output the next weight is taken: amplitudes act on its rate.
TEST(Truncation, RefusesLongerTimesForADriftThatGoesFar) {
    const auto field = field_of(read_system_text(duffing, "test.toml"));
    EXPECT_EQ(count_truncation(*field, scene(3, 2)).truncation, 5);
    Scene with_drift = scene(3, 2);
    with_drift.outputs = {"x", "X"};
    EXPECT_EQ(count_truncation(*field, with_drift).truncation, 6);
    EXPECT_NO_THROW(check_time_scale(solution_of_text(duffing, 2, 5, 2), scene(2, 2)));
    with_drift.order = 2;
    expect_refused(solution_of_text(duffing, 2, 5, 2), with_drift,
                   "time_scale = 2, X has a rate of order eps^1", to_one);
}

// X' = x^2 goes a finite way on 1/eps^2.
TEST(Truncation, TakesADriftThatIsSlowEnough) {
    const std::string slow = std::string(conservative)
                                 .replace(std::string(conservative).find("[equations]"), 11,
                                          "X = { role = \"drift\" }\n[equations]\nX = \"X' = x^2\"");
    Scene with_drift = scene(2, 2);
    with_drift.outputs = {"x", "X"};
    EXPECT_NO_THROW(check_time_scale(solution_of_text(slow, 2, 5, 2), with_drift));
    with_drift.time_scale = 3;
    expect_refused(solution_of_text(slow, 2, 7, 3), with_drift, "time_scale = 3, X has a rate of order eps^2",
                   "use time_scale = 2, or give the truncation yourself");
}

// What quadratures in T = eps t cannot do is a slow flow: there the rate of the amplitude decides.
TEST(Truncation, AnAmplitudeThatChangesOnLongerTimesIsASlowFlow) {
    const std::string slowly = test::system_text("slowly", {{"x", "fast", "x'' + eps^2*x' + x + x^3 = 0"}});
    EXPECT_FALSE(solution_of_text(conservative, 2, 4, 2).flow);
    EXPECT_FALSE(solution_of_text(slowly, 2, 3).flow);
    const Solution long_time = solution_of_text(slowly, 2, 4, 2);
    EXPECT_TRUE(long_time.flow);
    EXPECT_NO_THROW(check_time_scale(long_time, scene(2, 2)));
    expect_refused(solution_of_text(slowly, 2, 6, 3), scene(2, 3),
                   "time_scale = 3, the flow has rates of order eps^2",
                   "use time_scale = 2, or give the truncation yourself");
    EXPECT_NO_THROW(check_time_scale(solution_of_text(damped, 2, 3), scene(2, 1)));
    expect_refused(solution_of_text(damped, 2, 4, 2), scene(2, 2),
                   "time_scale = 2, the flow has rates of order eps^1", to_one);
}

// The phase turns by eps^2 |z|^2 besides, which is no way to go: the amplitude moves as eps^3.
TEST(Truncation, WhatOnlyTurnsMayTurnFaster) {
    const std::string very_slowly =
        test::system_text("very_slowly", {{"x", "fast", "x'' + eps^3*x' + x + x^3 = 0"}});
    EXPECT_NO_THROW(check_time_scale(solution_of_text(very_slowly, 2, 6, 3), scene(2, 3)));
}

} // namespace
