// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of slow variables and parameters in coefficients, alone and mixed with fast variables: every
// normal form satisfies its own equations, and every lie about one is found.
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::certificate_of;

std::string file(const std::string& equation) {
    return "[system]\nname = \"s\"\n[parameters]\nalpha = {}\nn = {}\nr = { positive = true }\n"
           "[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\ny = { role = \"drift\" }\n"
           "[functions]\nomega = { of = [\"tau\"], positive = true }\nb = { of = [\"tau\"] }\n"
           "[domain]\npositive = [\"1 + tau\", \"cos(alpha)\"]\n[equations]\nx = \"" +
           equation + "\"\ntau = \"tau' = eps*(1 + sin(tau)/2)\"\ny = \"y' = exp(-tau)*x^2 + eps*x'\"\n";
}

class EveryCoefficient : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryCoefficient, IsCertified) {
    const auto field = test::field_from(file(GetParam()));
    const Normalization n = normalize_poincare(field, 4);
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    EXPECT_LT(c.error_probability, 1e-20);
}

TEST_P(EveryCoefficient, IsCheckedForLies) {
    Normalization n = normalize_poincare(test::field_from(file(GetParam())), 2);
    int lies = 0;
    for (const test::NamedSeries& item : test::all_series(n))
        for (int weight = 1; weight <= item.series->through(); ++weight) {
            const Polynomial truth = item.series->part(weight);
            for (std::size_t k = 0; k < truth.size(); ++k, ++lies) {
                std::vector<Term> terms = truth.terms();
                terms[k].coefficient = terms[k].coefficient + 1;
                item.series->set(weight, Polynomial::from_terms(std::move(terms)));
                EXPECT_FALSE(certificate_of(n).holds) << item.name << ", weight " << weight << ", term " << k;
            }
            item.series->set(weight, truth);
        }
    EXPECT_GT(lies, 4);
}

INSTANTIATE_TEST_SUITE_P(
    Alone, EveryCoefficient,
    ::testing::Values("x'' + exp(-tau)*sin(x) = 0", "x'' + (2 + cos(tau))*x = eps*sin(tau)*x^2",
                      "x'' + exp(2*tau)*x + exp(-tau/2)*x^3 = 0",
                      "x'' + x + (sin(2*tau) + cos(tau/2))*x^2 = 0", "x'' + (2 + tanh(tau))*x + x^3 = 0",
                      "x'' + cosh(tau)*x + sinh(tau)*x^2 = 0",
                      "x'' + (1 + log(1 + tau)^2)*x + log(1 + tau)*x^2 = 0",
                      "x'' + (2 + atan(tau))*x + atan(tau)*x^3 = 0",
                      "x'' + cos(alpha)^2*x + sin(alpha)*x^2 = 0", "x'' + x/cos(alpha) + tan(alpha)*x^3 = 0",
                      "x'' + exp(n*log(r))*x + x^2 = 0", "x'' + (1 + tau)*x + exp(n*log(1 + tau))*x^2 = 0",
                      "x'' + exp(sin(tau))*x + x^2 = 0", "x'' + x + log(r^2*exp(tau))*x^2 = 0",
                      "x'' + (3 + sin(tau + alpha))*x + cos(tau - alpha)*x^2 = 0"));

INSTANTIATE_TEST_SUITE_P(Mixed, EveryCoefficient,
                         ::testing::Values("x'' + 2*x + sin(tau + x) - sin(tau) = 0",
                                           "x'' + exp(tau + x) - exp(tau) = 0",
                                           "x'' + log(1 + tau + x) - log(1 + tau) + x = 0",
                                           "x'' + atan(tau + x) - atan(tau) + x = 0",
                                           "x'' + 2*x + cos(alpha + 2*x) - cos(alpha) + 2*sin(alpha)*x = 0",
                                           "x'' + x + tanh(tau + eps*x)*x^2 = 0",
                                           "x'' + 3*x + eps*cosh(tau + x') = 0",
                                           "x'' + x + tan(alpha + x)*x^2 = 0"));

INSTANTIATE_TEST_SUITE_P(Named, EveryCoefficient,
                         ::testing::Values("x'' + omega(tau)^2*x + x^3 = 0",
                                           "x'' + omega(tau)*x + b(2*tau)*x^2 = 0",
                                           "x'' + x + b(tau)*x^2 + eps*b'(tau)*x' = 0",
                                           "x'' + (1 + b(tau)^2)*x + omega(tau)*x^3 = 0",
                                           "x'' + x + b(tau + x)*x^2 = 0"));

} // namespace
} // namespace resonform
