// SPDX-License-Identifier: GPL-3.0-or-later
// Systems that cannot be expanded: each with one message that names the rule, the value and the mend.
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

// One fast variable x, a slow tau, the equation of x as given.
std::string system_with(const std::string& equation, const std::string& extra = "") {
    return "[system]\nname = \"s\"\n[parameters]\ng = { positive = true }\na = {}\n[variables]\n"
           "x = { role = \"fast\" }\ntau = { role = \"slow\" }\n" +
           extra + "[equations]\nx = \"" + equation + "\"\ntau = \"tau' = eps\"\n";
}

std::string message(const std::string& toml, Kind kind) {
    try {
        expand(test::first_order_from(toml));
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), kind) << e.what();
        EXPECT_LE(std::string(e.what()).size(), 2048U);
        EXPECT_FALSE(e.diagnostic().mend.empty());
        return e.what();
    }
    ADD_FAILURE() << "accepted:\n" << toml;
    return "";
}

::testing::AssertionResult has(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

} // namespace

TEST(ExpandErrors, DampingAtWeightZero) {
    const std::string m = message(system_with("x'' + 2*x' + x = 0"), Kind::refused);
    EXPECT_TRUE(has(m, "the linear part of a fast variable is an oscillator without damping"));
    EXPECT_TRUE(has(m, "the coefficient of x' is -2"));
    EXPECT_TRUE(has(m, "test/system.toml"));
}

TEST(ExpandErrors, NoLinearPart) {
    EXPECT_TRUE(has(message(system_with("x'' + x^3 = 0"), Kind::bad_input), "x'' has no term linear in x"));
}

TEST(ExpandErrors, ForceAtTheOrigin) {
    const std::string m = message(system_with("x'' + x - g = 0"), Kind::bad_input);
    EXPECT_TRUE(has(m, "x'' = g there"));
    EXPECT_TRUE(has(m, "shift x to the equilibrium"));
}

TEST(ExpandErrors, FrequencyNotProvedPositive) {
    EXPECT_TRUE(has(message(system_with("x'' + (1 + tau)*x = 0"), Kind::refused), "omega^2 = 1 + tau for x"));
    EXPECT_TRUE(
        has(message(system_with("x'' + tau*x = 0"), Kind::refused), "tau = { positive = true, ... }"));
    EXPECT_TRUE(has(message(system_with("x'' - g*x = 0"), Kind::bad_input), "omega^2 = -g for x"));
    EXPECT_NO_THROW(expand(test::first_order_from(
        system_with("x'' + (1 + tau)*x = 0", "[domain]\npositive = [\"1 + tau\"]\n"))));
    for (const std::string declared : {"tau", "1 + tau + a"})
        EXPECT_NO_THROW(expand(test::first_order_from(
            system_with("x'' + (" + declared + ")*x = 0", "[domain]\npositive = [\"" + declared + "\"]\n"))))
            << declared;
}

TEST(ExpandErrors, DivisionByZero) {
    EXPECT_TRUE(has(message(system_with("x'' + x + eps/x = 0"), Kind::bad_input),
                    "divided by an expression that is zero"));
    EXPECT_TRUE(has(message(system_with("x'' + x + eps*x/(x - eps) = 0"), Kind::bad_input),
                    "divided by an expression that is zero"));
}

TEST(ExpandErrors, DivisionByWhatIsNotProvedNonZero) {
    const std::string m = message(system_with("x'' + x + eps*x/a = 0"), Kind::refused);
    EXPECT_TRUE(has(m, "nothing is divided by an expression that is not proved to be non-zero"));
    EXPECT_TRUE(has(m, "nonzero = true"));
}

TEST(ExpandErrors, FunctionsOfSlowVariables) {
    EXPECT_TRUE(has(message(system_with("x'' + x + eps*sin(tau)*x = 0"), Kind::refused), "sin(tau)"));
    EXPECT_TRUE(has(message(system_with("x'' + x + eps*sin(x + tau) = 0"), Kind::refused),
                    "the argument of sin vanishes at the origin"));
}

TEST(ExpandErrors, FirstOrderFastVariable) {
    EXPECT_TRUE(has(message(system_with("x' + x = 0"), Kind::bad_input), "x has order 1"));
}

TEST(ExpandErrors, ModesKeepTheirNames) {
    const std::string toml =
        "[system]\nname = \"s\"\n[parameters]\nz1 = {}\n[variables]\nx = { role = \"fast\" }\n"
        "[equations]\nx = \"x'' + x + eps*z1*x^2 = 0\"\n";
    EXPECT_TRUE(has(message(toml, Kind::bad_input), "reserved are I, pi, E, eps, lambda, t, z1, z2, ..."));
}

TEST(ExpandErrors, SlowAndDriftRatesVanishWithEps) {
    const std::string slow =
        "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
        "[equations]\nx = \"x'' + x = 0\"\ntau = \"tau' = 1\"\n";
    EXPECT_TRUE(has(message(slow, Kind::bad_input), "tau' = 1"));
    const std::string driven =
        "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
        "[equations]\nx = \"x'' + x = 0\"\ntau = \"tau' = eps*x\"\n";
    EXPECT_TRUE(has(message(driven, Kind::refused), "the rate of tau contains x"));
    const std::string drift =
        "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"drift\" }\n"
        "[equations]\nx = \"x'' + x + eps*y*x = 0\"\ny = \"y' = eps\"\n";
    EXPECT_TRUE(has(message(drift, Kind::bad_input), "the equation of x contains y"));
}

} // namespace resonform
