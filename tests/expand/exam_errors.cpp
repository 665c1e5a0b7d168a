// SPDX-License-Identifier: GPL-3.0-or-later
// Systems that cannot be expanded: each with one message that names the rule, the value and the hint.
#include "expand/refusal.hpp"
#include "support/error_when.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <set>

namespace resonform {

namespace {

// One fast variable x, a slow tau, the equation of x as given.
std::string system_with(const std::string& equation, const std::string& extra = "") {
    return "[system]\nname = \"s\"\n[parameters]\ng = { positive = true }\na = {}\n[variables]\n"
           "x = { role = \"fast\" }\ntau = { role = \"slow\" }\n" +
           extra + "[equations]\nx = \"" + equation + "\"\ntau = \"tau' = eps\"\n";
}

} // namespace

TEST(ExpandErrors, LinearPartsThatAreNotSemisimple) {
    for (const std::string equation : {"x'' + x^3 = 0", "x'' + 2*x' + x + x^3 = 0", "x'' + g*x^2 = 0"}) {
        const std::string m = test::refusal(system_with(equation), ErrorKind::refused);
        EXPECT_TRUE(test::has(m, "semisimple"));
        EXPECT_TRUE(test::has(m, "inner_product"));
        EXPECT_TRUE(test::has(m, "test/system.toml"));
    }
}

TEST(ExpandErrors, ADoubleEigenvalueIsNamedByItsVariables) {
    const std::string m = test::refusal(
        test::system_text("s", {{"y", "fast", "y' = -y - h"}, {"h", "fast", "h' = 4*y - 5*h + y^2"}}),
        ErrorKind::refused);
    EXPECT_TRUE(test::has(m, "found: two equal eigenvalues with one eigenvector: y, h\n"));
}

TEST(ExpandErrors, CriticalDampingIsSaid) {
    const std::string damped =
        test::refusal(system_with("x'' + 2*g*x' + g^2*x + x^3 = 0"), ErrorKind::refused);
    EXPECT_TRUE(test::has(damped, "semisimple; at critical damping it is not"));
    EXPECT_TRUE(test::has(damped, "found: x has the eigenvalue -g twice, with one eigenvector\n"));
    EXPECT_TRUE(test::has(damped, "hint:  take a little more or less damping"));
    const std::string driven = test::refusal(system_with("x'' - 2*x' + x = 0"), ErrorKind::refused);
    EXPECT_TRUE(test::has(driven, "found: x has the eigenvalue 1 twice, with one eigenvector\n"));
    EXPECT_FALSE(test::has(driven, "critical damping"));
    const std::string free = test::refusal(system_with("x'' + x^3 = 0"), ErrorKind::refused);
    EXPECT_FALSE(test::has(free, "critical damping"));
}

TEST(ExpandErrors, BlocksThatAreTooLarge) {
    const std::string m = test::refusal(
        test::system_text("s", {{"x", "fast", "x'' + x' - y' + x = 0"}, {"y", "fast", "y'' + x' + y = 0"}}),
        ErrorKind::refused);
    EXPECT_TRUE(test::has(m, "of the characteristic polynomial of x, y"));
}

// The message is made although log(s) is no log(0) at the origin.
TEST(ExpandErrors, LightTermsWithFunctionsAsFactors) {
    const std::string m =
        test::refusal("[system]\nname = \"s\"\n[parameters]\ns = { positive = true }\n[variables]\n"
                      "x = { role = \"fast\" }\ny = { role = \"fast\", weight = 2 }\n[equations]\n"
                      "x = \"x'' + x = x^2\"\ny = \"y'' + 3*y = log(s)*x\"\n",
                      ErrorKind::refused);
    EXPECT_TRUE(test::has(m, "a term in the rate of a fast variable has its weight at least"));
    EXPECT_TRUE(test::has(m, "log(s)*x"));
}

TEST(ExpandErrors, FiniteFastVariablesAreLinearAtRest) {
    const std::string m =
        test::refusal(system_with("x'' + x + x^3 = 0", "y = { role = \"fast\" }\n"), ErrorKind::bad_input);
    EXPECT_TRUE(test::has(m, "the variable has no equation"));
    const std::string finite = "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\", weight = 0 }\n"
                               "[equations]\nx = \"x'' + x + x^3 + eps*x^2 = 0\"\n";
    EXPECT_TRUE(test::has(test::refusal(finite, ErrorKind::refused), "the rest for x' is -x^3"));
}

TEST(ExpandErrors, FunctionsOfFiniteFastVariables) {
    const auto rate = [](const std::string& f) {
        return "[system]\nname = \"s\"\n[parameters]\nk = { positive = true }\n[variables]\n"
               "u = { role = \"fast\", weight = 0 }\nx = { role = \"fast\" }\n[equations]\nu = \"u' = eps*(" +
               f + ")\"\nx = \"x'' + x = 0\"\n";
    };
    for (const std::string f :
         {"exp(u)", "sin(1 + u)", "sqrt(2 + u)", "1/(2 + u)", "tanh(k + u)", "log(k + u)"}) {
        const std::string m = test::refusal(rate(f), ErrorKind::refused);
        EXPECT_TRUE(test::has(m, "are expanded in small variables, not in finite ones")) << m;
        EXPECT_TRUE(test::has(m, ":9:6: equations.u")) << m;
    }
    EXPECT_NO_THROW(test::field_from(rate("u*sin(k + eps*u + u*x)")));
}

TEST(ExpandErrors, AnglesOccurInHarmonicsOnly) {
    for (const std::string rate :
         {"eps*phi", "eps*sin(phi/2)", "eps*exp(phi)", "eps*sin(phi^2)", "eps*sin(tau*phi)"}) {
        const std::string toml = "[system]\nname = \"s\"\n[variables]\ntau = { role = \"slow\" }\n"
                                 "phi = { role = \"angle\" }\n[equations]\ntau = \"tau' = " +
                                 rate + "\"\nphi = \"phi' = 1 + tau\"\n";
        EXPECT_TRUE(test::has(test::refusal(toml, ErrorKind::refused),
                              "sin and cos of integer combinations of angles"))
            << rate;
    }
    const std::string uneven =
        test::system_text("s", {{"tau", "slow", "tau' = eps"}, {"phi", "angle", "phi' = 2 + cos(phi)"}});
    EXPECT_TRUE(test::has(test::refusal(uneven, ErrorKind::refused), "the rate of an angle at eps = 0"));
}

TEST(ExpandErrors, ForceAtTheOrigin) {
    const std::string m = test::refusal(system_with("x'' + x - g = 0"), ErrorKind::bad_input);
    EXPECT_TRUE(test::has(m, "x'' = g there"));
    EXPECT_TRUE(test::has(m, "say under [equilibrium] where the fast variables rest"));
}

TEST(ExpandErrors, AForceThatMayBeZero) {
    const std::string m =
        test::refusal(system_with("x'' + x = atan(3) + atan(1/3) - pi/2 + x^3"), ErrorKind::refused);
    EXPECT_TRUE(test::has(m, "is proved to be an equilibrium"));
    EXPECT_TRUE(test::has(test::refusal(system_with("x'' + x = log(2)"), ErrorKind::bad_input),
                          "is not an equilibrium"));
}

TEST(ExpandErrors, FrequencyNotProvedPositive) {
    EXPECT_TRUE(test::has(test::refusal(system_with("x'' + (1 + tau)*x = 0"), ErrorKind::refused),
                          "omega^2 = 1 + tau for x"));
    EXPECT_TRUE(test::has(test::refusal(system_with("x'' + tau*x = 0"), ErrorKind::refused),
                          "tau = { positive = true, ... }"));
    EXPECT_NO_THROW(expand(test::first_order_from(system_with("x'' - g*x = 0")))); // a saddle
    EXPECT_NO_THROW(expand(test::first_order_from(
        system_with("x'' + (1 + tau)*x = 0", "[domain]\npositive = [\"1 + tau\"]\n"))));
    for (const std::string declared : {"tau", "1 + tau + a"})
        EXPECT_NO_THROW(expand(test::first_order_from(
            system_with("x'' + (" + declared + ")*x = 0", "[domain]\npositive = [\"" + declared + "\"]\n"))))
            << declared;
}

TEST(ExpandErrors, SignsOfConstantsAreDecided) {
    for (const char* good :
         {"x'' + log(2)*x = x^3", "x'' + sin(1)*x = x^3", "x'' + x = x^3/cos(1)", "x'' + x = x^3*tan(1)",
          "x'' + x = x^3/log(2)", "x'' + cos(2)*x = x^3", "1e400*x'' + x = x^3", "1e-400*x'' + x = x^3"})
        EXPECT_NO_THROW(expand(test::first_order_from(system_with(good)))) << good;
    // Nobody is told to declare a number positive that is not.
    for (const char* wrong : {"x'' + x + x^3*log(1 - pi) = 0", "x'' + x + x^3*sqrt(cos(2)) = 0",
                              "x'' + (atan(3) + atan(1/3) - pi/2)*x = 0"}) {
        const std::string m = test::refusal(system_with(wrong), ErrorKind::refused);
        EXPECT_TRUE(test::has(m, "this is a number: correct it"));
        EXPECT_EQ(m.find("declare what"), std::string::npos) << m;
    }
}

TEST(ExpandErrors, DivisionByZero) {
    EXPECT_TRUE(test::has(test::refusal(system_with("x'' + x + eps/x = 0"), ErrorKind::bad_input),
                          "divided by an expression that is zero"));
    EXPECT_TRUE(test::has(test::refusal(system_with("x'' + x + eps*x/(x - eps) = 0"), ErrorKind::bad_input),
                          "divided by an expression that is zero"));
    EXPECT_TRUE(test::has(test::refusal(system_with("x''/x + 1 = x^3"), ErrorKind::bad_input), "found: x"));
    for (const std::string role : {"slow", "drift", "angle"})
        for (const std::string rate : {"eps/x", "1/eps", "x/eps"}) {
            const std::string m = test::refusal(
                "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\nJ = { role = \"" + role +
                    "\" }\n[equations]\nx = \"x'' + x = x^3\"\nJ = \"J' = " + rate + "\"\n",
                ErrorKind::bad_input);
            EXPECT_TRUE(test::has(m, "divided by an expression that is zero"));
            EXPECT_TRUE(test::has(m, "equations.J"));
        }
    EXPECT_TRUE(test::has(
        test::refusal(system_with("x'' + a*x = x^3", "[relations]\na = \"2*g/eps\"\n"), ErrorKind::bad_input),
        "the relation has no value at eps = 0"));
}

TEST(ExpandErrors, DivisionByWhatIsNotProvedNonZero) {
    const std::string m = test::refusal(system_with("x'' + x + eps*x/a = 0"), ErrorKind::refused);
    EXPECT_TRUE(test::has(m, "nothing is divided by an expression that is not proved to be non-zero"));
    EXPECT_TRUE(test::has(m, "nonzero = true"));
}

TEST(ExpandErrors, FunctionsOfSlowVariables) {
    const auto refused = [](const std::string& equation) {
        return test::refusal(system_with(equation), ErrorKind::refused);
    };
    EXPECT_TRUE(test::has(refused("x'' + x + eps*log(tau)*x = 0"),
                          "a logarithm is taken only of what is proved to be positive"));
    EXPECT_TRUE(test::has(refused("x'' + x + eps*log(tau)*x = 0"), "found: tau"));
    EXPECT_TRUE(test::has(refused("x'' + x + eps*x*tan(tau) = 0"), "found: cos(tau)"));
    EXPECT_TRUE(test::has(refused("x'' + x + eps*x/(1 + sin(tau)) = 0"), "found: 1 + sin(tau)"));
    EXPECT_TRUE(test::has(
        test::refusal(system_with("x'' + x + eps*x/(sin(tau)^2 + cos(tau)^2 - 1) = 0"), ErrorKind::bad_input),
        "divided by an expression that is zero"));
    EXPECT_TRUE(test::has(refused("x'' + x + eps*asin(tau)*x = 0"), "is proved to lie between -1 and 1"));
    for (const char* of_zero : {"x'' + x + eps*log(x) = 0", "x'' + x + x^3*log(eps) = 0"})
        EXPECT_TRUE(
            test::has(test::refusal(system_with(of_zero), ErrorKind::bad_input), "log has no value at zero"));
    EXPECT_TRUE(test::has(refused("x'' + (1 + cos(tau))*x = 0"), "the square of a frequency is proved"));
}

// Each reading makes new symbols, which GiNaC orders anew.
TEST(ExpandErrors, OfSeveralReasonsTheSameOneIsNamed) {
    for (const std::string equation :
         {"x'' + x + eps*(log(tau) + tan(tau) + exp(tau) + asin(tau))*x = 0",
          "x'' + x + eps*x/a + eps*x/(1 + a) + eps*x/(2 - a) + eps*x/(a - tau) = 0",
          "x'' + x + sin(x + tau) + cos(x + a) + exp(x + g) + acos(x) = 0",
          "x'' + x + eps*x*sqrt(a)*sqrt(tau)*(1 + a)^(1/3)*(a - tau)^(1/3) = 0",
          "x'' + x + (g^(1/60) + (1 + g)^(1/61) + (2 + g)^(1/67) + (3 + g)^(1/71))*x^2 = 0",
          "x'' + x + (a - tau)/(g - a) + (a - g)*(tau - a) = 0"}) {
        std::set<std::string> messages;
        constexpr int readings = 12;
        for (int k = 0; k < readings; ++k) {
            const Error e = test::error_when([&] { expand(test::first_order_from(system_with(equation))); });
            messages.insert(e.what());
        }
        EXPECT_EQ(messages.size(), 1U) << *messages.begin() << "\n" << *messages.rbegin();
    }
}

TEST(ExpandErrors, AnArcCosineLeavesPi) {
    EXPECT_NO_THROW(expand(test::first_order_from(system_with("x'' + x + eps*x*(pi/2 - acos(x)) = 0"))));
    EXPECT_NO_THROW(expand(test::first_order_from(system_with("x'' + x + eps*x*acos(x) = 0"))));
    const std::string m = test::refusal(system_with("x'' + x + acos(x) = 0"), ErrorKind::bad_input);
    EXPECT_TRUE(test::has(m, "x'' = -1/2*pi there"));
}

// GiNaC writes (2 - tau)^3 as -(tau - 2)^3 whenever its order of terms has it so.
TEST(ExpandErrors, FactorsAreTurnedPositiveInOddPowersToo) {
    for (int reading = 0; reading < 8; ++reading)
        EXPECT_NO_THROW(
            expand(test::first_order_from(system_with("x'' + x + eps*x*sqrt(g^3*(2 - tau)^3*(1 + tau)) = 0",
                                                      "[domain]\npositive = [\"2 - tau\", \"1 + tau\"]\n"))));
}

TEST(ExpandErrors, WhatTheRingCannotHoldHasAPlace) {
    std::string many = "x'' + x";
    for (int k = 1; k <= 40; ++k) many += " + eps*x*sqrt(g + " + std::to_string(k) + ")";
    for (const auto& [equation, rule] :
         {std::pair(many, std::string("at most 32 of these together")),
          {"x'' + x + eps*x*g^(1/64) = 0", "common index of at most 63"},
          {"x'' + x + eps*x*g^(1/7)*g^(1/10) = 0", "common index of at most 63"},
          {"x'' + x + eps*x*sqrt(g^64 + 1) = 0", "exponents under a root are at most 63"}}) {
        const std::string m =
            test::refusal(system_with(equation.find('=') == std::string::npos ? equation + " = 0" : equation),
                          ErrorKind::refused);
        EXPECT_TRUE(test::has(m, rule));
        EXPECT_TRUE(test::has(m, "test/system.toml:"));
        EXPECT_TRUE(test::has(m, "equations.x"));
    }
    EXPECT_NO_THROW(expand(test::first_order_from(system_with("x'' + x + eps*x*g^(1/63) = 0"))));
}

TEST(ExpandErrors, ModesKeepTheirNames) {
    const std::string toml =
        test::system_text("s", {{"x", "fast", "x'' + x + eps*z1*x^2 = 0"}}, "[parameters]\nz1 = {}\n");
    EXPECT_TRUE(test::has(test::refusal(toml, ErrorKind::bad_input),
                          "reserved are I, pi, E, eps, lambda, t, z1, z2, ..."));
}

TEST(ExpandErrors, SlowAndDriftRatesVanishWithEps) {
    const std::string slow =
        test::system_text("s", {{"x", "fast", "x'' + x = 0"}, {"tau", "slow", "tau' = 1"}});
    EXPECT_TRUE(test::has(test::refusal(slow, ErrorKind::bad_input), "tau' = 1"));
    const std::string drift =
        test::system_text("s", {{"x", "fast", "x'' + x + eps*y*x = 0"}, {"y", "drift", "y' = eps"}});
    EXPECT_TRUE(test::has(test::refusal(drift, ErrorKind::bad_input), "the equation of x contains y"));
}

} // namespace resonform
