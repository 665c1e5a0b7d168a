// SPDX-License-Identifier: GPL-3.0-or-later
// Constants made of roots, wherever they are divided by: each equation gives the normal form that it gives
// with its constants rationalised by hand.
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace resonform {
namespace {

struct Pair {
    const char* written;
    const char* rationalised;
};

std::ostream& operator<<(std::ostream& out, const Pair& pair) { return out << pair.written; }

class AlgebraicConstants : public ::testing::TestWithParam<Pair> {};

std::string system_of(const std::string& equation) {
    return test::oscillator_file("x'' + x = " + equation,
                                 "tau = { role = \"slow\" }\nd = { role = \"drift\" }\n",
                                 "tau = \"tau' = eps*(" + equation + ")\"\nd = \"d' = " + equation + "\"\n",
                                 "a = { positive = true }\nb = { positive = true }\n");
}

// In the rate of a fast, a slow and a drift variable.
TEST_P(AlgebraicConstants, AreDividedBy) {
    test::expect_same(test::certified(test::field_from(system_of(GetParam().written)), 3),
                      test::certified(test::field_from(system_of(GetParam().rationalised)), 3));
}

INSTANTIATE_TEST_SUITE_P(
    All, AlgebraicConstants,
    ::testing::Values(
        Pair{"x^2*(1 + sqrt(2) + x)/(1 + sqrt(2) + eps)",
             "x^2*(1 + (sqrt(2) - 1)*x)/(1 + (sqrt(2) - 1)*eps)"},
        Pair{"x^2/(x + 1 - sqrt(2))", "-x^2*(1 + sqrt(2))/(1 - (1 + sqrt(2))*x)"},
        Pair{"x^2/(sqrt(2) + sqrt(3) + x)^2", "x^2*(sqrt(3) - sqrt(2))^2/(1 + (sqrt(3) - sqrt(2))*x)^2"},
        Pair{"sqrt(5)*x^2/(1 + sqrt(2) + sqrt(3) + sqrt(5)*x)",
             "sqrt(5)*x^2*(2 + sqrt(2) - sqrt(6))/(4 + (2 + sqrt(2) - sqrt(6))*sqrt(5)*x)"},
        Pair{"x^2/(1 + 2^(1/3) - x)", "x^2*(1 - 2^(1/3) + 4^(1/3))/(3 - (1 - 2^(1/3) + 4^(1/3))*x)"},
        Pair{"x^2/(sqrt(1 + sqrt(2)) - 1 + x)",
             "x^2*(sqrt(1 + sqrt(2)) + 1)/(sqrt(2) + (sqrt(1 + sqrt(2)) + 1)*x)"},
        Pair{"x^2/(a + a*sqrt(2) + x)", "x^2*(sqrt(2) - 1)/(a + (sqrt(2) - 1)*x)"},
        Pair{"x^2/((1 + sqrt(2))*(a + b) + x)", "x^2*(sqrt(2) - 1)/(a + b + (sqrt(2) - 1)*x)"},
        Pair{"x^2*sqrt((a + x)/(3 + 3*sqrt(2))^4)", "x^2*sqrt(a + x)*(3 - 2*sqrt(2))/9"}));

// Of the frequency and of divisors: exact Hopf points.
TEST(AlgebraicConstants, OfModes) {
    const auto hopf = [](const std::string& quotient) {
        return test::field_from("[system]\nname = \"hopf\"\n[variables]\nx = { role = \"fast\" }\n"
                                "y = { role = \"fast\" }\n[equations]\nx = \"x' = " +
                                quotient + "\"\ny = \"y' = -x\"\n");
    };
    test::expect_same(test::certified(hopf("y*(1 + sqrt(2) + y)/(1 + sqrt(2) + x)")),
                      test::certified(hopf("y*(1 + (sqrt(2) - 1)*y)/(1 + (sqrt(2) - 1)*x)")));
    const auto field = hopf("y*(2 + 3*sqrt(5) + y)/(4 - sqrt(5) + x)");
    test::certified(field);
    const Polynomial& omega = field->modes[0].omega;
    EXPECT_TRUE(field->ring->vanishes(field->ring->multiply(omega, omega) -
                                      test::coefficient(*field, "(23 + 14*sqrt(5))/11")));
}

TEST(AlgebraicConstants, UnderRoots) {
    for (const char* equation : {"x^2*sqrt(1 + sqrt(2) + x)", "x^2/(sqrt(2) + sqrt(3) + x)^(2/3)",
                                 "x^2*sqrt((1 + sqrt(2))*(a + x))", "x^2*sqrt(a/(1 + sqrt(2))^3 + b*x)"})
        test::certified(test::field_from(system_of(equation)), 3);
    test::certified(
        test::field_from(test::oscillator_file("x'' + (sqrt(2)*a - a)/(b*(1 + sqrt(2)))*x + x^2 = 0", "", "",
                                               "a = { positive = true }\nb = { positive = true }\n")),
        3);
}

// 3045424721 is a prime beyond trial division.
TEST(AlgebraicConstants, RootsOfPowersOfALargePrime) {
    test::certified(test::field_from(test::oscillator_file(
                        "x'' + x + sqrt(9274611731277927841*7)*x^2 + sqrt(3045424721)*x^3 = 0")),
                    3);
    const auto field = test::field_from(test::oscillator_file("x'' + x + 9274611731277927841^(3/4)*x^3 = 0"));
    EXPECT_EQ(test::coefficient(*field, "9274611731277927841^(3/4)"),
              test::coefficient(*field, "3045424721*sqrt(3045424721)"));
}

// A root that depends on another one has no ring, and is shown where it stands.
TEST(AlgebraicConstants, DependentRootsAreShown) {
    const auto field =
        test::field_from(test::oscillator_file("x'' + x + x^2*sqrt(3 + 2*sqrt(2)) = sqrt(2)*x^3"));
    const Error error = test::error_when([&] { test::certified(field, 2); });
    EXPECT_EQ(error.diagnostic().rule, "the roots of the ring are independent of each other");
    EXPECT_EQ(error.diagnostic().place.key, "equations.x");
    EXPECT_GT(error.diagnostic().place.column, 0);
}

} // namespace
} // namespace resonform
