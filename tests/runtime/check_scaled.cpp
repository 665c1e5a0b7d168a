// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers in every real type, and numbers with an exponent of their own, against 400 digits.
#include "algebra/number/binary_parts.hpp"
#include "runtime/scaled.hpp"
#include "runtime/twice.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

namespace mp = boost::multiprecision;
using Exact = mp::number<mp::cpp_bin_float<400>, mp::et_off>;

Exact exact(double x) { return Exact(x); }
Exact exact(long double x) { return Exact(x); }
Exact exact(Float128 x) {
    const double high = static_cast<double>(x), middle = static_cast<double>(x - high);
    return Exact(high) + Exact(middle) + Exact(static_cast<double>(x - high - middle));
}
template <class Real> Exact exact(const Twice<Real>& x) { return exact(x.high) + exact(x.low); }
// Deduced, for clang cannot ask boost whether a Float128 converts to a number.
template <class Backend, mp::expression_template_option option>
Exact exact(const mp::number<Backend, option>& x) {
    return Exact(x);
}
template <class Number> Exact exact(const Scaled<Number>& x) {
    return ldexp(exact(x.mantissa), static_cast<int>(600 * x.exponent));
}
Exact exact(const Rational& x) {
    const auto whole = [](const Integer& n) { return Exact(mp::cpp_int(to_string(Rational(n)))); };
    return whole(cln::numerator(x)) / whole(cln::denominator(x));
}

template <class Real> class EveryReal : public ::testing::Test {
protected:
    // In units of the last place.
    static double distance(const Exact& found, const Exact& expected) {
        const Exact size = expected == 0 ? Exact(1) : Exact(abs(expected));
        const int exponent = static_cast<int>(floor(log2(size)));
        return static_cast<double>(
            Exact(abs(found - expected) / ldexp(Exact(1), exponent + 1 - math::digits<Real>)));
    }
};
using ScaledReals = ::testing::Types<double, long double, Float128, Twice<double>, mp::cpp_bin_float_50,
                                     mp::cpp_bin_float_100>;
TYPED_TEST_SUITE(EveryReal, ScaledReals);

Integer random_integer(std::mt19937_64& random, int bits) {
    Integer n = 0;
    for (int left = bits; left > 0; left -= 32)
        n = n * (Integer(1) << 32) + static_cast<long>(random() >> 32);
    return n + 1;
}

template <class Real> Real number_of(const Rational& value) {
    const BinaryParts binary = binary_parts(value);
    return math::number<Real>(binary.parts, binary.exponent);
}

} // namespace

// Numerators and denominators of up to 5000 bits, quotients within 2^-300 ... 2^300.
TYPED_TEST(EveryReal, HoldsQuotientsOfLongNumbers) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 200; ++i) {
        const int bits = 10 + static_cast<int>(random() % 5000),
                  more = std::max(1, bits + static_cast<int>(random() % 600) - 300);
        Rational value = Rational(random_integer(random, bits)) / random_integer(random, more);
        if (i % 2 == 0) value = -value;
        const TypeParam found = number_of<TypeParam>(value);
        EXPECT_LT(this->distance(exact(found), exact(value)), 0.5001) << bits << "/" << more;
        if constexpr (std::is_same_v<TypeParam, double>) {
            EXPECT_EQ(found, static_cast<double>(exact(value)));
        }
    }
}

// Halfway between two doubles, and a little to either side: what follows the first part must not move it.
TEST(ExactNumber, IsRoundedOnceInDouble) {
    const Rational half = Rational(1) / (Integer(1) << 53), little = Rational(1) / (Integer(1) << 3000);
    const double next = 1 + 0x1p-52;
    EXPECT_EQ(number_of<double>(1 + half), 1);
    EXPECT_EQ(number_of<double>(1 + half + little), next);
    EXPECT_EQ(number_of<double>(1 + 3 * half - little), next);
    EXPECT_EQ(number_of<double>(-1 - half - little), -next);
}

TEST(ExactNumber, HasItsOwnPowerOfTwo) {
    const BinaryParts large = binary_parts(Rational(Integer(1) << 5000) / 3);
    EXPECT_EQ(large.parts.front(), 2.0 / 3);
    EXPECT_EQ(large.exponent, 4999);
    const BinaryParts plain = binary_parts(Rational(1) / 4);
    EXPECT_EQ(plain.parts, std::vector<double>{0.25});
    EXPECT_EQ(plain.exponent, 0);
    EXPECT_TRUE(binary_parts(0).parts.empty());
    EXPECT_EQ(number_of<double>(Rational(1) / (Integer(1) << 1000)), 0x1p-1000);
}

// What leaves the range of a double and comes back.
TYPED_TEST(EveryReal, PowersLeaveTheRangeAndComeBack) {
    using Number = Scaled<TypeParam>;
    for (const double K : {1e8, 3e-9, 1.7e300, 2e-270}) { // of two doubles the lower has its place, too
        const Number x{TypeParam(K)};
        const Number above = math::power(x, 57), below = math::power(x, 56);
        TypeParam value{};
        ASSERT_TRUE((above / below).fits(value)) << K;
        EXPECT_LT(this->distance(exact(value), exact(K)), 128) << K;
        EXPECT_LT(this->distance(exact(above + below), exact(above) + exact(below)), 2) << K;
        EXPECT_LT(this->distance(exact(sqrt(above)), sqrt(exact(above))), 2) << K;
        for (const int k : {3, 7})
            EXPECT_LT(this->distance(exact(math::root(above, k)), pow(exact(above), Exact(1) / k)), 8)
                << K << " " << k;
        EXPECT_LT(this->distance(exact(hypot(above, below)),
                                 sqrt(exact(above) * exact(above) + exact(below) * exact(below))),
                  4);
        EXPECT_EQ(exact(magnitude(-above)), exact(above));
        EXPECT_EQ(exact(magnitude(above)), exact(above));
        EXPECT_LT(this->distance(exact(atan2(above, below)), atan(exact(above) / exact(below))), 8);
        EXPECT_LT(this->distance(exact(log(above)), log(exact(above))), 8);
        EXPECT_LT(this->distance(exact(asinh(-above)), -asinh(exact(above))), 8);
        const Exact slope = 2 / sqrt(boost::math::constants::pi<Exact>());
        EXPECT_LT(this->distance(exact(erf(-above)), K > 1 ? Exact(-1) : Exact(-slope * exact(above))), 8);
        EXPECT_LT(this->distance(exact(log1p(above)), K > 1 ? log(exact(above)) : exact(above)), 8) << K;
        if (K < 1) {
            EXPECT_LT(this->distance(exact(expm1(above)), exact(above)), 2) << K;
            EXPECT_LT(this->distance(exact(sinh(above)), exact(above)), 2) << K;
        }
    }
}

TEST(ScaledDouble, WithinItsRangeEqualsDouble) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> exponent(-80, 80), unit(1, 2);
    for (int i = 0; i < 1000; ++i) {
        const double a = unit(random) * std::pow(10, exponent(random)), b = -unit(random);
        const Scaled<double> x(a), y(b);
        EXPECT_EQ((x * y).value(), a * b);
        EXPECT_EQ((x / y).value(), a / b);
        EXPECT_EQ((x + y).value(), a + b);
        EXPECT_EQ((x - y).value(), a - b);
        EXPECT_EQ(sqrt(x).value(), std::sqrt(a));
        EXPECT_EQ(exp(y).value(), std::exp(b));
        EXPECT_EQ(x > y, a > b);
    }
}

TEST(ScaledDouble, WhatHasNoPlaceIsSaid) {
    double value = 0;
    for (const double x : {1e200, 1e-200}) {
        const Scaled<double> far = Scaled<double>(x) * Scaled<double>(x);
        EXPECT_FALSE(far.fits(value));
        EXPECT_TRUE(std::isnan(far.value()));
        EXPECT_TRUE((far / Scaled<double>(x)).fits(value));
        EXPECT_DOUBLE_EQ(value, x);
    }
    EXPECT_TRUE((Scaled<double>(1e200) - Scaled<double>(1e200)).fits(value)); // zero is zero
    EXPECT_EQ(value, 0);
    EXPECT_FALSE((Scaled<double>(1) / Scaled<double>(0)).fits(value));
    EXPECT_FALSE(exp(Scaled<double>(-1e5)).fits(value));
    EXPECT_TRUE((exp(Scaled<double>(-1e5)) * exp(Scaled<double>(1e5))).fits(value));
    EXPECT_NEAR(value, 1, 1e-9);

    Keeper keep;
    keep(Scaled<double>(2), value, "fine");
    EXPECT_EQ(keep.cause.status, Status::ok);
    keep(Scaled<double>(1e200) * Scaled<double>(1e200), value, "first");
    keep(Scaled<double>(1) / Scaled<double>(0), value, "second");
    EXPECT_EQ(keep.cause.status, Status::overflow);
    EXPECT_STREQ(keep.cause.quantity, "first");
}

// Digits '#' and '$' are 0 and 1: two elements "a", one that is not kept, one "b".
TEST(Scaled, ElementsOfAListAreKeptInRuns) {
    const std::array names{"a", "b"};
    std::array<double, 4> from{1, 2, 3, 4}, to{};
    Keeper keep;
    keep(from, to, names, "##%#%$#$$");
    EXPECT_EQ(to, (std::array<double, 4>{1, 2, 0, 4}));
    EXPECT_EQ(keep.cause.status, Status::ok);
    from[2] = from[3] = HUGE_VAL;
    keep(from, to, names, "##%#%$#$$");
    EXPECT_EQ(keep.cause.status, Status::outside_domain);
    EXPECT_STREQ(keep.cause.quantity, "b");
}

TEST(Scaled, TheFirstElementThatIsNotPositiveIsNamed) {
    const std::array<double, 5> list{-1, 1, 2, 0, -3};
    const Cause cause = first_not_positive(list, 1, std::array{"a", "b", "c", "d"});
    EXPECT_EQ(cause.status, Status::outside_domain);
    EXPECT_STREQ(cause.quantity, "c");
    EXPECT_EQ(first_not_positive(list, 1, std::array{"a", "b"}).status, Status::ok);
}

} // namespace resonform
