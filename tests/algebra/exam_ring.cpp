// SPDX-License-Identifier: GPL-3.0-or-later
// Known answers in the pendulum's ring and in rings whose relations are harder to read.
#include "algebra/number/error.hpp"
#include "algebra/ring/ring.hpp"
#include "rings.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using testing::add_root;
using testing::gen;
using testing::named;
using testing::text;

TEST(PendulumRing, EliminatesTheSquareOfTheSlowVariable) {
    const RingPtr ring = testing::pendulum_ring();
    const Polynomial s = gen(*ring, "xi", 2) + gen(*ring, "r", 2);
    EXPECT_EQ(s, gen(*ring, "sigma", 4)) << text(*ring, s);
    EXPECT_EQ(s.size(), 1U);
    EXPECT_EQ(gen(*ring, "g", -1), gen(*ring, "G", -2));
    EXPECT_EQ(ring->gen(Ring::imaginary_unit, -3), ring->imaginary());
}

TEST(PendulumRing, DifferentiatesRoots) {
    const RingPtr ring = testing::pendulum_ring();
    const GeneratorId xi = ring->find("xi").value(), g = ring->find("g").value(), r = ring->find("r").value();
    const Rational half = Rational(1) / 2;
    EXPECT_EQ(ring->derivative(gen(*ring, "sigma"), xi),
              half * ring->multiply(gen(*ring, "xi"), gen(*ring, "sigma", -3)));
    EXPECT_EQ(ring->derivative(gen(*ring, "sigma"), r),
              half * ring->multiply(gen(*ring, "r"), gen(*ring, "sigma", -3)));
    EXPECT_EQ(ring->derivative(gen(*ring, "G"), g), half * gen(*ring, "G", -1));
    EXPECT_EQ(ring->derivative(gen(*ring, "xi", 2), xi), Rational(2) * gen(*ring, "xi"));
    EXPECT_EQ(ring->derivative(gen(*ring, "g", 3), g), Rational(3) * gen(*ring, "g", 2));
}

TEST(PendulumRing, Inverts) {
    const RingPtr ring = testing::pendulum_ring();
    const Polynomial s = gen(*ring, "xi", 2) + gen(*ring, "r", 2);
    EXPECT_EQ(ring->inverse(s).value(), gen(*ring, "sigma", -4));
    const Polynomial p = Rational(3) * ring->multiply(ring->imaginary(), gen(*ring, "G"));
    EXPECT_EQ(ring->inverse(p).value(),
              Rational(-1) / Rational(3) * ring->multiply(ring->imaginary(), gen(*ring, "G", -1)));
    EXPECT_FALSE(ring->inverse(gen(*ring, "xi")));
    EXPECT_FALSE(ring->inverse(gen(*ring, "r") + ring->one()));
    EXPECT_FALSE(ring->inverse(Polynomial()));
}

TEST(PendulumRing, TakesRootsOfUnits) {
    const RingPtr ring = testing::pendulum_ring();
    const Rational half = Rational(1) / 2;
    const Polynomial s = gen(*ring, "xi", 2) + gen(*ring, "r", 2);
    const Polynomial p = Rational(4) * ring->multiply(ring->multiply(s, gen(*ring, "r", 2)), gen(*ring, "g"));
    const Polynomial root =
        Rational(2) *
        ring->multiply(ring->multiply(gen(*ring, "sigma", 2), gen(*ring, "r")), gen(*ring, "G"));
    EXPECT_EQ(ring->rational_power(p, half).value(), root);
    EXPECT_EQ(ring->rational_power(p, -half).value(), ring->inverse(root).value());
    EXPECT_EQ(ring->rational_power(p, Rational(3) / 2).value(), ring->power(root, 3));
    EXPECT_EQ(ring->rational_power(s, Rational(1) / 4).value(), gen(*ring, "sigma"));
    EXPECT_EQ(ring->rational_power(gen(*ring, "xi"), 2).value(), gen(*ring, "xi", 2));
    EXPECT_FALSE(ring->rational_power(gen(*ring, "r"), half));
    EXPECT_FALSE(ring->rational_power(Rational(-4) * ring->one(), half));
    EXPECT_FALSE(ring->rational_power(Rational(2) * ring->one(), half));
}

TEST(PendulumRing, ConjugatesEveryKind) {
    const RingPtr ring = testing::pendulum_ring();
    const Polynomial p = ring->multiply(ring->multiply(ring->imaginary(), gen(*ring, "z1", 3)),
                                        ring->multiply(gen(*ring, "z2"), gen(*ring, "u", -2)));
    const Polynomial expected = -ring->multiply(ring->multiply(ring->imaginary(), gen(*ring, "z2", 3)),
                                                ring->multiply(gen(*ring, "z1"), gen(*ring, "u", 2)));
    EXPECT_EQ(ring->conjugate(p), expected) << text(*ring, ring->conjugate(p));
}

TEST(PendulumRing, SplitsByWeight) {
    const RingPtr ring = testing::pendulum_ring();
    const Polynomial light = gen(*ring, "sigma", -1) + ring->one();
    const Polynomial heavy = ring->multiply(gen(*ring, "z1"), gen(*ring, "eps", 2));
    const std::vector<Polynomial> parts = ring->by_weight(light + heavy + gen(*ring, "z2", 7), 3);
    ASSERT_EQ(parts.size(), 4U);
    EXPECT_EQ(parts[0], light);
    EXPECT_TRUE(parts[1].empty());
    EXPECT_EQ(parts[3], heavy);
}

TEST(PendulumRing, CollectsCoefficients) {
    const RingPtr ring = testing::pendulum_ring();
    const GeneratorId z1 = ring->find("z1").value();
    const Polynomial p =
        ring->multiply(gen(*ring, "z1", 2), gen(*ring, "r") + ring->imaginary()) + gen(*ring, "v");
    const auto groups = ring->collect(p, {z1});
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].first, Monomial{});
    EXPECT_EQ(groups[0].second, gen(*ring, "v"));
    EXPECT_EQ(groups[1].first, ring->monomial(z1, 2));
    EXPECT_EQ(groups[1].second, gen(*ring, "r") + ring->imaginary());
}

TEST(PendulumRing, WritesRadicandsOutForDisplay) {
    const RingPtr ring = testing::pendulum_ring();
    const Polynomial p =
        ring->multiply(ring->multiply(gen(*ring, "sigma", -3), gen(*ring, "xi", 2)), gen(*ring, "G"));
    const auto form = ring->expanded_form(p);
    ASSERT_EQ(form.size(), 1U);
    EXPECT_EQ(text(*ring, Polynomial(form[0].first, 1)), "1*G^1*sigma^-3");
    EXPECT_EQ(text(*ring, form[0].second), "1*xi^2");
    // Different residues of root exponents stay apart; invertible parameters are factored out.
    const auto two = ring->expanded_form(p + Rational(2) * gen(*ring, "r", -3) + gen(*ring, "r", -1));
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(text(*ring, Polynomial(two[1].first, 1)), "1*r^-3");
    EXPECT_EQ(text(*ring, two[1].second), "2 + 1*r^2");
}

TEST(Ring, RefusesToDivideByWhatMayVanish) {
    const RingPtr ring = testing::pendulum_ring();
    const Error e = test::error_when([&] { (void)gen(*ring, "xi", -1); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_STREQ(e.what(), "only what is known to be non-zero is divided by\n  found: division by xi\n"
                           "  hint:  declare xi positive, if it is");
    EXPECT_THROW((void)ring->power(gen(*ring, "r") + ring->one(), -2), Error);
}

TEST(Ring, RefusesNegativeWeights) {
    RingBuilder b;
    b.add(named(GeneratorKind::small, "eps", true, 1));
    const RingPtr ring = b.freeze();
    EXPECT_THROW((void)ring->by_weight(gen(*ring, "eps", -1), 3), Error);
}

TEST(Ring, NumericRootsKeepSmallExponents) {
    RingBuilder b;
    add_root(b, "t2", 2, Polynomial(Rational(2)));
    add_root(b, "t3", 2, Polynomial(Rational(3)));
    const RingPtr ring = b.freeze();
    EXPECT_EQ(gen(*ring, "t2", 5), Rational(4) * gen(*ring, "t2"));
    EXPECT_EQ(gen(*ring, "t2", -1), Rational(1) / 2 * gen(*ring, "t2"));
    const Polynomial t6 = ring->multiply(gen(*ring, "t2"), gen(*ring, "t3"));
    EXPECT_EQ(ring->rational_power(Polynomial(Rational(6)), Rational(1) / 2).value(), t6);
    EXPECT_EQ(ring->rational_power(Polynomial(Rational(8)), Rational(-1) / 2).value(),
              Rational(1) / 4 * gen(*ring, "t2"));
    EXPECT_FALSE(ring->rational_power(Polynomial(Rational(5)), Rational(1) / 2));
}

TEST(Ring, RootsThatAreRationalAreRecognised) {
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    add_root(b, "t", 2, Polynomial(Rational(9) / 4));
    add_root(b, "q", 4, Polynomial(Rational(4)));    // q^2 = 2
    add_root(b, "s", 4, Rational(16) * b.gen(r, 4)); // s = 2 r
    const RingPtr ring = b.freeze();
    EXPECT_EQ(gen(*ring, "t"), Polynomial(Rational(3) / 2));
    EXPECT_EQ(gen(*ring, "q", 2), Polynomial(Rational(2)));
    EXPECT_EQ(gen(*ring, "s", -1), Rational(1) / 2 * gen(*ring, "r", -1));
}

TEST(Ring, OneRadicandTwiceIsOneRoot) {
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    add_root(b, "sigma", 4, b.gen(xi, 2) + b.gen(r, 2));
    add_root(b, "tau", 2, b.gen(xi, 2) + b.gen(r, 2));
    const RingPtr ring = b.freeze();
    EXPECT_EQ(gen(*ring, "tau"), gen(*ring, "sigma", 2));
    EXPECT_EQ(ring->derivative(gen(*ring, "tau"), xi),
              ring->multiply(gen(*ring, "xi"), gen(*ring, "sigma", -2)));
}

TEST(Ring, ExponentialDerivesToItself) {
    RingBuilder b;
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    const GeneratorId k = b.add(named(GeneratorKind::parameter, "k"));
    Generator e = named(GeneratorKind::primitive, "E", true);
    e.derivatives = {{xi, b.multiply(b.gen(k), b.gen(3))}}; // E = exp(k xi), itself generator 3
    b.add(e);
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->derivative(gen(*ring, "E", -2), xi),
              Rational(-2) * ring->multiply(gen(*ring, "k"), gen(*ring, "E", -2)));
    EXPECT_THROW((void)ring->derivative(gen(*ring, "E"), k), Error);
}

TEST(RingBuilder, Refuses) {
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    EXPECT_THROW(b.add(named(GeneratorKind::parameter, "r")), Error);
    EXPECT_THROW(add_root(b, "t", 2, b.gen(Ring::imaginary_unit)), Error);
    EXPECT_THROW(add_root(b, "t", 2, b.gen(r, -1)), Error);
    EXPECT_THROW(add_root(b, "t", 2, Polynomial()), Error);
    EXPECT_THROW(add_root(b, "t", 0, b.gen(r)), Error);
    add_root(b, "t", 2, Polynomial(Rational(-2)));
    EXPECT_THROW((void)b.freeze(), Error);

    RingBuilder many;
    for (int k = 1; k < 32; ++k) many.add(named(GeneratorKind::parameter, "p" + std::to_string(k)));
    const Error e = test::error_when([&] { many.add(named(GeneratorKind::parameter, "p32")); });
    EXPECT_STREQ(e.what(),
                 "a system has at most 32 of these together: i, eps, parameters, slow variables, two modes "
                 "for each oscillator, roots that occur; constants and integrals of a solution\n"
                 "  found: p32 would be one more\n  hint:  write numbers in the place of some parameters");
    EXPECT_EQ(many.freeze()->size(), 32);
}

} // namespace
} // namespace resonform
