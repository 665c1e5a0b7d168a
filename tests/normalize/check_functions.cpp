// SPDX-License-Identifier: GPL-3.0-or-later
// Every elementary function that a system may contain, and every kind of coefficient, goes through
// expansion and normalisation and satisfies its own equations (the certificate's second route).
#include "certify/certificate.hpp"
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

class EveryEquation : public ::testing::TestWithParam<const char*> {};

} // namespace

TEST_P(EveryEquation, IsCertifiedThroughWeightFive) {
    const auto field =
        test::field_from(std::string("[system]\nname = \"s\"\n[parameters]\ng = { positive = true }\n"
                                     "a = { nonzero = true }\n[variables]\nx = { role = \"fast\" }\n"
                                     "tau = { role = \"slow\" }\ny = { role = \"drift\" }\n"
                                     "[functions]\nf = { of = [\"tau\"], positive = true }\n"
                                     "[domain]\npositive = [\"1 + tau\"]\n[equations]\nx = \"") +
                         GetParam() + "\"\ntau = \"tau' = eps*a\"\ny = \"y' = x^2 + eps*x'\"\n");
    const Normalization n = normalize_poincare(field, 5);
    const Certificate c = certify(n.normal_form, n.map);
    EXPECT_TRUE(c.holds) << c.complaint;
    EXPECT_EQ(c.through_weight, 5);
    EXPECT_LT(c.error_probability, 1e-20);
}

INSTANTIATE_TEST_SUITE_P(Functions, EveryEquation,
                         ::testing::Values("x'' + tan(x) = 0", "x'' + sinh(x) + eps*cosh(x) = 0",
                                           "x'' + tanh(x)*cos(x) = 0", "x'' + atan(x) = 0",
                                           "x'' + asin(x) + eps*x'^2 = 0", "x'' + exp(x) - 1 = 0",
                                           "x'' + log(1 + x) = 0", "x'' + asinh(x) = 0",
                                           "x'' + atanh(x) + eps*x*x' = 0", "x'' + x + acosh(2 + x)*x^2 = 0",
                                           "x'' + erf(x) + x = 0", "x'' + x/sqrt(1 + x^2) = 0",
                                           "x'' + x + eps = 0", "(1 + x^2)*x'' + x + eps*x' = 0",
                                           "x'' + x/(1 + eps*x - x')^2 = 0"));

INSTANTIATE_TEST_SUITE_P(
    Coefficients, EveryEquation,
    ::testing::Values("x'' + (1 + tau)*x + x^3 = 0", "x'' + sqrt(1 + tau)*x + tau*x^2 = 0",
                      "x'' + (2 + tau^2)*x + (1 + tau)*x^3 = 0", "g^2*x'' + x*(g + a*x) = 0",
                      "x'' + 2*g/(1 + tau^2)*sin(x) = 0", "x'' + g^(2/3)*x + x^2/a = 0",
                      "x'' + sqrt(g + sqrt(1 + tau^2))*x + x^2 = 0", "x'' + 3*x + tau*x^3/(1 + tau) = 0",
                      "x'' + (1 + tau)*(4 + tau^2)*x + x^3 = 0"));

// log(sqrt(u)) is log(u)/2, in products, in exponents and beside other roots.
INSTANTIATE_TEST_SUITE_P(LogarithmsOfRoots, EveryEquation,
                         ::testing::Values("x'' + x = x^2*log(sqrt(g))", "x'' + x = eps*x*log(sqrt(1 + tau))",
                                           "x'' + x = x^2*log(2*g*sqrt(1 + tau)/(1 + tau^2)^3)",
                                           "x'' + x = x^2*sqrt(2)^a",
                                           "x'' + (1 + log(1 + tau)^2 + log(sqrt(1 + tau))^2)*x = x^2",
                                           "x'' + x = x^2*sqrt(exp(log(g)/2))",
                                           "x'' + x = eps*x*exp(log(3/2 + tanh(tau))/2)",
                                           "x'' + x = x^2*log(1 + sqrt(2)/2)"));

// Derivatives that the equations hold are differentiated as often as the functions themselves.
INSTANTIATE_TEST_SUITE_P(DerivativesOfNamedFunctions, EveryEquation,
                         ::testing::Values("x'' + f(tau)^2*x = eps*x*f'''(tau)",
                                           "x'' + (3 + f'(tau)^2)*x = 0"));

// What is declared negative has roots, and a logarithm, of its negative.
TEST(NegativeNames, AreCertified) {
    for (const char* equation :
         {"x'' - tau*x + x^3 = 0", "x'' + x + log(-tau)*x^2 = 0", "x'' + sqrt(tau^2)*x + x^3 = 0",
          "x'' + (-tau)^(1/3)*x + x^2/tau = 0", "x'' - tau^3*x = 0", "x'' + a*tau*x + x^3 = 0"}) {
        const auto field = test::field_from(
            std::string("[system]\nname = \"s\"\n[parameters]\na = {}\n[variables]\nx = { role = \"fast\" }\n"
                        "tau = { role = \"slow\" }\n[domain]\npositive = [\"-tau\", \"-a\"]\n"
                        "[equations]\nx = \"") +
            equation + "\"\ntau = \"tau' = eps\"\n");
        const Normalization n = normalize_poincare(field, 3);
        const Certificate c = certify(n.normal_form, n.map);
        EXPECT_TRUE(c.holds) << equation << ": " << c.complaint;
    }
}

} // namespace resonform
