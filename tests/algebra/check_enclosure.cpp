// SPDX-License-Identifier: GPL-3.0-or-later
// Balls of functions hold the values that the library of C++ gives, and are narrow.
#include "algebra/ring/enclosure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

struct FunctionCase {
    const char* name;
    Function function;
    double (*value)(double);
};

class Enclosures : public ::testing::TestWithParam<FunctionCase> {};

TEST_P(Enclosures, HoldTheValue) {
    for (int k = -40; k <= 40; ++k) {
        const Rational x = Rational(k * k * k) / 1000;
        if (GetParam().function == Function::logarithm && k <= 0) continue;
        for (const int bits : {64, 200}) {
            const RealBall here = enclose(GetParam().function, RealBall(x, bits + 40), bits);
            ASSERT_TRUE(here.is_finite()) << k;
            const double exact = GetParam().value(cln::double_approx(x));
            const double value = nearest_double(here), radius = mag_get_d(arb_radref(here.get()));
            const double slack = 1e-12 * (1 + std::abs(exact));
            EXPECT_LE(value - radius, exact + slack) << GetParam().name << ' ' << k;
            EXPECT_GE(value + radius, exact - slack) << GetParam().name << ' ' << k;
            EXPECT_LT(2 * radius, std::ldexp(std::abs(value) + 1, -bits + 2)) << k << ' ' << bits;
        }
    }
}

// f(u) holds f(x) for points x of u.
TEST_P(Enclosures, HoldWholeIntervals) {
    RealBall u(Rational(4) / 10, 64);
    arb_add_error(u.get(), RealBall(Rational(1) / 10, 64).get());
    const RealBall whole = enclose(GetParam().function, u, 64);
    ASSERT_TRUE(whole.is_finite());
    for (int k = 0; k <= 10; ++k)
        EXPECT_TRUE(
            whole.overlaps(enclose(GetParam().function, RealBall(Rational(30 + 2 * k) / 100, 64), 64)))
            << k;
}

INSTANTIATE_TEST_SUITE_P(All, Enclosures,
                         ::testing::Values(FunctionCase{"exp", Function::exponential, std::exp},
                                           FunctionCase{"sin", Function::sine, std::sin},
                                           FunctionCase{"cos", Function::cosine, std::cos},
                                           FunctionCase{"log", Function::logarithm, std::log},
                                           FunctionCase{"atan", Function::arc_tangent, std::atan}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Enclosure, OutsideTheDomain) {
    RealBall around_zero;
    arb_add_error(around_zero.get(), RealBall(1).get());
    EXPECT_FALSE(enclose(Function::logarithm, RealBall(), 64).is_finite());
    EXPECT_FALSE(enclose(Function::logarithm, around_zero, 64).is_finite());
    EXPECT_FALSE(enclose(Function::logarithm, RealBall(-1), 64).is_finite());
    const RealBall large = enclose(Function::exponential, RealBall(100000), 64); // no longer too large
    EXPECT_TRUE(large.is_positive());
    EXPECT_FALSE(enclose(Function::exponential, large, 64).is_finite());
}

} // namespace
} // namespace resonform
