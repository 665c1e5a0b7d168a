// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers from text, their roots, and the wording of refusals.
#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace resonform {
namespace {

Rational fraction(int numerator, int denominator) { return Rational(numerator) / Rational(denominator); }

std::string refusal(const std::string& text) {
    try {
        (void)parse_rational(text);
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::bad_input);
        return e.diagnostic().rule;
    }
    return "accepted";
}

TEST(Number, ReadsWhatItSpells) {
    EXPECT_EQ(parse_rational("12"), 12);
    EXPECT_EQ(parse_rational("-3/4"), fraction(-3, 4));
    EXPECT_EQ(parse_rational("+6/8"), fraction(3, 4));
    EXPECT_EQ(parse_rational("0.25"), fraction(1, 4));
    EXPECT_EQ(parse_rational(".5"), fraction(1, 2));
    EXPECT_EQ(parse_rational("5."), 5);
    EXPECT_EQ(parse_rational("1.5e-3"), fraction(3, 2000));
    EXPECT_EQ(parse_rational("-1.5E+3"), -1500);
    EXPECT_EQ(parse_rational("0.1"), fraction(1, 10)); // not the double
    EXPECT_EQ(parse_rational("007"), 7);
    EXPECT_EQ(parse_rational("-0"), 0);
    EXPECT_EQ(parse_rational("1e0004"), 10000);
    EXPECT_EQ(parse_rational("1e4000"), cln::expt(Rational(10), Integer(4000)));
}

TEST(Number, RefusesAnythingElse) {
    const std::string form =
        "not a number: it must be an integer, a fraction or a decimal, as 12, -3/4, 0.25, 1.5e-3";
    for (const char* text :
         {"",      "-",     ".",     "e5",  "1e",    "1e+",  "x",     "1 ",  " 1",  "1/",   "/2",
          "1/2/3", "1.5/2", "1/2e3", "--1", "1e5.5", "0x10", "1_000", "nan", "inf", "1.2.3"}) {
        EXPECT_EQ(refusal(text), form) << text;
    }
    EXPECT_EQ(refusal("1/0"), "the denominator of the fraction is zero");
}

TEST(Number, RefusesWhatIsTooLong) {
    const std::string size =
        "the number has more than 4000 digits, or a decimal exponent beyond -4000 ... 4000";
    EXPECT_EQ(refusal("1e999999999"), size);
    EXPECT_EQ(refusal("1e-4001"), size);
    EXPECT_EQ(refusal("1e99999999999999999999999999"), size);
    EXPECT_EQ(refusal(std::string(4001, '7')), size);
    EXPECT_EQ(refusal("0." + std::string(4000, '7')), size);
    EXPECT_EQ(refusal(std::string(1000000, '7')), size);
    EXPECT_EQ(refusal(std::string(4000, '7')), "accepted");
}

TEST(Number, Prints) {
    EXPECT_EQ(to_string(fraction(-3, 4)), "-3/4");
    EXPECT_EQ(to_string(Rational(5)), "5");
    EXPECT_EQ(to_string(Rational(0)), "0");
}

TEST(Number, BecomesTheNearestDouble) {
    EXPECT_EQ(to_double(fraction(1, 10)), 0.1);
    EXPECT_EQ(to_double(fraction(-1, 3)), -1.0 / 3.0);
    EXPECT_EQ(to_double(parse_rational("1e300")), 1e300);
    EXPECT_EQ(to_double(parse_rational("1e-300")), 1e-300);
    EXPECT_TRUE(std::isinf(to_double(parse_rational("1e400"))));
    EXPECT_EQ(to_double(parse_rational("1e-400")), 0.0);
    EXPECT_EQ(to_double(parse_rational("1e4000") / parse_rational("3e4000")), 1.0 / 3.0);
}

TEST(Number, ExactRoots) {
    Rational root;
    ASSERT_TRUE(exact_root(fraction(9, 4), 2, root));
    EXPECT_EQ(root, fraction(3, 2));
    ASSERT_TRUE(exact_root(fraction(-8, 27), 3, root));
    EXPECT_EQ(root, fraction(-2, 3));
    ASSERT_TRUE(exact_root(0, 5, root));
    EXPECT_EQ(root, 0);
    ASSERT_TRUE(exact_root(7, 1, root));
    EXPECT_EQ(root, 7);
    EXPECT_FALSE(exact_root(2, 2, root));
    EXPECT_FALSE(exact_root(-4, 2, root));
    EXPECT_FALSE(exact_root(fraction(4, 3), 2, root));
    EXPECT_FALSE(exact_root(4, 0, root));
}

} // namespace
} // namespace resonform
