// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of slow variables and parameters in coefficients, alone and mixed with fast variables: every
// normal form satisfies its own equations, and every lie about one is found.
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

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
    for (const test::SeriesOfForm& item : test::all_series(n))
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
                      "x'' + (2 + erf(tau))*x + erf(tau)*x^2 = 0", "x'' + x + asinh(tau)*x^3 = 0",
                      "x'' + x + acosh(2 + tau^2)*x^2 = 0", "x'' + x + atanh(tanh(tau))*x^2 = 0",
                      "x'' + cos(alpha)^2*x + sin(alpha)*x^2 = 0", "x'' + x/cos(alpha) + tan(alpha)*x^3 = 0",
                      "x'' + r^n*x + x^2 = 0", "x'' + (1 + tau)*x + exp(n*log(1 + tau))*x^2 = 0",
                      "x'' + exp(sin(tau))*x + x^2 = 0", "x'' + x + log(r^2*exp(tau))*x^2 = 0",
                      "x'' + (3 + sin(tau + alpha))*x + cos(tau - alpha)*x^2 = 0",
                      "x'' + x + sin(acos(1/(2 + tau^2)) + alpha)*x^2 = 0",
                      "x'' + (2 + cos(2*atan(tau) - alpha))*x + tan(asin(tau/(1 + tau^2)))*x^3 = 0"));

INSTANTIATE_TEST_SUITE_P(
    Mixed, EveryCoefficient,
    ::testing::Values("x'' + 2*x + sin(tau + x) - sin(tau) = 0", "x'' + exp(tau + x) - exp(tau) = 0",
                      "x'' + log(1 + tau + x) - log(1 + tau) + x = 0",
                      "x'' + atan(tau + x) - atan(tau) + x = 0", "x'' + asinh(tau + x) - asinh(tau) + x = 0",
                      "x'' + x + acosh(3 + tau^2 + x)*x^2 = 0", "x'' + x + atanh(tanh(tau)/2 + x)*x^2 = 0",
                      "x'' + erf(tau + x) - erf(tau) + x = 0",
                      "x'' + 2*x + cos(alpha + 2*x) - cos(alpha) + 2*sin(alpha)*x = 0",
                      "x'' + x + tanh(tau + eps*x)*x^2 = 0", "x'' + 3*x + eps*cosh(tau + x') = 0",
                      "x'' + x + tan(alpha + x)*x^2 = 0"));

INSTANTIATE_TEST_SUITE_P(Named, EveryCoefficient,
                         ::testing::Values("x'' + omega(tau)^2*x + x^3 = 0",
                                           "x'' + omega(tau)*x + b(2*tau)*x^2 = 0",
                                           "x'' + x + b(tau)*x^2 + eps*b'(tau)*x' = 0",
                                           "x'' + (1 + b(tau)^2)*x + omega(tau)*x^3 = 0",
                                           "x'' + x + b(tau + x)*x^2 = 0"));

// Slow variables that fast ones drive, xi = zeta + k, and angles, with functions of them.
TEST(FunctionCoefficients, OfDrivenSlowVariablesAndAngles) {
    const std::string variables = "tau = { role = \"slow\" }\nphi = { role = \"angle\" }\n";
    const std::string functions = "[functions]\nomega = { of = [\"tau\"], positive = true }\n[equations]\n";
    for (const std::string equation :
         {"x'' + exp(-tau)*x + x^2 = 0", "x'' + (2 + cos(tau))*x + sin(tau + x)*x^2 = 0",
          "x'' + omega(tau)^2*x + omega'(tau)*x^2 = 0",
          "x'' + 2*x + eps*cos(2*phi + tau) + atan(tau)*x^2 = 0",
          "x'' + 2*x + eps*sin(phi)*log(1 + tau^2)*x + eps*cos(phi - x) = 0"}) {
        std::string file = test::oscillator_file(
            equation, variables, "tau = \"tau' = eps*x^2 + eps*x\"\nphi = \"phi' = 1 + eps*exp(tau)\"\n");
        const std::string heading = "[equations]\n";
        file.replace(file.find(heading), heading.size(), functions);
        const Normalization n = normalize_poincare(test::field_from(file), 4);
        const Certificate c = certificate_of(n);
        EXPECT_TRUE(c.holds) << equation << ": " << c.complaint;
    }
}

// The coefficients of a normal form at tau = 0, by the exponents of i, z1, z2 and eps.
std::map<std::vector<int>, double> values_at_zero(const std::string& exponential, const std::string& sine) {
    const auto field = test::field_from(test::oscillator_file(
        "x'' + (1 + " + exponential + ")*x + (" + sine + ")*x^2 + x^3 = 0",
        "tau = { role = \"slow\" }\n[domain]\npositive = [\"1 + " + exponential + "\"]\n",
        "tau = \"tau' = eps\"\n"));
    const Normalization n = normalize_poincare(field, 4);
    const Ring& ring = *field->ring;
    std::vector<double> point(static_cast<std::size_t>(ring.size()), 1);
    std::map<std::vector<int>, double> sums;
    const auto evaluate = [&](const Polynomial& p) {
        std::map<std::vector<int>, double> here;
        for (const Term& t : p.terms()) {
            std::vector<int> key;
            double value = cln::double_approx(t.coefficient);
            for (GeneratorId id = 0; id < ring.size(); ++id) {
                const int e = ring.exponent(t.monomial, id);
                if (id <= field->eps) key.push_back(e);
                if (e != 0) value *= std::pow(point[static_cast<std::size_t>(id)], e);
            }
            here[key] += value;
        }
        return here;
    };
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        double& value = point[static_cast<std::size_t>(id)];
        if (g.kind == GeneratorKind::slow ||
            (g.kind == GeneratorKind::function && g.of.function == Function::sine))
            value = 0;
        if (g.kind == GeneratorKind::root)
            value = std::pow(evaluate(g.radicand).begin()->second, 1.0 / g.index);
    }
    for (int weight = 1; weight <= 4; ++weight)
        for (const auto& [key, value] : evaluate(n.normal_form.mode[0].part(weight)))
            if (std::abs(value) > 1e-12) sums[key] = value;
    return sums;
}

// exp and sin against their Taylor polynomials, which have the same derivatives at tau = 0 as far as these
// weights take any.
TEST(FunctionCoefficients, AgreeWithTaylorPolynomials) {
    const auto exact = values_at_zero("exp(tau)", "sin(tau)");
    const auto taylor = values_at_zero("1 + tau + tau^2/2 + tau^3/6 + tau^4/24", "tau - tau^3/6");
    EXPECT_GT(exact.size(), 3U);
    ASSERT_EQ(exact.size(), taylor.size());
    for (const auto& [key, value] : exact) {
        ASSERT_EQ(taylor.count(key), 1U);
        EXPECT_NEAR(value, taylor.at(key), 1e-12);
    }
}

} // namespace
} // namespace resonform
