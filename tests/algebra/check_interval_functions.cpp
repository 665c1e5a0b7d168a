// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals of functions hold the values that the library of C++ gives, and are narrow.
#include "algebra/ring/interval_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

struct FunctionCase {
    const char* name;
    Function function;
    double (*value)(double);
};

class Intervals : public ::testing::TestWithParam<FunctionCase> {};

TEST_P(Intervals, HoldTheValue) {
    for (int k = -40; k <= 40; ++k) {
        const Rational x = Rational(k * k * k) / 1000;
        if (GetParam().function == Function::logarithm && k <= 0) continue;
        for (const int bits : {64, 200}) {
            const auto here = function(GetParam().function, Interval(x), bits);
            ASSERT_TRUE(here) << k;
            const double exact = GetParam().value(cln::double_approx(x));
            const double low = cln::double_approx(here->low), high = cln::double_approx(here->high);
            const double slack = 1e-12 * (1 + std::abs(exact));
            EXPECT_LE(low, exact + slack) << GetParam().name << ' ' << k;
            EXPECT_GE(high, exact - slack) << GetParam().name << ' ' << k;
            const Rational width = here->high - here->low, unit = cln::expt(Rational(2), Integer(-bits + 1));
            const Rational scale = cln::abs(here->high) + 1;
            EXPECT_TRUE(width < unit * scale) << GetParam().name << ' ' << k << ' ' << bits;
        }
    }
}

// f(u) holds f(x) for points x of u.
TEST_P(Intervals, HoldWholeIntervals) {
    const Interval u(Rational(3) / 10, Rational(1) / 2);
    const auto whole = function(GetParam().function, u, 64);
    ASSERT_TRUE(whole);
    for (int k = 0; k <= 10; ++k) {
        const auto part = function(GetParam().function, Interval(Rational(30 + 2 * k) / 100), 64);
        EXPECT_TRUE(whole->low <= part->high && part->low <= whole->high) << k;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Intervals,
                         ::testing::Values(FunctionCase{"exp", Function::exponential, std::exp},
                                           FunctionCase{"sin", Function::sine, std::sin},
                                           FunctionCase{"cos", Function::cosine, std::cos},
                                           FunctionCase{"log", Function::logarithm, std::log},
                                           FunctionCase{"atan", Function::arc_tangent, std::atan}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Interval, OutsideTheDomain) {
    EXPECT_FALSE(function(Function::logarithm, Interval(Rational(0)), 64));
    EXPECT_FALSE(function(Function::logarithm, Interval(Rational(-1), Rational(1)), 64));
    EXPECT_FALSE(function(Function::exponential, Interval(Rational(100000)), 64));
}

} // namespace
} // namespace resonform
