// SPDX-License-Identifier: GPL-3.0-or-later
// The normalised system (20) of Kuleshov and Vidov, and the weight-4 term that their psi lacks.
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

using test::coefficient;
using test::monomial;

class PendulumNormalForm : public ::testing::Test {
protected:
    std::shared_ptr<const GradedField> field = test::field_named("almost_holonomic_pendulum");
    Normalization n = normalize_poincare(field, 4);

    [[nodiscard]] Polynomial term(const std::string& text, bool times_i,
                                  const std::vector<std::pair<std::string, int>>& powers) const {
        return field->ring->multiply(coefficient(*field, text, times_i), monomial(*field->ring, powers));
    }
};

} // namespace

TEST_F(PendulumNormalForm, Equation20OfTheMode) {
    const Series& z1 = n.normal_form.mode[0];
    EXPECT_TRUE(z1.part(0).empty());
    EXPECT_EQ(z1.part(1), term("sqrt(g)*(xi^2 + r^2)^(-1/4)", true, {{"z1", 1}}));
    EXPECT_EQ(z1.part(2), term("-xi*v/(4*(xi^2 + r^2))", false, {{"z1", 1}, {"eps", 1}}));
    EXPECT_EQ(z1.part(3), term("-xi^2*v^2/(32*sqrt(g)*(xi^2 + r^2)^(7/4))", true, {{"z1", 1}, {"eps", 2}}) +
                              term("-sqrt(g)/16*(xi^2 + r^2)^(-1/4)", true, {{"z1", 2}, {"z2", 1}}));
}

TEST_F(PendulumNormalForm, Equation20OfTheDrifts) {
    const Series& x = n.normal_form.drift[0];
    const Series& y = n.normal_form.drift[1];
    EXPECT_TRUE(x.part(2).empty());
    EXPECT_TRUE(y.part(2).empty());
    EXPECT_EQ(x.part(3), term("-r*xi^2*v^3/(g*(xi^2 + r^2)^2)", false, {{"eps", 3}}) +
                             term("-r*v/(4*sqrt(xi^2 + r^2))", false, {{"z1", 1}, {"z2", 1}, {"eps", 1}}));
    EXPECT_EQ(y.part(3), term("r^2*xi*v^3/(g*(xi^2 + r^2)^2)", false, {{"eps", 3}}) +
                             term("-xi*v/(4*sqrt(xi^2 + r^2))", false, {{"z1", 1}, {"z2", 1}, {"eps", 1}}));
}

// xi (2 r^2 - xi^2) xi'^3 / (128 g s^(5/2)) z1: acting over 1/eps it spoils the fourth order of (22).
TEST_F(PendulumNormalForm, WeightFourTermThatThePaperLeavesOut) {
    EXPECT_EQ(n.normal_form.mode[0].part(4),
              term("xi*(2*r^2 - xi^2)*v^3/(128*g*(xi^2 + r^2)^(5/2))", false, {{"z1", 1}, {"eps", 3}}));
}

TEST_F(PendulumNormalForm, EveryDivisorHasAVerdict) {
    ASSERT_FALSE(n.divisors.empty());
    for (const DivisorRecord& d : n.divisors) {
        const bool kept = d.verdict == DivisorVerdict::kept_exact;
        EXPECT_EQ(kept, d.divisor.empty()) << d.variable;
        EXPECT_TRUE(kept || d.verdict == DivisorVerdict::removed);
    }
}

TEST(Normalize, RefusesAbsurdOrders) {
    const auto field = test::field_named("almost_holonomic_pendulum");
    EXPECT_THROW(normalize_poincare(field, 0), Error);
    EXPECT_THROW(normalize_poincare(field, 100), Error);
}

} // namespace resonform
