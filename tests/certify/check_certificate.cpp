// SPDX-License-Identifier: GPL-3.0-or-later
// Every lie is found: each coefficient of normal form and map in turn is changed, a kernel term of each
// weight is planted; and every honest normal form of random systems is certified.
#include "normalize/lies.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

using test::certificate_of;
using test::expect_all_lies_found;

// Adds w^(a+shift) wbar^a eps^rest of each weight to one map, shift = 1 for a mode and 0 for a drift.
void expect_kernel_terms_found(Normalization& n, Series& map, int shift, int from) {
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    const Mode& mode = field.modes[0];
    for (int weight = from; weight <= n.map.through; ++weight) {
        const Polynomial truth = map.part(weight);
        for (int a = 0; 2 * a + shift <= weight; ++a) {
            const Polynomial modes = ring.multiply(ring.gen(mode.z, a + shift), ring.gen(mode.zbar, a));
            const Polynomial planted = ring.multiply(modes, ring.gen(field.eps, weight - 2 * a - shift));
            map.set(weight, truth + Rational(1) / 7 * planted);
            const Certificate c = certificate_of(n);
            EXPECT_FALSE(c.holds) << "weight " << weight << ", a = " << a;
            EXPECT_FALSE(c.normal_form_scan) << "weight " << weight << ", a = " << a;
        }
        map.set(weight, truth);
    }
}

// A real mode, an oscillator that is forced and pushes a slow variable, an angle, a drift.
TEST(CertificateLies, InEveryKindOfVariableAreFound) {
    const auto field = test::field_from(test::oscillator_file(
        "x'' + x + x^2 = eps*cos(p)",
        "y = { role = \"fast\" }\nJ = { role = \"slow\", positive = true }\np = { role = \"angle\" }\n"
        "X = { role = \"drift\" }\n",
        "y = \"y' = -y + x^2\"\nJ = \"J' = eps*sin(p) + x*x'\"\np = \"p' = 2*J + eps*x\"\n"
        "X = \"X' = x*sin(p)\"\n"));
    EXPECT_GT(expect_all_lies_found(normalize_poincare(field, 2)), 100);
}

TEST(CertificateLies, EveryCoefficientOfDuffing) {
    EXPECT_GE(expect_all_lies_found(normalize_poincare(test::duffing(), 7)), 57);
}

TEST(CertificateLies, EveryCoefficientOfThePendulum) {
    EXPECT_GE(expect_all_lies_found(normalize_poincare(test::pendulum(), 4)), 200);
}

TEST(CertificateLies, KernelTermsOfEveryWeight) {
    Normalization n = normalize_poincare(test::pendulum(), 5);
    expect_kernel_terms_found(n, n.map.mode[0], 1, 2);
    for (Series& map : n.map.drift) expect_kernel_terms_found(n, map, 0, 1);
}

// A coefficient whose value is right at one root and wrong at the others: sigma^2 for -sigma^2.
TEST(CertificateLies, TheSignOfARoot) {
    Normalization n = normalize_poincare(test::pendulum(), 3);
    const Ring& ring = *n.normal_form.field->ring;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (ring.generator(id).kind != GeneratorKind::root) continue;
        Normalization lie = n;
        for (const test::SeriesOfForm& item : test::all_series(lie))
            for (int weight = 0; weight <= item.series->through(); ++weight) {
                std::vector<Term> terms = item.series->part(weight).terms();
                for (Term& t : terms)
                    if (ring.exponent(t.monomial, id) % 2 != 0) t.coefficient = -t.coefficient;
                item.series->set(weight, Polynomial::from_terms(std::move(terms)));
            }
        EXPECT_FALSE(certificate_of(lie).holds) << ring.generator(id).name;
    }
}

// A polynomial in x, x', eps of weights 2 ... 5 with random rational coefficients.
std::string random_force(std::mt19937_64& random) {
    std::string text;
    for (int k = 0; k < 6; ++k) {
        const int weight = 2 + static_cast<int>(random() % 4);
        int powers[3] = {0, 0, 0};
        for (int j = 0; j < weight; ++j) ++powers[random() % 3];
        text += (random() % 2 == 0 ? " + " : " - ") + std::to_string(1 + random() % 9) + "/" +
                std::to_string(1 + random() % 9) + "*x^" + std::to_string(powers[0]) + "*x'^" +
                std::to_string(powers[1]) + "*eps^" + std::to_string(powers[2]);
    }
    return text;
}

TEST(CertificateHolds, ForRandomPolynomialOscillators) {
    std::mt19937_64 random(2026);
    for (int k = 0; k < 12; ++k) {
        const std::string equation = "x'' + w^2*x" + random_force(random) + " = 0";
        const auto field =
            test::field_from(test::oscillator_file(equation, "", "", "w = { positive = true }\n"));
        const Certificate c = certificate_of(normalize_poincare(field, 5));
        EXPECT_TRUE(c.holds) << equation << ": " << c.complaint;
        EXPECT_LE(c.error_probability, 1e-20);
    }
}

TEST(CertificateHolds, ForRandomOscillatorsWithASlowVariableAndADrift) {
    std::mt19937_64 random(7);
    const std::string variables = "tau = { role = \"slow\" }\nX = { role = \"drift\" }\n";
    for (int k = 0; k < 6; ++k) {
        const std::string equation = "x'' + (2 + tau^2)*x + (1 + tau)*(" + random_force(random) + ") = 0";
        const std::string rates =
            "tau = \"tau' = eps*(1 - tau/2)\"\nX = \"X' = x + eps*tau" + random_force(random) + "\"\n";
        const auto field = test::field_from(test::oscillator_file(equation, variables, rates));
        const Certificate c = certificate_of(normalize_poincare(field, 4));
        EXPECT_TRUE(c.holds) << equation << "; " << rates << ": " << c.complaint;
    }
}

// All elementary functions and powers that the expansion knows, in implicit equations.
TEST(CertificateHolds, ForElementaryFunctionsAndRoots) {
    const std::string parameters = "a = { positive = true }\nb = { positive = true }\n";
    for (const std::string equation :
         {"(1 + x^2)*x'' + sin(x)*exp(x') = 0", "x'' + tan(x) + tanh(x')*x = 0",
          "x'' + sinh(x)*cosh(x') + eps*log(1 + x) = 0", "x'' + asin(x) + atan(x)*x' = 0",
          "x'' + cos(x)*x/(1 - x) = 0", "x'' + a*x/sqrt(1 + x) + b*x^2 = 0", "x'' + 2*x + x^2 = 0",
          "x'' + 3/2*x + eps*x' + x^3 = 0", "x'' + sqrt(a)*x + (a + b)^(1/3)*x^2 = 0",
          "x'' + sqrt(2)*x + sqrt(a*b)*x*x' = 0", "x'' + sqrt(4*a^2 + 8*a*b + 4*b^2)*x + x^3 = 0",
          "x'' + a*x + (a + x)^(3/2)*x^2 = 0", "sqrt(12)*x'' + x/sqrt(3) + x^3 = 0",
          "x'' + sqrt(a + sqrt(b))*x + x^3 = 0"}) {
        const auto field = test::field_from(test::oscillator_file(equation, "", "", parameters));
        const Normalization n = normalize_poincare(field, 5);
        const Certificate c = certificate_of(n);
        EXPECT_TRUE(c.holds) << equation << ": " << c.complaint;
        EXPECT_LE(c.error_probability, 1e-20) << equation;
        EXPECT_GT(expect_all_lies_found(normalize_poincare(field, 2)), 0) << equation;
    }
}

} // namespace
} // namespace resonform
