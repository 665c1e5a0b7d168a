// SPDX-License-Identifier: GPL-3.0-or-later
// How well a slow flow can be known, against formulas.
#include "verify/symbolic/propagation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

using Values = SymbolicPropagation::Values;

SymbolicPropagation::Flow flow(const std::function<long double(long double)>& solution,
                               const std::function<Float128(Float128)>& rate,
                               const std::function<Float128(Float128)>& terms) {
    return {[=](const Float128& T) { return Values{Float128(solution(static_cast<long double>(T)))}; },
            [=](const Float128&, const Values& y) { return Values{rate(y[0])}; },
            [=](const Float128&, const Values& y) { return Values{terms(y[0])}; }};
}

double scale(const SymbolicPropagation& known, long double T) {
    return static_cast<double>(known(Float128(T)).front());
}

// y' = y^3 is infinite at T = 1/2; y^3 is what propagates, whatever the start.
TEST(SymbolicPropagation, TowardsASingularityIsItsCondition) {
    const auto cube = [](Float128 y) { return Float128(y * y * y); };
    const auto y = [](long double T) { return 1 / std::sqrt(1 - 2 * T); };
    const long double end = 0.48L; // fivefold
    const SymbolicPropagation known(flow(y, cube, cube), Float128(end));
    for (const long double T : {0.0L, 0.1L, 0.3L, end}) {
        const long double cubed = std::pow(y(T), 3.0L);
        EXPECT_NEAR(scale(known, T) / static_cast<double>(cubed * (1 + T)), 1, 0.2) << static_cast<double>(T);
    }
}

// y' = 1 - y, y(0) = 0: what was wrong early is forgotten, and nothing grows with the interval.
TEST(SymbolicPropagation, DampingForgets) {
    const auto y = [](long double T) { return 1 - std::exp(-T); };
    const auto rate = [](Float128 x) { return Float128(1 - x); };
    const auto terms = [](Float128 x) { return Float128(1 + x); };
    const SymbolicPropagation known(flow(y, rate, terms), Float128(100));
    EXPECT_EQ(scale(known, 0), 0);
    EXPECT_NEAR(scale(known, 100), 2, 1);
}

// y' = -2 from 1, through zero.
TEST(SymbolicPropagation, ZeroIsNoScale) {
    const auto y = [](long double T) { return 1 - 2 * T; };
    const auto two = [](Float128) { return Float128(2); };
    const SymbolicPropagation known(flow(
                                        y, [](Float128) { return Float128(-2); }, two),
                                    Float128(1));
    EXPECT_NEAR(scale(known, 0.5L), 2, 1e-10);
}

// A turn of 10^6 radians is not followed, and shows no growth that the steps had made.
TEST(SymbolicPropagation, FastTurnsDoNotGrow) {
    const Float128 omega = 1'000'000;
    const auto none = [](const Float128&, const Values&) { return Values{0, 0}; };
    const SymbolicPropagation known({[&](const Float128& T) {
                                         return Values{cosq(omega * T), -sinq(omega * T)};
                                     },
                                     [&](const Float128&, const Values& y) {
                                         const Float128 size = y[0] * y[0] + y[1] * y[1];
                                         return Values{omega * size * y[1], -omega * size * y[0]};
                                     },
                                     none},
                                    Float128(1));
    for (const long double scale : known(Float128(1))) EXPECT_LT(scale, 2);
}

} // namespace
} // namespace resonform
