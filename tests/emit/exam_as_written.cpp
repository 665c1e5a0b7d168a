// SPDX-License-Identifier: GPL-3.0-or-later
// Equations of the file in the order of their author, as text and in LaTeX.
#include "emit/derive/document.hpp"
#include "emit/display/as_written.hpp"
#include "emit/display/latex.hpp"
#include "emit/display/spelling.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

WrittenEquation written(const std::string& text) {
    Equation equation;
    equation.text = text;
    return as_written(equation);
}

std::string text_of(const std::string& text) {
    const WrittenEquation equation = written(text);
    return spell(equation.left, text_spelling()) + " = " + spell(equation.right, text_spelling());
}

TEST(AsWritten, KeepsTheOrder) {
    EXPECT_EQ(text_of("(xi^2 + r^2)*psi'' + xi*xi'*psi' - r*xi*xi'^2/(xi^2 + r^2) = 0"),
              "(xi^2 + r^2)*psi'' + xi*xi'*psi' - r*xi*xi'^2/(xi^2 + r^2) = 0");
    EXPECT_EQ(text_of("x' = (r*cos(psi) - xi*sin(psi))/sqrt(xi^2 + r^2)*xi'"),
              "x' = (r*cos(psi) - xi*sin(psi))*xi'/sqrt(xi^2 + r^2)");
}

TEST(AsWritten, SignsPowersAndNumbers) {
    EXPECT_EQ(text_of("-x^2 - -y = 0.25*z"), "-x^2 + y = z/4");
    EXPECT_EQ(text_of("x = 2*(-3)*y/(4*z)"), "x = -3*y/(2*z)");
    EXPECT_EQ(text_of("x = y^(3/2)/z**-2"), "x = y^(3/2)*z^2");
    EXPECT_EQ(text_of("x = 0*y"), "x = 0");
    EXPECT_EQ(text_of("x = a - (b + c)"), "x = a - (b + c)");
    EXPECT_EQ(text_of("x = (2*r)^2"), "x = (2*r)^2");
}

TEST(AsWritten, TheRootOfASquareIsKept) {
    EXPECT_EQ(text_of("x = sqrt(y^2)"), "x = sqrt(y^2)");
    EXPECT_EQ(text_of("x = sqrt(y)^2"), "x = y");
}

TEST(AsWritten, InLatex) {
    EXPECT_EQ(latex(written("x = eps*atan(q/2) + exp(-tau)*log(1 + lambda1)").right),
              "\\varepsilon \\arctan \\left(\\frac{q}{2}\\right) + \\exp \\left(-\\tau\\right) "
              "\\ln \\left(1 + \\lambda_{1}\\right)");
}

TEST(AsWritten, ThePendulumInLatex) {
    const auto system = first_order_named("almost_holonomic_pendulum")->system;
    const std::string document = print_equations(*system, Format::latex);
    EXPECT_NE(document.find("\\left(\\xi^{2} + r^{2}\\right) \\ddot{\\psi} + \\xi \\dot{\\xi} \\dot{\\psi} + "
                            "g \\sqrt{\\xi^{2} + r^{2}} \\sin \\psi - "
                            "\\frac{r \\xi \\dot{\\xi}^{2}}{\\xi^{2} + r^{2}} &= 0"),
              std::string::npos)
        << document;
}

} // namespace
} // namespace resonform::test
