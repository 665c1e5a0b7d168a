// SPDX-License-Identifier: GPL-3.0-or-later
// Common factors of numerators and radicands, in rings whose forms are not canonical: A, s and k are
// positive, so that no relation takes one of them away.
#include "algebra/ring/cancellation.hpp"
#include "algebra/ring/products.hpp"

#include "rings.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using testing::gen;

// A, k > 0, a, b; sigma^2 = A - 1, D = k^2 + 4, K = k^3 + 4 k, E = (a + b)(1 - 2 a + 2 b)
RingPtr divided_ring() {
    RingBuilder builder;
    const GeneratorId A = builder.add(testing::named(GeneratorKind::parameter, "A", true));
    const GeneratorId k = builder.add(testing::named(GeneratorKind::parameter, "k", true));
    const GeneratorId a = builder.add(testing::named(GeneratorKind::parameter, "a"));
    const GeneratorId b = builder.add(testing::named(GeneratorKind::parameter, "b"));
    const Polynomial one(Rational(1)), sum = builder.gen(a) + builder.gen(b);
    testing::add_root(builder, "sigma", 2, builder.gen(A) - one);
    testing::add_root(builder, "rho", 2, builder.gen(A, 2) - one);
    testing::add_root(builder, "D", 1, builder.gen(k, 2) + Polynomial(Rational(4)));
    testing::add_root(builder, "K", 1, builder.gen(k, 3) + Rational(4) * builder.gen(k));
    testing::add_root(
        builder, "E", 1,
        builder.multiply(sum, one - Rational(2) * builder.gen(a) + Rational(2) * builder.gen(b)));
    return builder.freeze();
}

struct Cancellation : ::testing::Test {
    RingPtr ring = divided_ring();
    Polynomial one = ring->one(), A = gen(*ring, "A"), k = gen(*ring, "k"), a = gen(*ring, "a"),
               b = gen(*ring, "b");

    [[nodiscard]] Polynomial times(const Polynomial& p, const Polynomial& q) const {
        return ring->multiply(p, q);
    }
    [[nodiscard]] Monomial power(const std::string& name, int exponent) const {
        return ring->monomial(*ring->find(name), exponent);
    }
    // factor * numerator = what came out, once the divisors are multiplied with.
    void expect_equal_values(const Monomial& factor, const Polynomial& numerator, const Fraction& f) const {
        Polynomial left = times(ring->reduce(Polynomial(factor, 1)), numerator);
        for (const Polynomial& divisor : f.divisors) left = times(left, divisor);
        const Polynomial right = times(ring->reduce(Polynomial(f.factor, 1)), f.numerator);
        EXPECT_TRUE(ring->vanishes(left - right));
    }
};

TEST_F(Cancellation, WholeRadicandsGoIntoTheRoot) {
    const Polynomial square = times(A - one, A - one);
    const Fraction f = cancelled(*ring, power("sigma", -3), Rational(1) / 24 * square);
    EXPECT_EQ(f.factor, power("sigma", 1));
    EXPECT_EQ(f.numerator, Rational(1) / 24 * one);
    EXPECT_TRUE(f.divisors.empty());
}

TEST_F(Cancellation, DivisorsDisappear) {
    const Fraction f = cancelled(*ring, power("D", -1) + power("k", -1), times(k, k) + Rational(4) * one);
    EXPECT_EQ(f.factor, power("k", -1));
    EXPECT_EQ(f.numerator, one);
}

// Also beside other generators, where each coefficient has the factor.
TEST_F(Cancellation, FactorsOfAllCoefficientsAreTaken) {
    const Polynomial other = times(A, A) + times(A, b) + Rational(3) * times(b, b);
    const Polynomial numerator = times(times(k, k) + Rational(4) * one, other);
    const Fraction f = cancelled(*ring, power("D", -2), numerator);
    EXPECT_EQ(f.factor, power("D", -1));
    EXPECT_EQ(f.numerator, other);
    const Fraction mixed = cancelled(*ring, power("D", -2), numerator + b);
    EXPECT_EQ(mixed.factor, power("D", -2));
    EXPECT_EQ(mixed.numerator, numerator + b);
}

TEST_F(Cancellation, WhatIsLeftOfADivisorIsAPowerOrASum) {
    const Fraction monomial = cancelled(*ring, power("K", -1), times(k, k) + Rational(4) * one);
    EXPECT_EQ(monomial.factor, power("k", -1));
    EXPECT_EQ(monomial.numerator, one);
    // a^2 is held by E: written out it is there again.
    const auto form = ring->expanded_form(times(Rational(3) * times(a + b, a), gen(*ring, "E", -1)));
    ASSERT_EQ(form.size(), 1U);
    const Fraction sum = cancelled(*ring, form[0].first, form[0].second);
    EXPECT_EQ(sum.factor, Monomial{});
    EXPECT_EQ(sum.numerator.size(), 1U); // 3 a
    ASSERT_EQ(sum.divisors.size(), 1U);
    EXPECT_EQ(sum.divisors.front().size(), 3U); // 1 - 2 a + 2 b
    expect_equal_values(form[0].first, form[0].second, sum);
}

// k = q^2: numerators have k, the radicand q^2.
TEST(CancellationOf, RootsUnderRoots) {
    RingBuilder builder;
    const GeneratorId k = builder.add(testing::named(GeneratorKind::parameter, "k", true));
    const GeneratorId s = builder.add(testing::named(GeneratorKind::parameter, "s", true));
    const GeneratorId q = testing::add_root(builder, "q", 2, builder.gen(k));
    testing::add_root(builder, "omega", 2, builder.gen(s, 2) - Rational(4) * builder.gen(q, 2));
    const RingPtr ring = builder.freeze();
    const Polynomial numerator = Polynomial(ring->monomial(s, 3), 1) -
                                 Rational(4) * Polynomial(ring->monomial(s, 1) + ring->monomial(k, 1), 1);
    const Fraction f = cancelled(*ring, ring->monomial(*ring->find("omega"), -2), numerator);
    EXPECT_EQ(f.factor, Monomial{});
    EXPECT_EQ(f.numerator, gen(*ring, "s"));
    EXPECT_TRUE(f.divisors.empty());
}

// rho = (A^2 - 1)^(1/2) is no product of roots: sqrt(A - 1) alone may be imaginary.
TEST_F(Cancellation, RootsAreNotTakenApart) {
    const Fraction once = cancelled(*ring, power("rho", -1), A - one);
    EXPECT_EQ(once.factor, power("rho", -1));
    EXPECT_EQ(once.numerator, A - one);
    const Fraction thrice = cancelled(*ring, power("rho", -3), A - one);
    EXPECT_EQ(thrice.factor, power("rho", -1));
    ASSERT_EQ(thrice.divisors.size(), 1U); // A + 1
    expect_equal_values(power("rho", -3), A - one, thrice);
}

TEST_F(Cancellation, WithinTheRing) {
    const Polynomial square = times(A - one, A - one);
    EXPECT_EQ(cancelled(*ring, times(square, gen(*ring, "sigma", -3))), gen(*ring, "sigma"));
    EXPECT_EQ(cancelled(*ring, times(a + b, gen(*ring, "E", -1))), times(a + b, gen(*ring, "E", -1)));
}

// (A - 1)^3 b^2 a + (A - 1)^2 2 b + A: beside each monomial in other generators as much as there is. D has
// terms of one sign, and nothing is close to zero.
TEST_F(Cancellation, RadicandsAreTakenApartWhereTheyComeCloseToZero) {
    const Polynomial square = times(A - one, A - one), bb = times(b, b);
    const Polynomial numerator =
        times(times(square, A - one), times(bb, a)) + Rational(2) * times(square, b) + A;
    const Polynomial apart = radicands_apart(*ring, numerator);
    const Polynomial expected =
        plain_product(ring->packing(), times(bb, a), Polynomial(power("sigma", 6), 1)) +
        Rational(2) * plain_product(ring->packing(), b, Polynomial(power("sigma", 4), 1)) + A;
    EXPECT_EQ(apart, expected);
    const Polynomial d = times(k, k) + Rational(4) * one;
    EXPECT_EQ(radicands_apart(*ring, times(d, d)), times(d, d));
    EXPECT_EQ(radicands_apart(*ring, A - Rational(2) * one), A - Rational(2) * one);
}

} // namespace
} // namespace resonform
