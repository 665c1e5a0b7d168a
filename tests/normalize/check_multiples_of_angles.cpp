// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of multiples of a slow variable, alone and beside each other, and one declaration for what they
// are under, in whatever spelling.
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace resonform {
namespace {

std::string file(const std::string& equation, const std::string& declared) {
    return test::oscillator_file(equation, "tau = { role = \"slow\" }\n", "tau = \"tau' = eps\"\n",
                                 "a = {}\n") +
           (declared.empty() ? "" : "[domain]\npositive = [\"" + declared + "\"]\n");
}

TEST(MultiplesOfAngles, AloneAreFunctionsOfTheirOwn) {
    for (const auto& [equation, function] :
         {std::pair{"x'' + (1 - tau^2*cos(3*tau))*x = 0", "cos(3*tau)"},
          std::pair{"x'' + (1 - tau^2*cos(3*tau))*x + cos(6*tau)*x^2 = 0", "cos(3*tau)"},
          std::pair{"x'' + (1 - tau^2*cos(3*tau))*x + sin(2*tau)*x^2 = 0", "cos(tau)"},
          std::pair{"x'' + (1 - tau^2*cos(3*tau))*x + exp(-2*tau)*x^2 = 0", "exp(2*tau)"},
          std::pair{"x'' + (1 - tau^2*cos(3*tau))*x + sin(tau/2)*x^2 = 0", "sin(1/2*tau)"}}) {
        const auto field = test::field_from(file(equation, "1 - tau^2*cos(3*tau)"));
        EXPECT_TRUE(field->ring->find(function)) << equation;
        test::certified(field, 3);
    }
}

// omega' = (3*tau^2*sin(3*tau) - 2*tau*cos(3*tau))*eps/(2*omega), and z1' = i*omega*z1 - omega'/(2*omega)*z1.
TEST(MultiplesOfAngles, HaveTheirDerivatives) {
    const auto field = test::field_from(file("x'' + (1 - tau^2*cos(3*tau))*x = 0", "1 - tau^2*cos(3*tau)"));
    const Normalization n = test::certified(field, 3);
    EXPECT_EQ(
        test::coefficient_of(*field, n.normal_form.mode[0], {{"z1", 1}, {"eps", 1}}),
        test::coefficient(*field, "(2*tau*cos(3*tau) - 3*tau^2*sin(3*tau))/(4*(1 - tau^2*cos(3*tau)))"));
}

class Spellings : public ::testing::TestWithParam<const char*> {};

TEST_P(Spellings, OneDeclarationIsEnough) {
    for (const char* omega : {"1 - tau^2*cos(3*tau)", "1 - tau^2*(4*cos(tau)^3 - 3*cos(tau))"})
        for (const char* rest : {"", " + sin(tau)*x^2", " + x^3/(1 - tau^2*cos(3*tau) + x)"})
            test::certified(
                test::field_from(file("x'' + (" + std::string(omega) + ")*x" + rest + " = 0", GetParam())),
                3);
}

INSTANTIATE_TEST_SUITE_P(All, Spellings,
                         ::testing::Values("1 - tau^2*cos(3*tau)", "1 - tau^2*(4*cos(tau)^3 - 3*cos(tau))",
                                           "3*tau^2*cos(tau) - 4*tau^2*cos(tau)^3 + 1",
                                           "2 - 2*tau^2*cos(3*tau)", "1/tau^2 - cos(3*tau)"));

// The expression that a refusal asks to declare.
std::optional<std::string> asked_for(const std::string& text) {
    try {
        test::certified(test::field_from(text), 3);
    } catch (const Error& error) {
        const std::string& hint = error.diagnostic().hint;
        const std::string before = "[domain] positive = [\"";
        const std::size_t at = hint.find(before);
        EXPECT_NE(at, std::string::npos) << error.what();
        EXPECT_GT(error.diagnostic().place.column, 0) << error.what();
        if (at == std::string::npos) return std::nullopt;
        const std::size_t begin = at + before.size();
        return hint.substr(begin, hint.find('"', begin) - begin);
    }
    return std::nullopt;
}

class Hints : public ::testing::TestWithParam<const char*> {};

TEST_P(Hints, AreEnoughWhenTheyAreFollowed) {
    const std::optional<std::string> hint = asked_for(file(GetParam(), ""));
    ASSERT_TRUE(hint);
    EXPECT_FALSE(asked_for(file(GetParam(), *hint))) << *hint;
}

INSTANTIATE_TEST_SUITE_P(All, Hints,
                         ::testing::Values("x'' + (1 - tau^2*cos(3*tau))*x = 0",
                                           "x'' + (1 - tau^2*cos(3*tau))*x + sin(tau)*x^2 = 0",
                                           "x'' + (1 - tau^2*cos(40*tau))*x + sin(40*tau)*x^2 = 0",
                                           "x'' + (2 - cosh(tau))*x + exp(tau)*x^2 = 0",
                                           "x'' + (tau - tanh(2*tau))*x + exp(tau)*x^2 = 0",
                                           "x'' + (tau*sin(tau/2) + cos(tau/3))*x + x^2 = 0",
                                           "x'' + (tau^2 - sin(tau)^2)*x + cos(tau)*x^2 = 0",
                                           "x'' + (1 - tau*cos(a*tau) - sin(2*a*tau))*x + x^2 = 0",
                                           "x'' + (1 - tau*sqrt(1 + tau^2))*x + x^2 = 0",
                                           "x'' + x + x^2*sqrt((tau^2 + 1)*(a - tanh(tau))) = 0",
                                           "x'' + x + x^2/(1 - sqrt(2) + tau^2 + x) = 0"));

} // namespace
} // namespace resonform
