// SPDX-License-Identifier: GPL-3.0-or-later
// The number pi in coefficients: a positive transcendental constant; sines of its fractions; asin and acos of
// what does not vanish at the origin.
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::expect_same;
using test::field_from;

std::string pi_file(const std::string& equation, const std::string& parameters = "",
                    const std::string& domain = "") {
    return test::oscillator_file(equation, "s = { role = \"slow\" }\n", "s = \"s' = eps\"\n", parameters) +
           (domain.empty() ? "" : "[domain]\npositive = [\"" + domain + "\"]\n");
}

TEST(Pi, OfDuffing) {
    const auto field = field_from(pi_file("x'' + pi^2*x + pi/2*x^3 = 0"));
    const Normalization n = test::certified(field);
    EXPECT_EQ(test::coefficient_of(*field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}}),
              test::coefficient(*field, "3/16", true));
    EXPECT_EQ(test::coefficient_of(*field, n.normal_form.mode[0], {{"z1", 1}}),
              test::coefficient(*field, "pi", true));
}

// As a positive parameter whatever its value.
TEST(Pi, IsLikeAParameter) {
    const auto equation = [](const std::string& p) {
        return "x'' + (" + p + "^2 + s^2)*x + sqrt(" + p + ")*x^2 + sin(" + p + "*s + x)*x^2 + exp(x/" + p +
               ")*x^3 = eps*x'/(1 + " + p + ")";
    };
    expect_same(test::certified(field_from(pi_file(equation("pi")))),
                test::certified(field_from(pi_file(equation("p"), "p = { positive = true }\n"))));
}

TEST(Pi, FractionsOfATurnAreRoots) {
    expect_same(
        test::certified(field_from(
            pi_file("x'' + x = x^2*cos(s + pi/3) + x*sin(x - pi/4)*sqrt(2) + x + pi*sqrt(2)*x^3"))),
        test::certified(field_from(pi_file(
            "x'' + x = x^2*(cos(s) - sqrt(3)*sin(s))/2 + x*(sin(x) - cos(x)) + x + pi*sqrt(2)*x^3"))));
    test::certified(field_from(pi_file("x'' + x = x^2*sin(s + pi/12 - pi/3) + eps*acos(x)*x")));
    const Error error = test::error_when([&] { field_from(pi_file("x'' + x = x^2*cos(s + pi/7)")); });
    EXPECT_EQ(error.diagnostic().rule,
              "sines and cosines of multiples of pi are those of multiples of pi/12 and pi/10");
    EXPECT_EQ(error.diagnostic().value, "sin(1/7*pi)");
}

DivisorVerdict verdict_of(const std::string& second) {
    const auto field = field_from(test::oscillator_file("x'' + pi^2*x + y^2 = 0", "y = { role = \"fast\" }\n",
                                                        "y = \"y'' + (" + second + ")^2*y + x^2 = 0\"\n"));
    const Normalization n = test::certified(field, 2);
    const Monomial squared = field->ring->monomial(field->modes[0].z, 2);
    for (const DivisorRecord& record : n.divisors)
        if (record.variable == "z3" && record.monomial == squared) return record.verdict;
    return DivisorVerdict::ambiguous;
}

TEST(Pi, IsNoAlgebraicNumber) {
    EXPECT_EQ(verdict_of("2*pi"), DivisorVerdict::kept_exact);
    EXPECT_EQ(verdict_of("710/113"), DivisorVerdict::removed);
    EXPECT_EQ(verdict_of("2*sqrt(2) + 2*sqrt(3)"), DivisorVerdict::removed);
    const auto field = field_from(pi_file("x'' + x = (exp(1) + log(2) + pi + exp(s))*x^2"));
    for (GeneratorId id = 0; id < field->ring->size(); ++id) {
        const Generator& g = field->ring->generator(id);
        const bool constant = g.name == "exp(1)" || g.name == "log(2)";
        EXPECT_EQ(g.independent, !constant) << g.name;
    }
    test::certified(field);
}

TEST(Pi, ArcSinesAreArcTangents) {
    const auto direct = [](const std::string& f) { return field_from(pi_file(f, "a = {}\n", "1 - a^2")); };
    expect_same(
        test::certified(direct("x'' + x = asin(a)*x^2 + eps*asin(a)^2*x")),
        test::certified(direct("x'' + x = atan(a/sqrt(1 - a^2))*x^2 + eps*atan(a/sqrt(1 - a^2))^2*x")));
    test::certified(direct("x'' + x = acos(a)*x^2"));
    test::certified(direct("x'' + x = asin(a + x)*x^2"));
    test::certified(field_from(pi_file("x'' + x = asin(1/3 + x)*x^2 - acos(1/3)*x^2 + asin(1/2)*x^3")));
    test::certified(field_from(pi_file("x'' + x = asin(s/2 + x)*x^2 + acos(s/2)*x^2", "", "4 - s^2")));
}

TEST(Pi, ArcSinesAreOfWhatLiesBetween) {
    const Error error = test::error_when([&] { field_from(pi_file("x'' + x = acos(a)*x^2", "a = {}\n")); });
    const Diagnostic& d = error.diagnostic();
    EXPECT_EQ(d.rule, "an arcsine or arccosine is taken only of what is proved to lie between -1 and 1");
    EXPECT_EQ(d.value, "a");
    EXPECT_EQ(d.hint, "declare what is positive: positive = true for a name in it, or [domain] positive = "
                      "[\"-a^2 + 1\"]");
}

// Squares are looked for in what pi and a parameter are factors of.
TEST(Pi, InACoupledBlockWithAParameter) {
    const Normalization n = test::certified(
        field_from("[system]\nname = \"test\"\n[parameters]\na = { positive = true }\n[variables]\n"
                   "x = { role = \"fast\" }\ny = { role = \"fast\" }\npx = { role = \"fast\" }\n"
                   "py = { role = \"fast\" }\n[hamiltonian]\n"
                   "energy = \"px^2/pi + py^2/2 - x^2/2 + y^2 + a*x*py\"\n"
                   "momenta = { x = \"px\", y = \"py\" }\n"),
        2);
    EXPECT_EQ(n.normal_form.mode.size(), 3U); // a saddle and a centre
}

} // namespace
} // namespace resonform
