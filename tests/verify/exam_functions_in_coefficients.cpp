// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose coefficients hold functions of slow variables and parameters: every function that is read.
#include "own_system.hpp"
#include "support/error_when.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

class FunctionsInCoefficients : public testing::TestWithParam<const char*>, protected test::WrittenSystem {
protected:
    // x'' + (stiffness) x + x^3 = 0, tau' = eps
    Scene scene(const std::string& stiffness) {
        return of("[parameters]\nal = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                  "tau = { role = \"slow\", positive = true }\n[domain]\npositive = [\"1 - tau/2\", "
                  "\"cos(tau)\", \"" +
                      stiffness + "\"]\n[equations]\nx = \"x'' + (" + stiffness +
                      ")*x + x^3 = 0\"\ntau = \"tau' = eps\"\n",
                  "order = 2\n[fix]\nal = \"1/3\"\n[start]\nx = \"eps\"\n\"x'\" = 0\ntau = 0.25\n"
                  "[verify]\neps = [0.04, 0.02, 0.01, 0.005]\ninterval = \"1/(2*eps)\"\n");
    }

    Scene of(const std::string& system, const std::string& text) { return written(system, text); }
};

TEST_P(FunctionsInCoefficients, AreSolved) {
    const Verification v = test::verified(test::line_of(scene(GetParam())));
    for (const auto& output : v.outputs) EXPECT_EQ(output.verdict, Verdict::pass) << output.reason;
    EXPECT_TRUE(v.as_expected()) << to_text(v.emitted);
}

// 3 + log(tau) would be a difference of equal numbers at tau = 0.05, where some starts are drawn.
INSTANTIATE_TEST_SUITE_P(SlowOfEveryKind, FunctionsInCoefficients,
                         testing::Values("2 + sin(3*tau)", "1 + exp(-2*tau)", "4 + log(tau)",
                                         "1 + tan(tau)^2", "2 + atan(tau - 1)", "1 + sinh(tau)",
                                         "cosh(al*tau)", "1 + tanh(tau)", "2 + asin(tau/2)",
                                         "2 + acos(tau/2)", "1 + asinh(tau)", "1 + acosh(1 + tau)",
                                         "1 + atanh(tau/2)", "1 + erf(tau)", "2 + sin(al)*cos(tau)",
                                         "1 + exp(al)*log(1 + tau)"));

TEST_F(FunctionsInCoefficients, OfTwoKindsAreSolvedTogether) {
    const Verification v = test::verified(test::line_of(scene("2 + sin(3*tau)*exp(-al*tau)")));
    EXPECT_TRUE(v.as_expected()) << to_text(v.emitted);
}

// The map moves s within every function, and so does its inverse at the start.
TEST_F(FunctionsInCoefficients, OfADrivenVariableAreShifted) {
    const Scene read =
        of("[variables]\ny = { role = \"fast\", weight = 0 }\ns = { role = \"slow\" }\n[equations]\n"
           "y = \"y' = -2*y + eps*sin(s)*y\"\ns = \"s' = eps*(1 - s) + eps*y^2*(cos(2*s) + exp(-s) + "
           "log(2 + s^2)/2 + atan(s) + asinh(s) + erf(s))\"\n",
           "order = 2\n[start]\ny = 0.5\ns = 0.25\n[verify]\neps = [0.05, 0.02, 0.01]\n");
    const Verification v = test::verified(test::line_of(read));
    for (const auto& output : v.outputs) EXPECT_EQ(output.found_order, 3) << output.name << output.reason;
    EXPECT_TRUE(v.as_expected()) << to_text(v.emitted);
}

// The evaluator ends where the declared domain of its functions does: cos(tau) = 0 comes before tau = 2.
TEST_F(FunctionsInCoefficients, EndWithTheirDomain) {
    const Interpreter<double> evaluator(test::program_of(scene("2 + asin(tau/2)")), 0.01, {}, {}, 3);
    std::vector<double> value;
    EXPECT_EQ(evaluator.call(130, value), Status::ok);
    EXPECT_EQ(evaluator.call(140, value), Status::outside_domain);
}

TEST(FunctionsByName, AreNotSolved) {
    const System named = read_system_text(
        "[system]\nname = \"s\"\n[functions]\nomega = { of = [\"tau\"], positive = true }\n[variables]\n"
        "x = { role = \"fast\" }\ntau = { role = \"slow\" }\n[equations]\n"
        "x = \"x'' + omega(tau)^2*x = 0\"\ntau = \"tau' = eps\"\n",
        "named.toml");
    const Error e = test::error_when([&] { test::derive(std::make_shared<const System>(named), 1, 2); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().value, "omega(tau)");
    EXPECT_EQ(e.diagnostic().hint,
              "give omega a value under [functions] of a scene, or derive the normal form");
}

} // namespace
} // namespace resonform
