// SPDX-License-Identifier: GPL-3.0-or-later
// Known primitives over s = x^2 + r^2.
#include "solve/quadrature.hpp"
#include "solve/rings.hpp"
#include "support/generators.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using resonform::test::named;
using resonform::test::root_of;
using resonform::testing::EighthRoot;

namespace {

const Rational half = Rational(1) / 2;

TEST(Quadrature, ClosesAPowerTimesX) {
    const EighthRoot e; // x s^(-3/4) -> 2 s^(1/4)
    const auto closed = close_primitive(*e.ring, e.x, e.term(1, 0, 0, 1, -6));
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->algebraic, e.term(2, 0, 0, 0, 2));
    EXPECT_TRUE(closed->logarithmic.empty());
}

TEST(Quadrature, ClosesSeveralTermsAtOnce) {
    const EighthRoot e; // v^2 x (2 r^2 - x^2) s^(-5/2) -> v^2 x^2 s^(-3/2)
    const Polynomial f = e.term(2, 2, 2, 1, -20) - e.term(1, 0, 2, 3, -20);
    const auto closed = close_primitive(*e.ring, e.x, f);
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->algebraic, e.term(1, 0, 2, 2, -12));
}

TEST(Quadrature, FindsNeighboursOfTheOtherSign) {
    const EighthRoot e; // s^(-5/2) -> x s^(-3/2)/(3 r^2) + 2 x s^(-1/2)/(3 r^4)
    const auto closed = close_primitive(*e.ring, e.x, e.term(1, 0, 0, 0, -20));
    ASSERT_TRUE(closed);
    const Rational third = Rational(1) / 3;
    EXPECT_EQ(closed->algebraic, e.term(third, -2, 0, 1, -12) + e.term(2 * third, -4, 0, 1, -4));
}

TEST(Quadrature, ClosesAlongAClockWhoseSpeedMayVanish) {
    const EighthRoot e; // x' = v - x:  F = (v - x)^2 x^2 s^-3
    const Polynomial speed = e.term(1, 0, 1, 0, 0) - e.term(1, 0, 0, 1, 0);
    const Polynomial expected = e.ring->multiply(e.ring->power(speed, 2), e.term(1, 0, 0, 2, -24));
    const Polynomial f = e.ring->multiply(speed, e.ring->derivative(expected, e.x));
    const auto closed = close_primitive(*e.ring, e.x, f, speed);
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->algebraic, expected);
    EXPECT_TRUE(closed->logarithmic.empty());
    EXPECT_FALSE(close_primitive(*e.ring, e.x, e.term(1, 0, 0, 0, 0), speed)); // the time itself
}

TEST(Quadrature, FindsTheCatenary) {
    const EighthRoot e; // r s^(-1/2) -> r log((x + s^(1/2))/r)
    const auto closed = close_primitive(*e.ring, e.x, e.term(1, 1, 0, 0, -4));
    ASSERT_TRUE(closed);
    EXPECT_TRUE(closed->algebraic.empty());
    ASSERT_EQ(closed->logarithmic.size(), 1U);
    EXPECT_EQ(closed->logarithmic.front().first, e.term(1, 1, 0, 0, 0));
    EXPECT_EQ(closed->logarithmic.front().second.argument, e.term(1, -1, 0, 1, 0) + e.term(1, -1, 0, 0, 4));
    EXPECT_EQ(closed->logarithmic.front().second.derivative, e.term(1, 0, 0, 0, -4));
}

TEST(Quadrature, CombinesLogarithmAndPowers) {
    const EighthRoot e; // s^(1/2) -> x s^(1/2)/2 + r^2/2 log((x + s^(1/2))/r)
    const auto closed = close_primitive(*e.ring, e.x, e.term(1, 0, 0, 0, 4));
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->algebraic, e.term(half, 0, 0, 1, 4));
    ASSERT_EQ(closed->logarithmic.size(), 1U);
    EXPECT_EQ(closed->logarithmic.front().first, e.term(half, 2, 0, 0, 0));
}

TEST(Quadrature, FindsTheLogarithmOfARadicand) {
    const EighthRoot e; // v x/s -> v/2 log(s/r^2)
    const auto closed = close_primitive(*e.ring, e.x, e.term(1, 0, 1, 1, -8));
    ASSERT_TRUE(closed);
    ASSERT_EQ(closed->logarithmic.size(), 1U);
    EXPECT_EQ(closed->logarithmic.front().first, e.term(half, 0, 1, 0, 0));
    EXPECT_EQ(closed->logarithmic.front().second.argument, e.term(1, -2, 0, 0, 8));
}

// Of a positive x no power is eliminated: (x^2 + r^2)^(1/2) and (x^2 + r^2) s^(-1/2) are two forms of one
// function.
TEST(Quadrature, ClosesInARingThatIsNotCanonical) {
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    const GeneratorId sigma = b.add(root_of("sigma", 2, b.gen(x, 2) + b.gen(r, 2)));
    const RingPtr ring = b.freeze();
    const Polynomial f = ring->multiply(ring->gen(x), ring->gen(sigma, -1)); // x s^(-1/2) -> s^(1/2)
    const auto closed = close_primitive(*ring, x, f);
    ASSERT_TRUE(closed);
    EXPECT_TRUE(closed->logarithmic.empty());
    EXPECT_TRUE(ring->vanishes(closed->algebraic - ring->gen(sigma)));
}

TEST(Quadrature, CarriesNoHiddenConstant) {
    const EighthRoot e; // 2 x -> x^2, which the ring holds as rho^8 - r^2
    const auto closed = close_primitive(*e.ring, e.x, e.term(2, 0, 0, 1, 0));
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->algebraic, e.term(1, 0, 0, 2, 0));
}

TEST(Quadrature, LeavesArcTangentAndHypergeometricOpen) {
    const EighthRoot e;
    EXPECT_FALSE(close_primitive(*e.ring, e.x, e.term(1, 0, 0, 2, -16))); // x^2/s^2
    EXPECT_FALSE(close_primitive(*e.ring, e.x, e.term(1, 0, 0, 0, -6)));  // s^(-3/4)
}

TEST(Quadrature, UsesTheSquareWhereTheRootOfTheConstantIsNotInTheRing) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x"));
    const GeneratorId s = b.add(root_of("sigma", 4, b.gen(x, 2) + Polynomial(Rational(2))));
    const RingPtr ring = b.freeze();
    const auto closed = close_primitive(*ring, x, ring->gen(s, -2)); // 1/sqrt(x^2 + 2)
    ASSERT_TRUE(closed);
    ASSERT_EQ(closed->logarithmic.size(), 1U);
    EXPECT_EQ(closed->logarithmic.front().first, Polynomial(half));
    const Polynomial sum = ring->gen(x) + ring->gen(s, 2);
    EXPECT_EQ(closed->logarithmic.front().second.argument, half * ring->multiply(sum, sum));
}

TEST(Quadrature, WorksWhereTheSlowVariableIsNotEliminated) {
    RingBuilder b; // x > 0 is invertible, so x^2 stays and sigma^4 is rewritten
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    const GeneratorId s = b.add(root_of("sigma", 4, b.gen(x, 2) + Polynomial(Rational(1))));
    const RingPtr ring = b.freeze();
    const Polynomial expected = ring->multiply(ring->gen(x), ring->gen(s, -2));
    const auto closed = close_primitive(*ring, x, ring->derivative(expected, x));
    ASSERT_TRUE(closed);
    EXPECT_EQ(ring->is_zero(closed->algebraic - expected), Zero::yes);
    const auto logarithm = close_primitive(*ring, x, ring->gen(x, -1));
    ASSERT_TRUE(logarithm);
    ASSERT_EQ(logarithm->logarithmic.size(), 1U);
    EXPECT_EQ(logarithm->logarithmic.front().second.argument, ring->gen(x));
}

// x^2 is rho^2 - 1 where the other root came first: x/sqrt(x^2 + r^2) is the derivative of a root all the
// same.
TEST(Quadrature, ClosesBesideAnotherRootOfTheSameVariable) {
    for (const bool other_first : {true, false}) {
        RingBuilder b;
        const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
        const GeneratorId x = b.add(named(GeneratorKind::slow, "x"));
        const auto add_other = [&] { b.add(root_of("rho", 4, b.gen(x, 2) + Polynomial(Rational(1)))); };
        if (other_first) add_other();
        const GeneratorId s = b.add(root_of("sigma", 4, b.gen(x, 2) + b.gen(r, 2)));
        if (!other_first) add_other();
        const RingPtr ring = b.freeze();
        const auto closed = close_primitive(*ring, x, ring->multiply(ring->gen(x), ring->gen(s, -2)));
        ASSERT_TRUE(closed) << other_first;
        EXPECT_EQ(ring->is_zero(ring->derivative(closed->algebraic - ring->gen(s, 2), x)), Zero::yes);
    }
}

TEST(Quadrature, ClosesExponentials) {
    RingBuilder b; // e' = -2 e
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x"));
    Generator g = named(GeneratorKind::primitive, "e", true);
    g.derivatives.emplace_back(x, Rational(-2) * b.gen(2));
    const GeneratorId e = b.add(g);
    const RingPtr ring = b.freeze();
    const Polynomial expected = ring->multiply(ring->gen(x, 2) + ring->one(), ring->gen(e, 3));
    const auto closed = close_primitive(*ring, x, ring->derivative(expected, x));
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->algebraic, expected);
}

TEST(Quotient, DividesOutAFactorThatMayVanishButNeverByIt) {
    const EighthRoot e;
    const Polynomial v = e.ring->gen(e.v);
    const auto quotient = quotient_in_ring(*e.ring, e.term(3, 0, 2, 1, -8), v);
    ASSERT_TRUE(quotient);
    EXPECT_EQ(*quotient, e.term(3, 0, 1, 1, -8));
    EXPECT_FALSE(quotient_in_ring(*e.ring, e.term(1, 1, 0, 0, 0), v));
}

} // namespace
