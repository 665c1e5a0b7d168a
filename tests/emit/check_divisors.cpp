// SPDX-License-Identifier: GPL-3.0-or-later
// The page of divisors: verdicts, and the surfaces on which one that was divided by vanishes.
#include "emit/derive/document.hpp"
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace resonform::test {

namespace {

const std::string two_oscillators = system_text(
    "test", {{"x", "fast", "x'' + w1^2*x + a*x*y = 0"}, {"y", "fast", "y'' + w2^2*y + a*x^2 = 0"}},
    "[parameters]\nw1 = { positive = true }\nw2 = { positive = true }\na = {}\n");

std::string printed(const std::string& file, int order, Format format) {
    const Normalization n = normalize_poincare(field_from(file), order);
    return print_divisors(*n.normal_form.field, n.divisors, order, format);
}

std::string normal_form(const std::string& file, int order) {
    return print_normal_form(normalize_poincare(field_from(file), order), order, Format::text, nullptr);
}

// Roots of x^2 + 2*g*x - k: their differences and multiples keep their signs, 2*w1 - w2 does not.
const std::string roots_and_frequencies =
    system_text("test",
                {{"x", "fast", "x'' + 2*g*x' - k*x = x^2"},
                 {"y", "fast", "y'' + w1^2*y = y*z"},
                 {"z", "fast", "z'' + (w2*(tau^2 + 1))^2*z = y^2"},
                 {"tau", "slow", "tau' = eps"}},
                "[parameters]\ng = { positive = true }\nk = { positive = true }\n"
                "w1 = { positive = true }\nw2 = { positive = true }\n");

// tau = 0 and tau = 1 lie outside of the domain, tau = 2 does not.
const std::string frequency_in_a_domain = R"toml(
[system]
name = "test"
[variables]
p = { role = "angle" }
q = { role = "angle" }
x = { role = "drift" }
tau = { role = "slow" }
[domain]
positive = ["tau^2 - 2"]
[equations]
p = "p' = tau"
q = "q' = 2"
x = "x' = eps*(cos(p) + cos(2*p - q) + cos(p - q))"
tau = "tau' = eps"
)toml";

} // namespace

TEST(Divisors, WhatIsProvedNonzeroIsNoSurface) {
    const std::string text = printed(roots_and_frequencies, 2, Format::text);
    EXPECT_NE(text.find("resonance surfaces:\n  w2*tau^2 - 2*w1 + w2 = 0\n\n"), std::string::npos) << text;
    const std::string in_domain = printed(frequency_in_a_domain, 1, Format::text);
    EXPECT_NE(in_domain.find("resonance surfaces:\n  tau - 2 = 0\n\n"), std::string::npos) << in_domain;
}

TEST(Divisors, WhatIsProvedNonzeroIsNotTakenToBe) {
    const std::string text = normal_form(roots_and_frequencies, 2);
    EXPECT_NE(text.find("small divisors, taken to vanish nowhere: w2*tau^2 - 2*w1 + w2\n"), std::string::npos)
        << text;
}

TEST(Divisors, TellWhereTheNormalFormMeansNothing) {
    const std::string text = printed(two_oscillators, 2, Format::text);
    EXPECT_NE(text.find("z1, removed (divided by):"), std::string::npos) << text;
    EXPECT_NE(text.find("D(z2*z3) = -I*(2*w1 - w2)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("z1, kept exact (resonant):\n  D(z1) = 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("resonance surfaces:\n  2*w1 - w2 = 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("2 kept exact"), std::string::npos) << text;
}

// w1 + w2 is no surface, since both are positive; -2 w1 + w2 and 2 w1 - w2 are one.
TEST(Divisors, OneSurfaceForAllMultiplesOfADivisor) {
    const auto json = nlohmann::ordered_json::parse(printed(two_oscillators, 2, Format::json));
    EXPECT_EQ(json["schema"], "resonform.divisors/1");
    ASSERT_EQ(json["surfaces"].size(), 1u) << json;
    EXPECT_EQ(json["surfaces"][0]["vanishing"], nlohmann::ordered_json({"2*w1 - w2"}));
    const auto in = json["surfaces"][0]["divisors"];
    ASSERT_EQ(in.size(), 2u) << in;
    EXPECT_EQ(in[0].dump(), R"({"variable":"z1","exponents":{"z2":1,"z3":1}})");
    EXPECT_EQ(in[1].dump(), R"({"variable":"z3","exponents":{"z1":2}})");
}

// a + i b vanishes where both do: here nowhere, as b = w does not.
TEST(Divisors, OfDampedModesVanishWhereBothPartsDo) {
    const std::string text = printed(system_text("test",
                                                 {{"x", "fast", "x' = -w*y + x*s"},
                                                  {"y", "fast", "y' = w*x + y*s"},
                                                  {"s", "fast", "s' = k*s + x^2"}},
                                                 "[parameters]\nk = {}\nw = { positive = true }\n"),
                                     2, Format::text);
    EXPECT_NE(text.find("D(z1*z2) = -k\n"), std::string::npos) << text;
    EXPECT_NE(text.find("resonance surfaces:\n  k = 0\n"), std::string::npos) << text;
}

// 1 + tau^2 and 4 + 3 tau^2 vanish nowhere.
TEST(Divisors, OfOneSignHaveNoSurface) {
    const std::string text = printed(system_text("test", {{"x", "fast", "x' = -(1 + tau^2)*x + y^2"},
                                                          {"y", "fast", "y' = -(2 + tau^2)*y + x*y"},
                                                          {"tau", "slow", "tau' = eps"}}),
                                     2, Format::text);
    EXPECT_EQ(text.find("tau^2 + 1) = 0"), std::string::npos) << text;
    EXPECT_NE(text.find("no divisor that was divided by can vanish\n"), std::string::npos) << text;
}

TEST(Divisors, OfNumbersHaveNoSurface) {
    const std::string text =
        printed(system_text("test", {{"x", "fast", "x'' + x + x^3 = 0"}}), 3, Format::text);
    EXPECT_NE(text.find("D(z1^2*z2) = 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("no divisor that was divided by can vanish\n"), std::string::npos) << text;
}

// Neither 2 + cos(s) nor its sum with 2 + sin(s) vanishes.
TEST(Divisors, BoundsOfFunctionsRuleSurfacesOut) {
    const std::string text = printed(R"toml(
[system]
name = "test"
[variables]
x = { role = "fast" }
s = { role = "slow" }
p = { role = "angle" }
[equations]
x = "x'' + (2 + sin(s))^2*x = x^2 + eps*x*cos(p)"
s = "s' = eps"
p = "p' = 1 + cos(s)/2"
)toml",
                                     2, Format::text);
    EXPECT_EQ(text.find("\n  cos(s) + 2 = 0"), std::string::npos) << text;
    EXPECT_EQ(text.find("4*sin(s) + cos(s) + 10 = 0"), std::string::npos) << text;
    EXPECT_NE(text.find("no divisor that was divided by can vanish\n"), std::string::npos) << text;
}

} // namespace resonform::test
