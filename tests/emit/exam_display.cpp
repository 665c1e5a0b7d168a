// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of a ring written by hand, and how they are to be read.
#include "emit/display/json.hpp"
#include "emit/display/latex.hpp"
#include "emit/display/names_apart.hpp"
#include "emit/display/page.hpp"
#include "emit/display/spelling.hpp"
#include "printed.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

class DisplayExam : public ::testing::Test {
protected:
    [[nodiscard]] std::string json(const Polynomial& p) const { return json_expression(*s.ring, p); }
    [[nodiscard]] std::string text(const Polynomial& p) const {
        return spell(display(*s.ring, p), text_spelling());
    }

    PrintedRing s;
};

TEST_F(DisplayExam, NumbersAndZero) {
    EXPECT_EQ(json(Polynomial()), "0");
    EXPECT_EQ(json(s.ring->one()), "1");
    EXPECT_EQ(json(Rational(-3) / 4 * s.ring->one()), "-3/4");
    EXPECT_EQ(json(s.ring->imaginary()), "I");
    EXPECT_EQ(json(Rational(-1) / 2 * s.ring->imaginary()), "-I/2");
}

TEST_F(DisplayExam, RootsAreRationalPowersOfTheirRadicands) {
    EXPECT_EQ(json(s.product({{s.G, 1}})), "sqrt(g)");
    EXPECT_EQ(json(s.product({{s.G, 3}})), "g**(3/2)");
    EXPECT_EQ(json(s.product({{s.g, 2}})), "g**2");
    EXPECT_EQ(json(s.product({{s.sigma, 2}})), "(r**2 + xi**2)**(1/2)");
    EXPECT_EQ(text(s.product({{s.sigma, 2}})), "sqrt(r^2 + xi^2)");
    EXPECT_EQ(json(s.product({{s.sigma, 4}})), "r**2 + xi**2");
    EXPECT_EQ(json(-s.product({{s.sigma, 4}})), "-(r**2 + xi**2)");
    EXPECT_EQ(json(s.product({{s.G, -1}, {s.sigma, -7}})), "1/(sqrt(g)*(r**2 + xi**2)**(7/4))");
}

TEST_F(DisplayExam, EliminatedPowersComeBack) {
    // xi^2 is held as sigma^4 - r^2.
    EXPECT_EQ(json(s.product({{s.xi, 2}})), "xi**2");
    EXPECT_EQ(json(s.product({{s.xi, 5}, {s.sigma, -10}})), "xi**5/(r**2 + xi**2)**(5/2)");
}

TEST_F(DisplayExam, TheWeightFourTermOfThePendulum) {
    // xi (2 r^2 - xi^2) v^3/(128 g s^(5/2))
    const Polynomial numerator = Rational(2) * s.product({{s.r, 2}}) - s.product({{s.xi, 2}});
    const Polynomial p = s.ring->multiply(
        Rational(1) / 128 * s.product({{s.xi, 1}, {s.v, 3}, {s.G, -2}, {s.sigma, -10}}), numerator);
    EXPECT_EQ(json(p), "v**3*xi*(2*r**2 - xi**2)/(128*g*(r**2 + xi**2)**(5/2))");
    EXPECT_EQ(latex(display(*s.ring, p)), "\\frac{v^{3} \\xi \\left(2 r^{2} - \\xi^{2}\\right)}"
                                          "{128 g \\left(r^{2} + \\xi^{2}\\right)^{5/2}}");
}

TEST_F(DisplayExam, SumsOfDifferentRoots) {
    const Polynomial p = s.product({{s.v, 1}, {s.sigma, -1}}) +
                         s.ring->multiply(s.ring->imaginary(), s.product({{s.v, 2}, {s.sigma, -6}}));
    EXPECT_EQ(json(p), "v/(r**2 + xi**2)**(1/4) + I*v**2/(r**2 + xi**2)**(3/2)");
    const DisplayTerm one = factored(display(*s.ring, p));
    DisplaySum sum;
    sum.terms.push_back(one);
    EXPECT_EQ(spell(sum, text_spelling()), "v*((r^2 + xi^2)^(5/4) + I*v)/(r^2 + xi^2)^(3/2)");
}

TEST_F(DisplayExam, CommonFactorsOfALogarithm) {
    const Polynomial p = s.product({{s.xi, 1}, {s.r, -1}}) + s.product({{s.sigma, 2}, {s.r, -1}});
    DisplaySum argument;
    argument.terms.push_back(factored(display(*s.ring, p)));
    const DisplaySum logarithm = factor_sum(function_factor("log", argument));
    EXPECT_EQ(spell(logarithm, text_spelling()), "log((xi + sqrt(r^2 + xi^2))/r)");
    EXPECT_EQ(latex(logarithm), "\\ln \\left(\\frac{\\xi + \\sqrt{r^{2} + \\xi^{2}}}{r}\\right)");
}

// exp(c*T)^n, exp(-a*log(tau)/2) and their products as a reader writes them.
TEST_F(DisplayExam, ExponentialsAreMerged) {
    const auto half = [](const char* name, int numerator) {
        DisplaySum sum = symbol_sum(name);
        sum.terms.front().coefficient = Rational(numerator) / 2;
        return sum;
    };
    const auto product = [](std::vector<DisplayFactor> factors) {
        DisplaySum sum = factor_sum(factors.front());
        sum.terms.front().factors = std::move(factors);
        return sum;
    };
    DisplayFactor cubed = function_factor("exp", half("T", 1));
    cubed.exponent = 3;
    EXPECT_EQ(spell(factor_sum(cubed), text_spelling()), "exp(3*T/2)");
    EXPECT_EQ(latex(factor_sum(cubed)), "\\exp \\left(\\frac{3 T}{2}\\right)");
    const DisplayFactor decaying = function_factor("exp", half("T", -2));
    EXPECT_EQ(spell(product({cubed, symbol_factor("C"), decaying}), text_spelling()), "exp(T/2)*C");
    EXPECT_EQ(spell(product({symbol_factor("C"), cubed, decaying, function_factor("exp", half("T", -1))}),
                    text_spelling()),
              "C");

    DisplaySum exponent = half("a", -1);
    exponent.terms.front().factors.push_back(function_factor("log", symbol_sum("tau")));
    const DisplayFactor power = function_factor("exp", exponent);
    EXPECT_EQ(spell(factor_sum(power), text_spelling()), "tau^(-a/2)");
    EXPECT_EQ(spell(factor_sum(power), json_spelling()), "tau**(-a/2)");
    EXPECT_EQ(latex(factor_sum(power)), "\\tau^{-\\frac{a}{2}}");
    DisplayFactor squared = power;
    squared.exponent = -2;
    EXPECT_EQ(spell(factor_sum(squared), text_spelling()), "tau^a");

    DisplaySum root = factor_sum(function_factor("log", symbol_sum("tau") + number_sum(1)));
    root.terms.front().coefficient = Rational(-1) / 2;
    EXPECT_EQ(spell(factor_sum(function_factor("exp", root)), text_spelling()), "1/sqrt(tau + 1)");
    EXPECT_EQ(spell(factor_sum(function_factor("exp", root + symbol_sum("T"))), text_spelling()),
              "exp(T)/sqrt(tau + 1)");
}

TEST_F(DisplayExam, MonomialsStandBehindTheirCoefficients) {
    const Polynomial p =
        s.ring->multiply(s.ring->imaginary(),
                         Rational(-1) / 16 * s.product({{s.G, 1}, {s.sigma, -1}, {s.z1, 2}, {s.z2, 1}})) +
        s.product({{s.z1, 1}}) - Rational(1) / 4 * s.product({{s.z1, 1}, {s.eps, 1}});
    const DisplaySum sum = display_collected(*s.ring, p, {s.z1, s.z2, s.eps});
    EXPECT_EQ(spell(sum, text_spelling()), "z1 - 1/4*z1*eps - I*sqrt(g)/(16*(r^2 + xi^2)^(1/4))*z1^2*z2");
    EXPECT_EQ(spell(sum, maxima_spelling()), "z1 - 1/4*z1*eps - %i*sqrt(g)/(16*(r^2 + xi^2)^(1/4))*z1^2*z2");
    EXPECT_EQ(spell(sum, python_spelling()),
              "z1 - Rational(1, 4)*z1*eps - I*sqrt(g)/(16*(r**2 + xi**2)**Rational(1, 4))*z1**2*z2");
    EXPECT_EQ(latex(sum), "z_{1} - \\frac{1}{4} z_{1} \\varepsilon - \\frac{i \\sqrt{g}}"
                          "{16 \\left(r^{2} + \\xi^{2}\\right)^{1/4}} z_{1}^{2} z_{2}");
}

TEST(DisplayRoots, OfNumbersAndOfProducts) {
    RingBuilder b;
    const GeneratorId a = b.add(named(GeneratorKind::parameter, "a", true));
    const GeneratorId c = b.add(named(GeneratorKind::parameter, "c"));
    const GeneratorId two = b.add(root_of("two", 2, Polynomial(Rational(2))));
    const GeneratorId square = b.add(root_of("square", 2, b.gen(a, 2) + b.gen(c)));
    const RingPtr ring = b.freeze();
    EXPECT_EQ(json_expression(*ring, ring->gen(two)), "sqrt(2)");
    EXPECT_EQ(json_expression(*ring, ring->gen(two, -1)), "sqrt(2)/2");
    EXPECT_EQ(json_expression(*ring, ring->multiply(ring->gen(c), ring->gen(square, -3))),
              "c/(a**2 + c)**(3/2)");
}

TEST(LatexNames, GreekSubscriptsAndDots) {
    EXPECT_EQ(latex_name("xi", 1), "\\dot{\\xi}");
    EXPECT_EQ(latex_name("psi", 2), "\\ddot{\\psi}");
    EXPECT_EQ(latex_name("q", 3), "q^{(3)}");
    EXPECT_EQ(latex_name("lambda1"), "\\lambda_{1}");
    EXPECT_EQ(latex_name("x_2"), "x_{2}");
    EXPECT_EQ(latex_name("C_delta"), "C_{\\delta}");
    EXPECT_EQ(latex_name("z_X", 1), "\\dot{z}_{X}");
    EXPECT_EQ(latex_name("alpha"), "\\alpha");
    EXPECT_EQ(latex_name("gain"), "\\mathrm{gain}");
    EXPECT_EQ(latex_name("omega12_max"), "\\omega_{12,\\mathrm{max}}");
    EXPECT_EQ(latex_name("eps"), "\\varepsilon");
    EXPECT_EQ(latex_text("a_b % {c}"), "a\\_b \\% \\{c\\}");
}

// On one page; x_2 alone is x_{2}.
TEST(LatexNames, ThatWouldPrintAlikeAreSetApart) {
    const auto printed = [](const std::string& left, const std::string& right) {
        Page page{"names", {Section{}}, {}};
        define(page.sections.front(), left, symbol_sum(right));
        return page_latex(with_names_apart(page));
    };
    test::expect_part(printed("x2", "x_2'"), "\n  x_{2} &= \\dot{x}_{(2)}\n");
    test::expect_part(printed("x_2", "x2"), "\n  x_{(2)} &= x_{2}\n");
    test::expect_part(printed("x_2", "x"), "\n  x_{2} &= x\n");
    test::expect_part(printed("w_12_max", "w12_max"),
                      "\n  w_{(12),(\\mathrm{max})} &= w_{12,\\mathrm{max}}\n");
    test::expect_part(printed("x_", "x"), "\n  x_{()} &= x\n");
}

} // namespace
} // namespace resonform::test
