// SPDX-License-Identifier: GPL-3.0-or-later
// Equation (16) of Kuleshov and Vidov, term by term.
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

using test::coefficient;
using test::monomial;

class Pendulum : public ::testing::Test {
protected:
    std::shared_ptr<const GradedField> field = test::field_named("almost_holonomic_pendulum");
};

// A polynomial of the jets, written over the ring of an EquationSeries.
Polynomial term(const EquationSeries& equations, const GradedField& field, const std::string& text,
                const std::vector<std::pair<std::string, int>>& powers) {
    return equations.ring->multiply(coefficient(*equations.coefficients, field.system(), text),
                                    monomial(*equations.ring, powers));
}

} // namespace

TEST_F(Pendulum, FrequencyIsThatOfASimplePendulum) {
    ASSERT_EQ(field->modes.size(), 1U);
    EXPECT_EQ(field->modes[0].omega, coefficient(*field, "sqrt(g)*(xi^2 + r^2)^(-1/4)"));
}

TEST_F(Pendulum, FieldHasNoLinearRemainder) {
    const FieldSeries series = evaluate_field(*field, 3);
    EXPECT_TRUE(series.mode[0].part(0).empty());
    EXPECT_TRUE(series.mode[0].part(1).empty());
    EXPECT_FALSE(series.mode[0].part(2).empty());
}

TEST_F(Pendulum, EveryGeneratorOfWeightZeroIsKnownByName) {
    EXPECT_TRUE(field->ring->find("xi").has_value());
    EXPECT_TRUE(field->ring->find("g").has_value());
    EXPECT_EQ(field->ring->generator(field->modes[0].z).conjugate, field->modes[0].zbar);
}

TEST_F(Pendulum, DriftsStartAtWeightOne) {
    const FieldSeries series = evaluate_field(*field, 1);
    const Polynomial eps = field->ring->gen(field->eps);
    EXPECT_EQ(series.drift[0].part(1),
              field->ring->multiply(coefficient(*field, "r*v/sqrt(xi^2 + r^2)"), eps));
    EXPECT_EQ(series.drift[1].part(1),
              field->ring->multiply(coefficient(*field, "xi*v/sqrt(xi^2 + r^2)"), eps));
}

TEST_F(Pendulum, Equation16) {
    const EquationSeries e = expand_equations(*field, 4);
    const auto line = [&](std::size_t k) { return e.lines[k].series; };
    EXPECT_TRUE(e.lines[0].implicit);
    EXPECT_EQ(line(0).part(1), term(e, *field, "xi^2 + r^2", {{"psi''", 1}}) +
                                   term(e, *field, "g*sqrt(xi^2 + r^2)", {{"psi", 1}}));
    EXPECT_EQ(line(0).part(2), term(e, *field, "xi*v", {{"psi'", 1}, {"eps", 1}}) -
                                   term(e, *field, "r*xi*v^2/(xi^2 + r^2)", {{"eps", 2}}));
    EXPECT_EQ(line(0).part(3), term(e, *field, "-g*sqrt(xi^2 + r^2)/6", {{"psi", 3}}));
    EXPECT_TRUE(line(0).part(4).empty());
    EXPECT_EQ(e.lines[0].next_weight, 5) << "(16) says O(eps^5)";
    EXPECT_EQ(line(2).part(2), term(e, *field, "-xi*v/sqrt(xi^2 + r^2)", {{"psi", 1}, {"eps", 1}}));
    EXPECT_EQ(line(2).part(3), term(e, *field, "-r*v/(2*sqrt(xi^2 + r^2))", {{"psi", 2}, {"eps", 1}}));
    EXPECT_EQ(line(3).part(3), term(e, *field, "-xi*v/(2*sqrt(xi^2 + r^2))", {{"psi", 2}, {"eps", 1}}));
}

TEST_F(Pendulum, NextWeightOfTheDriftsIsFour) {
    const EquationSeries e = expand_equations(*field, 3);
    EXPECT_EQ(e.lines[2].next_weight, 4);
    EXPECT_EQ(e.lines[3].next_weight, 4);
}

} // namespace resonform
