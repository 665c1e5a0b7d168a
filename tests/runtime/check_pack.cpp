// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of several doubles side by side, and bounds over an interval.
#include "runtime/bounds.hpp"
#include "runtime/layer.hpp"
#include "runtime/pack.hpp"
#include "runtime/pack_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace resonform {
namespace {

using kernel::Pack;

// The largest error of a function of packs, in units of the last place of double, at random arguments of all
// sizes from 2^least to 2^most.
template <class Packs, class Exact>
double largest_error(const Packs& packs, const Exact& exact, double least, double most, bool signs) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(least, most);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = std::exp2(exponent(random)) * (signs && i % 2 == 1 ? -1 : 1);
        Pack all(0.5); // a lane does not see its neighbours
        const std::size_t lane = static_cast<std::size_t>(i) % kernel::pack_lanes;
        all.set(lane, x);
        const long double wanted = exact(static_cast<long double>(x));
        const long double error = std::fabs((packs(all)[lane] - wanted) / wanted);
        worst = std::max(worst, static_cast<double>(error) * 0x1p52);
    }
    return worst;
}

TEST(Packs, FunctionsAreRightButForALastBit) {
    const auto root = [](const Pack& x) { return kernel::sqrt(x); };
    EXPECT_LT(largest_error(
                  root, [](long double x) { return std::sqrt(x); }, -900, 900, false),
              0.8);
    const auto per = [](const Pack& x) { return kernel::reciprocal(x); };
    EXPECT_LT(largest_error(
                  per, [](long double x) { return 1 / x; }, -900, 900, true),
              1);
    const auto log = [](const Pack& x) { return kernel::log(x); };
    EXPECT_LT(largest_error(
                  log, [](long double x) { return std::log(x); }, -900, 900, false),
              1.5);
    const auto log1p = [](const Pack& x) { return kernel::log1p(x); };
    EXPECT_LT(largest_error(
                  log1p, [](long double x) { return std::log1p(x); }, -900, 900, false),
              1.5);
    EXPECT_LT(largest_error(
                  log1p, [](long double x) { return std::log1p(x); }, -900, -0.01, true),
              1.5);
    const auto asinh = [](const Pack& x) { return kernel::asinh(x); };
    EXPECT_LT(largest_error(
                  asinh, [](long double x) { return std::asinh(x); }, -500, 400, true),
              2);
}

TEST(Packs, WhatHasNoLogarithmIsNotANumber) {
    for (const double x : {0.0, -1.0, double(INFINITY), double(NAN)}) {
        EXPECT_TRUE(std::isnan(kernel::log(Pack(x))[0]));
        EXPECT_TRUE(std::isnan(kernel::log1p(Pack(x - 1))[0]));
    }
    EXPECT_EQ(kernel::log1p(Pack(0))[0], 0);
    EXPECT_EQ(kernel::asinh(Pack(0))[0], 0);
}

// Residuals of pairs come from one operation each.
TEST(Packs, PairsHaveTwiceTheDigitsButAFew) {
    const kernel::PackPair x = kernel::PackPair(Pack(2)) / kernel::PackPair(Pack(3));
    const kernel::PackPair root = kernel::sqrt(x), one = root * root / x;
    EXPECT_LT(std::fabs((one - kernel::PackPair(Pack(1))).high[0]), 0x1p-78);
    const kernel::PackPair product = kernel::reciprocal(x) * x;
    EXPECT_LT(std::fabs((product - kernel::PackPair(Pack(1))).high[0]), 0x1p-98);
    const kernel::PackPair sum = added_product(x, x, x) - (x + x * x);
    EXPECT_LT(std::fabs(sum.high[0]), 0x1p-98);
}

template <class Number> Number wavy(const Number& x) {
    const Number s = x * x + Number(1);
    return sqrt(s) * per(s) - Number(0.25) * x * cos(x) + magnitude(x - Number(0.5)) * exp(-x);
}

TEST(BoundsOver, EnclosesWhatAFunctionTakesOn) {
    using math::cos;
    using math::exp;
    using math::magnitude;
    using math::per;
    using math::sqrt;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(-2, 2);
    for (int i = 0; i < 300; ++i) {
        const auto [left, right] = std::minmax({place(random), place(random)});
        const Bounds<double> all = wavy(Bounds<double>(left, right));
        double least = 1e300;
        for (int k = 0; k <= 50; ++k) {
            const double x = left + (right - left) * k / 50, s = x * x + 1;
            least = std::min(least, sqrt(s) / s - 0.25 * x * cos(x) + magnitude(x - 0.5) * exp(-x));
        }
        EXPECT_FALSE((all - Bounds<double>(least + 1e-12)).is_positive());
        EXPECT_TRUE((all + Bounds<double>(100)).is_positive());
    }
}

TEST(BoundsOver, ANumberTimesItselfIsASquare) {
    const Bounds<double> x(-1, 2);
    EXPECT_TRUE((x * x + Bounds<double>(0.5)).is_positive());
    const Bounds<double> other = x;
    EXPECT_FALSE((x * other + Bounds<double>(0.5)).is_positive());
}

// Where a function is not defined, nothing is positive: in whatever order it enters sums and products.
TEST(BoundsOver, WhatIsNotDefinedStaysSo) {
    const Bounds<double> through(-1, 1), above(1, 2);
    for (const Bounds<double>& bad : {per(through), sqrt(through), per(Bounds<double>(0))}) {
        for (const Bounds<double>& all :
             {bad, bad + above, above - bad, bad * above, above * bad, magnitude(bad), bad * bad, 2.0 * bad,
              -1.0 * bad, hypot(above, bad), exp(bad), cos(bad) + above, Bounds<double>(0) * bad,
              magnitude(bad) * above, Bounds<double>(0, 1) * bad, Bounds<double>(-1, 1) * bad})
            EXPECT_FALSE((all + Bounds<double>(10)).is_positive());
    }
}

// Each lane as if it were alone.
TEST(BoundsOver, LaneByLane) {
    Pack left(1), right(2);
    left.set(0, -1);
    const kernel::Mask clear = (per(Bounds<Pack>(left, right)) * Bounds<Pack>(left, right)).is_positive();
    EXPECT_FALSE(clear[0]);
    for (std::size_t j = 1; j < kernel::pack_lanes; ++j) EXPECT_TRUE(clear[j]);
}

struct Line { // with a margin of 1 - slope T
    double slope;
    template <class Number> [[nodiscard]] std::array<Number, 1> margins(const Number& T) const {
        return {Number(1) - slope * T};
    }
};

TEST(BoundsOver, MarginsOfACourse) {
    EXPECT_TRUE(clear_of_doubt(Line{0.9}, 1.0));
    EXPECT_FALSE(clear_of_doubt(Line{1.1}, 1.0));
    EXPECT_FALSE(clear_of_doubt(Line{std::numeric_limits<double>::quiet_NaN()}, 1.0));
}

} // namespace
} // namespace resonform
