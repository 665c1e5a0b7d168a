// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/decimal.hpp"

#include <gtest/gtest.h>

namespace resonform {

TEST(Decimal, IsRoundedToSignificantDigits) {
    EXPECT_EQ(decimal(Rational(2) / 3, 6), "0.666667");
    EXPECT_EQ(decimal(Rational(1) / 2, 6), "0.5");
    EXPECT_EQ(decimal(Rational(2), 6), "2");
    EXPECT_EQ(decimal(Rational(0), 6), "0");
    EXPECT_EQ(decimal(Rational(120), 6), "120");
    EXPECT_EQ(decimal(Rational(1) / 3, 1), "0.3");
    EXPECT_EQ(decimal(Rational(1234567) / 1000, 6), "1234.57");
    EXPECT_EQ(decimal(1 - power_of_ten(-30), 6), "1.00000"); // not 1: six digits are what is known
    EXPECT_EQ(decimal(power_of_ten(-5), 4), "0.00001");
}

TEST(Decimal, HasAnExponentWhereZerosWouldHideIt) {
    EXPECT_EQ(decimal(Rational(1) / 30000000, 6), "3.33333e-8");
    EXPECT_EQ(decimal(power_of_ten(6), 6), "1e6");
    EXPECT_EQ(decimal(power_of_ten(5), 6), "100000");
    EXPECT_EQ(decimal_latex(Rational(1) / 30000000, 3), "3.33\\cdot 10^{-8}");
    EXPECT_EQ(decimal_latex(Rational(3) / 4, 3), "0.75");
}

} // namespace resonform
