// SPDX-License-Identifier: GPL-3.0-or-later
// Twice<double> against 100 digits: arithmetic and every elementary function, at seeded random points.
#include "runtime/twice.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace resonform {

namespace {

using Number = Twice<double>;
using Hundred = boost::multiprecision::cpp_bin_float_100;

Hundred exact(const Number& x) { return Hundred(x.high) + Hundred(x.low); }

// |found - expected| relative to max(|expected|, floor)
void expect_close(const Number& found, const Hundred& expected, double floor, const char* what) {
    const Hundred size = std::max(Hundred(abs(expected)), Hundred(floor));
    EXPECT_LT(static_cast<double>(Hundred(abs(exact(found) - expected)) / size), 5e-30) << what;
}

class TwiceDouble : public ::testing::Test {
protected:
    Number random(double low, double high) {
        std::uniform_real_distribution<double> d(low, high);
        const double x = d(generator_);
        return Number::sum(x, x * 1e-17 * d(generator_));
    }

private:
    std::mt19937_64 generator_{20261121};
};

} // namespace

TEST_F(TwiceDouble, ArithmeticHas30Digits) {
    for (int i = 0; i < 200; ++i) {
        const Number a = random(-9, 9), b = random(-9, 9);
        expect_close(a + b, exact(a) + exact(b), 1, "+");
        expect_close(a - b, exact(a) - exact(b), 1, "-");
        expect_close(a * b, exact(a) * exact(b), 0, "*");
        expect_close(a / b, exact(a) / exact(b), 0, "/");
    }
}

TEST_F(TwiceDouble, FunctionsHave29Digits) {
    for (int i = 0; i < 50; ++i) {
        const Number x = random(0.01, 8), y = random(-8, 8);
        expect_close(sqrt(x), sqrt(exact(x)), 0, "sqrt");
        expect_close(math::root(x, 3), cbrt(exact(x)), 0, "root");
        expect_close(exp(y), exp(exact(y)), 0, "exp");
        expect_close(expm1(y), expm1(exact(y)), 0, "expm1");
        expect_close(expm1(y * Number(1e-9)), expm1(exact(y * Number(1e-9))), 0, "expm1");
        expect_close(log(x), log(exact(x)), 1, "log");
        expect_close(log1p(x), log1p(exact(x)), 0, "log1p");
        expect_close(log1p(y * Number(1e-9)), log1p(exact(y * Number(1e-9))), 0, "log1p");
        expect_close(asinh(y), asinh(exact(y)), 1, "asinh");
        expect_close(sinh(y), sinh(exact(y)), 1, "sinh");
        expect_close(sinh(x * Number(1e-9)), sinh(exact(x * Number(1e-9))), 0, "sinh");
        expect_close(math::erf(y), boost::math::erf(exact(y)), 0, "erf");
        expect_close(math::erf(x * Number(1e-9)), boost::math::erf(exact(x * Number(1e-9))), 0, "erf");
        expect_close(sin(y), sin(exact(y)), 1, "sin");
        expect_close(cos(y), cos(exact(y)), 1, "cos");
        expect_close(atan2(y, x), atan2(exact(y), exact(x)), 1, "atan2");
        expect_close(hypot(y, x), sqrt(exact(x) * exact(x) + exact(y) * exact(y)), 0, "hypot");
    }
}

TEST(Pi, IsPiInEveryType) {
    const Hundred pi = boost::math::constants::pi<Hundred>();
    EXPECT_EQ(math::pi<double>(), static_cast<double>(pi));
    EXPECT_EQ(math::pi<long double>(), static_cast<long double>(pi));
    expect_close(math::pi<Number>(), pi, 0, "pi");
    EXPECT_LT(static_cast<double>(Hundred(abs(math::pi<Hundred>() - pi))), 1e-99);
    using Longer = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>>;
    const Longer long_pi = boost::math::constants::pi<Longer>();
    EXPECT_LT(Longer(abs(math::pi<Longer>() - long_pi)), Longer("1e-298"));
    const Twice<Hundred> twice = math::pi<Twice<Hundred>>();
    EXPECT_LT(Longer(abs(Longer(twice.high) + Longer(twice.low) - long_pi)), Longer("1e-198"));
}

// Expression templates would add (b - part) as b, then -part.
TEST(TwiceOfTemplates, LeavesNothingOfASumOrProduct) {
    using Real =
        boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_on>;
    std::mt19937_64 generator(11);
    const auto drawn = [&] {
        return Real(Real(generator()) + Real(generator()) * Real(0x1p-64) +
                    Real(generator()) * Real(0x1p-128));
    };
    for (int k = 0; k < 100; ++k) {
        const Real a = drawn() * Real(0x1p-40), b = drawn();
        const auto sum = Twice<Real>::sum(a, b), sorted = Twice<Real>::sorted_sum(b, a);
        const auto product = Twice<Real>::product(a, b);
        using Wide = boost::multiprecision::cpp_bin_float_100;
        EXPECT_EQ(Wide(sum.high) + Wide(sum.low), Wide(a) + Wide(b));
        EXPECT_EQ(Wide(sorted.high) + Wide(sorted.low), Wide(a) + Wide(b));
        EXPECT_EQ(Wide(Wide(product.high) + Wide(product.low) - Wide(a) * Wide(b)), Wide(0));
    }
}

} // namespace resonform
