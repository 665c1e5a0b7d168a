// SPDX-License-Identifier: GPL-3.0-or-later
// Tabulated integrals against known ones, in every real type.
#include "runtime/table.hpp"
#include "runtime/twice.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace resonform {

namespace {

using Fifty = boost::multiprecision::cpp_bin_float_50;

template <class Real> Real worst_error(const PrimitiveTable<Real, 2>& table, const Real& end) {
    using math::asinh;
    using math::sin;
    Real worst(0);
    for (int i = 0; i <= 300; ++i) {
        const Real T = end * Real(i) / Real(300);
        const auto value = table(T);
        for (const Real& error : {Real(value[0] - asinh(T)), Real(value[1] - sin(T))})
            worst = std::max(worst, Real(math::magnitude(error)));
    }
    return worst;
}

template <class Real> class Table : public ::testing::Test {};
using Reals = ::testing::Types<double, long double, Float128, Fifty>;
TYPED_TEST_SUITE(Table, Reals);

} // namespace

// int 1/sqrt(1 + T^2) = asinh T and int cos T = sin T side by side, to a few ulp of their size.
TYPED_TEST(Table, IntegralsOfSmoothFunctionsHaveFullPrecision) {
    using Real = TypeParam;
    PrimitiveTable<Real, 2> table;
    Real end(3);
    const Status status = table.build(
        [](const Real& T) {
            using math::cos;
            using math::sqrt;
            return std::array<Real, 2>{Real(Real(1) / sqrt(Real(Real(1) + T * T))), Real(cos(T))};
        },
        end);
    ASSERT_EQ(status, Status::ok);
    EXPECT_LT(worst_error(table, Real(3)), Real(10) * math::epsilon<Real>());
    EXPECT_LT(table.panels(), 60U);
}

TYPED_TEST(Table, PolynomialsNeedOnePanel) {
    using Real = TypeParam;
    PrimitiveTable<Real, 1> table;
    Real end(2);
    ASSERT_EQ(table.build([](const Real& T) { return std::array<Real, 1>{Real(3) * T * T}; }, end),
              Status::ok);
    EXPECT_EQ(table.panels(), 1U);
    EXPECT_LT(math::magnitude(Real(table(Real(2))[0] - Real(8))), Real(32) * math::epsilon<Real>());
}

// Near T = 0 the error is small against the integral itself.
TYPED_TEST(Table, StartsFromZeroWithRelativePrecision) {
    using Real = TypeParam;
    PrimitiveTable<Real, 1> table;
    const auto falling = [](const Real& T) {
        using math::exp;
        return std::array<Real, 1>{Real(exp(Real(-T)))};
    };
    Real end(5);
    ASSERT_EQ(table.build(falling, end), Status::ok);
    EXPECT_EQ(table(Real(0))[0], Real(0));
    const Real tiny = math::epsilon<Real>(); // 1 - exp(-T) = T to all digits
    EXPECT_LT(math::magnitude(Real(table(tiny)[0] - tiny)), Real(16) * math::epsilon<Real>() * tiny);
}

// The fit adds no more than the rounding of its result: an error in a coefficient would show at every point.
TEST(TableOfQuadratures, IsFittedInFinerNumbers) {
    const double rate = 0.3;
    double worst = 0;
    for (const double length : {0.7, 1.0, 1.3, 90.0}) {
        PrimitiveTable<double, 1> table;
        double end = length;
        ASSERT_EQ(table.build([&](double) { return std::array{rate}; }, end), Status::ok);
        for (int i = 1; i <= 100; ++i) {
            const double T = length * i / 100, exact = rate * T;
            worst = std::max(worst, std::abs(table(T)[0] - exact) / (0x1p-52 * exact));
        }
    }
    EXPECT_LE(worst, 1.5);
}

// A peak 10^-4 wide in the middle: panels gather there, and the integral is exact all the same.
TEST(TableOfPeaks, NarrowPeaksAreResolved) {
    const double width = 1e-4;
    PrimitiveTable<double, 1> table;
    const auto peak = [&](double T) { return std::array{width / ((T - 0.3) * (T - 0.3) + width * width)}; };
    double end = 1;
    ASSERT_EQ(table.build(peak, end), Status::ok);
    for (const double T : {0.1, 0.29, 0.3, 0.30005, 0.7, 1.0})
        EXPECT_NEAR(table(T)[0], std::atan((T - 0.3) / width) + std::atan(0.3 / width), 1e-14) << T;
}

// An integrand that grows by e^100: the integral has its digits from the beginning.
TYPED_TEST(Table, WhatComesLaterTakesNoDigits) {
    using Real = TypeParam;
    using math::exp;
    PrimitiveTable<Real, 1> table;
    const auto growing = [](const Real& T) { return std::array<Real, 1>{Real(exp(Real(Real(100) * T)))}; };
    Real end(1);
    ASSERT_EQ(table.build(growing, end), Status::ok);
    for (int i = 1; i <= 20; ++i) {
        const Real T = Real(i) / Real(20), value = (exp(Real(Real(100) * T)) - Real(1)) / Real(100);
        EXPECT_LT(math::magnitude(Real(table(T)[0] - value)), Real(100) * math::epsilon<Real>() * value) << i;
    }
}

// Rounding noise of the integrand (here 100 ulp) is no lack of smoothness.
TEST(TableOfPeaks, NoiseOfTheIntegrandIsTolerated) {
    PrimitiveTable<double, 1> table;
    const auto noisy = [](double T) { return std::array{(std::cos(T) + 100.0) - 100.0}; };
    double end = 1;
    ASSERT_EQ(table.build(noisy, end), Status::ok);
    EXPECT_NEAR(table(1.0)[0], std::sin(1.0), 1e-13);
}

TEST(TableStatus, SaysWhatIsWrongWithTheIntegrand) {
    const auto status_of = [](auto integrand) {
        PrimitiveTable<double, 1> table;
        double end = 1;
        return table.build([&](double T) { return std::array<double, 1>{integrand(T)}; }, end);
    };
    EXPECT_EQ(status_of([](double T) { return std::sqrt(T - 0.5); }), Status::outside_domain);
    EXPECT_EQ(status_of([](double T) { return T < 0.5 ? 0.0 : 1e308 * 10; }), Status::overflow);
    EXPECT_EQ(status_of([](double T) { return 1 / std::abs(T - 0.3); }), Status::outside_domain);
}

// What is defined on a part of the interval only is tabulated there.
TEST(TableStatus, TheEndIsDrawnBackToWhereTheIntegrandIsDefined) {
    PrimitiveTable<double, 1> table;
    double end = 1;
    const auto root = [](double T) { return std::array{std::sqrt(0.3 - T)}; };
    ASSERT_EQ(table.build(root, end), Status::outside_domain);
    EXPECT_NEAR(end, 0.3, 1e-9);
    EXPECT_NEAR(table(0.2)[0], 2.0 / 3 * (std::pow(0.3, 1.5) - std::pow(0.1, 1.5)), 1e-15);

    end = 1;
    ASSERT_EQ(table.build([](double T) { return std::array{std::sqrt(-1 - T)}; }, end),
              Status::outside_domain);
    EXPECT_EQ(end, 0);
}

} // namespace resonform
