// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions of differential equations against known ones, in every real type.
#include "runtime/flow.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace resonform {

namespace {

using Fifty = boost::multiprecision::cpp_bin_float_50;

template <class Real> class Flow : public ::testing::Test {};
using Reals = ::testing::Types<double, long double, Float128, Fifty>;
TYPED_TEST_SUITE(Flow, Reals);

template <class Real> Real ulps(const Real& a, const Real& b) {
    return math::magnitude(Real(a - b)) / math::epsilon<Real>();
}

} // namespace

// A circle and a decay: cos T, sin T, 3 exp(-T).
TYPED_TEST(Flow, LinearSystemsHaveFullPrecision) {
    using Real = TypeParam;
    using math::cos;
    using math::exp;
    using math::sin;
    FlowTable<std::array<Real, 3>> flow;
    Real end(7);
    const auto rates = [](const Real&, const std::array<Real, 3>& y) {
        return std::array<Real, 3>{Real(-y[1]), y[0], Real(-y[2])};
    };
    ASSERT_EQ(flow.build(rates, {Real(1), Real(0), Real(3)}, end), Status::ok);
    EXPECT_EQ(end, Real(7));
    EXPECT_LT(flow.panels(), 40U);
    for (int i = 0; i <= 200; ++i) {
        const Real T = Real(7) * Real(i) / Real(200);
        const auto y = flow(T);
        EXPECT_LT(ulps<Real>(y[0], cos(T)), Real(100)) << i;
        EXPECT_LT(ulps<Real>(y[1], sin(T)), Real(100)) << i;
        EXPECT_LT(ulps<Real>(y[2], Real(3) * exp(Real(-T))), Real(100)) << i;
    }
}

// y' = 2 T y^2, y(0) = 1: 1/(1 - T^2), infinite at T = 1.
TYPED_TEST(Flow, NonlinearAndDependentOnTime) {
    using Real = TypeParam;
    FlowTable<std::array<Real, 1>> flow;
    Real end = Real(3) / Real(4);
    const auto rates = [](const Real& T, const std::array<Real, 1>& y) {
        return std::array<Real, 1>{Real(Real(2) * T * y[0] * y[0])};
    };
    ASSERT_EQ(flow.build(rates, {Real(1)}, end), Status::ok);
    for (int i = 0; i <= 100; ++i) {
        const Real T = end * Real(i) / Real(100);
        EXPECT_LT(ulps<Real>(flow(T)[0], Real(1) / (Real(1) - T * T)), Real(500)) << i;
    }
}

// What rests, and what is zero for ever, costs nothing.
TYPED_TEST(Flow, ARestNeedsOnePanel) {
    using Real = TypeParam;
    FlowTable<std::array<Real, 2>> flow;
    Real end(1000);
    const auto rates = [](const Real&, const std::array<Real, 2>& y) {
        return std::array<Real, 2>{Real(y[1] * y[0]), Real(-y[1])};
    };
    ASSERT_EQ(flow.build(rates, {Real(2), Real(0)}, end), Status::ok);
    EXPECT_EQ(flow.panels(), 1U);
    EXPECT_EQ(flow(Real(999))[0], Real(2));
    EXPECT_EQ(flow(Real(999))[1], Real(0));
}

// Beyond the place where the solution becomes infinite there is none; up to it there is.
TYPED_TEST(Flow, EndsWhereTheSolutionDoes) {
    using Real = TypeParam;
    FlowTable<std::array<Real, 1>> flow;
    Real end(3);
    const auto rates = [](const Real&, const std::array<Real, 1>& y) {
        return std::array<Real, 1>{Real(y[0] * y[0])};
    };
    EXPECT_NE(flow.build(rates, {Real(1)}, end), Status::ok);
    EXPECT_LT(end, Real(1));
    EXPECT_GT(end, Real(0.999));
    EXPECT_LT(ulps<Real>(flow(Real(0.5))[0], Real(2)), Real(500));
}

// y' = y^p. Of whatever power it is infinite, and whatever the first step: the same status in every type.
TYPED_TEST(Flow, IsOutsideItsDomainWhereTheSolutionIsInfinite) {
    using Real = TypeParam;
    const bool wide = math::digits<Real> > 64;
    for (const int power : wide ? std::vector{3} : std::vector{2, 3, 5, 9}) { // y^(1 - p) = 1 - (p - 1) T
        for (const int length : wide ? std::vector{7} : std::vector{1, 3, 7, 40, 1000}) {
            FlowTable<std::array<Real, 1>> flow;
            Real end(length);
            const auto rates = [&](const Real&, const std::array<Real, 1>& y) {
                return std::array<Real, 1>{math::power(y[0], power)};
            };
            EXPECT_EQ(flow.build(rates, {Real(1)}, end), Status::outside_domain) << power << ' ' << length;
        }
    }
}

// The same whether the number of values is known to the compiler or not.
TYPED_TEST(Flow, EndsWhereItHasTooManyPanels) {
    using Real = TypeParam;
    using math::cos;
    FlowTable<std::array<Real, 1>> flow;
    Real end(1);
    const auto rates = [](const Real& T, const std::array<Real, 1>&) {
        return std::array<Real, 1>{Real(Real(1000) * cos(Real(Real(1000) * T)))};
    };
    ASSERT_EQ(flow.build(rates, {Real(0)}, end, 8), Status::outside_interval);
    EXPECT_EQ(flow.panels(), 8U);
    EXPECT_GT(end, Real(0));
    EXPECT_LT(end, Real(1));
    using math::sin;
    EXPECT_LT(ulps<Real>(flow(end)[0], sin(Real(Real(1000) * end))), Real(1000));
}

// The rate is the difference of two large terms: it has no more digits than they leave it.
TYPED_TEST(Flow, KnowsHowLargeTheTermsOfItsRatesAre) {
    using Real = TypeParam;
    using Values = std::array<Real, 1>;
    using math::cos;
    struct Rates {
        Real large = Real(1) / (math::epsilon<Real>() * Real(1024));
        Values operator()(const Real& T, const Values&) const { return {Real((large + cos(T)) - large)}; }
        [[nodiscard]] Values scale(const Real&, const Values&) const { return {Real(2 * large)}; }
    };
    const Rates rates;
    FlowTable<Values> flow, blind;
    Real end(1), nowhere(1);
    EXPECT_EQ(flow.build(rates, {Real(0)}, end), Status::ok);
    EXPECT_NEAR(static_cast<double>(flow(Real(1))[0]), std::sin(1.0), 0.01);
    const auto only_rates = [&](const Real& T, const Values& y) { return rates(T, y); };
    EXPECT_EQ(blind.build(only_rates, {Real(0)}, nowhere), Status::outside_domain);
}

// s' = s (200 - 400 T) rises to exp(25)^2 and falls again, an amplitude falls to exp(-37) and rises again:
// each keeps its digits, measured by itself where it is, not by the largest that was.
TYPED_TEST(Flow, WhatFallsAndRisesKeepsItsDigits) {
    using Real = TypeParam;
    using math::cos;
    using math::exp;
    using math::sin;
    FlowTable<std::array<Real, 4>> flow;
    Real end(1);
    const auto rates = [](const Real& T, const std::array<Real, 4>& y) {
        const Real damping = Real(300) * (T - Real(1) / Real(2));
        return std::array<Real, 4>{Real(y[0] * (Real(200) - Real(400) * T)),
                                   Real(damping * y[1] - Real(5) * y[2]),
                                   Real(damping * y[2] + Real(5) * y[1]), Real(1)};
    };
    ASSERT_EQ(flow.build(rates, {Real(1), Real(1), Real(0), Real(0)}, end), Status::ok);
    // In many digits one panel may fall by 1e-4, and the next begins with what is left of the last place.
    const Real bound(math::digits<Real> > 64 ? 1e6 : 2e4);
    for (int i = 0; i <= 100; ++i) {
        const Real T = Real(i) / Real(100), x = T * (Real(1) - T);
        const auto y = flow(T);
        const Real peak = exp(Real(Real(200) * x)), dip = exp(Real(Real(-150) * x));
        EXPECT_LT(ulps<Real>(y[0] / peak, Real(1)), bound) << i;
        EXPECT_LT(ulps<Real>(y[1] / dip, cos(Real(Real(5) * T))), bound) << i;
        EXPECT_LT(ulps<Real>(y[2] / dip, sin(Real(Real(5) * T))), bound) << i;
    }
}

// What falls below the range of the type has lost its digits. While it stays there zero is right; it ends
// where it would rise again.
TEST(FlowOfNothing, WhatIsLostDoesNotRiseAgain) {
    const auto solve = [](double speed, double& end) {
        FlowTable<std::array<double, 2>> flow;
        const Status status = flow.build(
            [speed](double T, const std::array<double, 2>& y) {
                const double growth = speed * (T - 0.5);
                return std::array{growth * y[0] - y[1], growth * y[1] + y[0]};
            },
            {1.0, 0.0}, end);
        return std::pair(status, end > 0 ? flow(end)[0] : 0.0);
    };
    double end = 1;
    EXPECT_EQ(solve(4000, end).first, Status::ok); // exp(-500) at T = 1/2
    EXPECT_NEAR(solve(4000, end).second, std::cos(1.0), 1e-10);
    EXPECT_EQ(solve(8000, end).first, Status::overflow);
    EXPECT_GT(end, 0.5);
    EXPECT_LT(end, 0.9); // exp(-360) there
    end = 0.5;
    EXPECT_EQ(solve(8000, end), std::pair(Status::ok, 0.0));
}

// What lies behind the first panel at whose end it may stop is not looked at: here thousands of panels, each
// smaller than the one before it, up to T = 1.
TEST(FlowOfNothing, GoesNoFurtherThanItIsAskedTo) {
    const auto rates = [](double T, const std::array<double, 2>& y) {
        const double turn = 1 / ((1 - T) * (1 - T));
        return std::array{-turn * y[1], turn * y[0]};
    };
    const auto before = [](double T, const std::array<double, 2>&) { return T < 0.5; };
    FlowTable<std::array<double, 2>> whole, part;
    double end = 1, stopped = 1;
    EXPECT_EQ(whole.build(rates, {1.0, 0.0}, end), Status::outside_domain);
    EXPECT_EQ(part.build_while(rates, before, {1.0, 0.0}, stopped), Status::outside_domain);
    EXPECT_GT(whole.panels(), 1000U);
    EXPECT_LT(part.panels(), 20U);
    EXPECT_GE(stopped, 0.5);
    EXPECT_NEAR(part(0.4)[0], std::cos(1 / 0.6 - 1), 1e-14);
}

// Nowhere infinite, but beyond the range of the type.
TEST(FlowOfNothing, WhatGrowsBeyondTheRangeOverflows) {
    FlowTable<std::array<double, 1>> flow;
    double end = 1;
    const auto rates = [](double, const std::array<double, 1>& y) { return std::array{1000 * y[0]}; };
    EXPECT_EQ(flow.build(rates, {1.0}, end), Status::overflow);
    EXPECT_GT(end, 0.65);
    EXPECT_NEAR(flow(end)[0] / std::exp(1000 * end), 1, 1e-10); // exp(650) at least
}

// A value that is fed by what cancels is known to what the last places of the others make of it.
TEST(FlowOfNothing, WhatCancelsIsNoSize) {
    FlowTable<std::array<double, 3>> flow;
    double end = 50;
    const auto rates = [](double, const std::array<double, 3>& y) {
        return std::array{y[1] * y[1] + y[2] * y[2] - 1, -y[2], y[1]};
    };
    ASSERT_EQ(flow.build(rates, {0.0, 1.0, 0.0}, end), Status::ok);
    EXPECT_NEAR(flow(50)[0], 0, 1e-11);
    EXPECT_LT(flow.panels(), 300U);
}

TEST(FlowOfVectors, AgreesWithThatOfArrays) {
    const auto rate = [](double T, double y) { return std::cos(T) * y - y * y; };
    FlowTable<std::array<double, 1>> fixed;
    FlowTable<std::vector<double>> free;
    double end = 5, free_end = 5;
    ASSERT_EQ(fixed.build([&](double T, const auto& y) { return std::array{rate(T, y[0])}; }, {0.5}, end),
              Status::ok);
    ASSERT_EQ(
        free.build([&](double T, const auto& y) { return std::vector{rate(T, y[0])}; }, {0.5}, free_end),
        Status::ok);
    for (const double T : {0.0, 0.3, 2.5, 5.0}) EXPECT_EQ(fixed(T)[0], free(T)[0]);
}

TEST(FlowOfNothing, ARateThatIsNoNumberIsSaid) {
    FlowTable<std::array<double, 1>> flow;
    double end = 1;
    const auto rates = [](double T, const std::array<double, 1>&) { return std::array{std::sqrt(-1 - T)}; };
    EXPECT_EQ(flow.build(rates, {1.0}, end), Status::outside_domain);
    EXPECT_EQ(end, 0);
}

} // namespace resonform
