// SPDX-License-Identifier: GPL-3.0-or-later
// Layers are found to the last digits, in every real type, between samples too.
#include "runtime/float128.hpp"
#include "runtime/layer.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>

#include <array>

namespace resonform {

namespace {

template <class Real> class Layer : public ::testing::Test {};
using Reals = ::testing::Types<double, long double, Float128, boost::multiprecision::cpp_bin_float_50>;
TYPED_TEST_SUITE(Layer, Reals);

} // namespace

TYPED_TEST(Layer, IsEnteredWhereTheMarginVanishes) {
    using Real = TypeParam;
    Real reach(1);
    const auto margins = [](const Real& T) {
        return std::array<Real, 2>{(T - Real(3) / Real(4)) * (T - Real(3) / Real(4)) - Real(1) / Real(16),
                                   Real(2) - T};
    };
    const Cause entered = clear_of_layers(margins, std::array{"A", "B"}, reach);
    EXPECT_EQ(entered.status, Status::outside_domain);
    EXPECT_STREQ(entered.quantity, "A");
    EXPECT_LT(math::magnitude(Real(reach - Real(1) / Real(2))), Real(1e-15));
    EXPECT_LE(reach, Real(1) / Real(2));
}

// (T - 0.3)^2 < 1e-14: two samples are 4e-3 apart.
TYPED_TEST(Layer, IsFoundBetweenSamples) {
    using Real = TypeParam;
    Real reach(1);
    const Real middle = Real(3) / Real(10);
    const auto margins = [&](const Real& T) {
        return std::array<Real, 1>{(T - middle) * (T - middle) - Real(1e-14)};
    };
    EXPECT_EQ(clear_of_layers(margins, std::array{"D"}, reach).status, Status::outside_domain);
    EXPECT_LT(math::magnitude(Real(reach - middle + Real(1e-7))), Real(1e-9));
}

TYPED_TEST(Layer, NeverEnteredLeavesTheIntervalAsItIs) {
    using Real = TypeParam;
    Real reach(1);
    const auto margins = [](const Real& T) {
        return std::array<Real, 1>{(T - Real(1) / Real(3)) * (T - Real(1) / Real(3)) + Real(1e-12)};
    };
    EXPECT_EQ(clear_of_layers(margins, std::array{"D"}, reach).status, Status::ok);
    EXPECT_EQ(reach, Real(1));
}

TYPED_TEST(Layer, AtTheStartNothingIsLeft) {
    using Real = TypeParam;
    Real reach(1);
    const auto inside = [](const Real& T) { return std::array<Real, 1>{T - Real(1)}; };
    EXPECT_EQ(clear_of_layers(inside, std::array{"D"}, reach).status, Status::outside_domain);
    EXPECT_EQ(reach, Real(0));
    Real other(1);
    const auto none = [](const Real&) { return std::array<Real, 1>{math::not_a_number<Real>()}; };
    EXPECT_EQ(clear_of_layers(none, std::array{"D"}, other).status, Status::outside_domain);
    EXPECT_EQ(other, Real(0));
}

// Whatever is clear beyond doubt is > 0 everywhere; what is far from zero is clear.
TEST(Layer, ClearBeyondDoubtIsClear) {
    int clear = 0, inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const double c = 0.8 + 0.0001 * i, w = 0.3 * (i % 40), shift = 0.7 * (i % 9);
        const auto margins = [&](double T) { return std::array{2.0, c + std::sin(w * T + shift)}; };
        double least = 2;
        for (int k = 0; k <= 400; ++k) least = std::min(least, margins(k / 400.0)[1]);
        const bool found = clear_beyond_doubt(margins, 0.0, 1.0);
        if (found) {
            EXPECT_GT(least, 0) << c << ' ' << w << ' ' << shift;
        }
        clear += found ? 1 : 0;
        inside += least > 0 ? 0 : 1;
    }
    EXPECT_GT(clear, 1000);
    EXPECT_GT(inside, 1000);
    EXPECT_TRUE(clear_beyond_doubt([](double T) { return std::array{1.0 - 0.3 * T}; }, 0.0, 1.0));
    EXPECT_FALSE(clear_beyond_doubt([](double) { return std::array{std::nan("")}; }, 0.0, 1.0));
}

} // namespace resonform
