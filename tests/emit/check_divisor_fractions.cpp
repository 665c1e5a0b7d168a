// SPDX-License-Identifier: GPL-3.0-or-later
// Divisors before evaluation: over a common denominator where that is short, as they stand where not, and the
// same value either way.
#include "emit/display/divisor_fractions.hpp"

#include "algebra/ring/products.hpp"
#include "support/generators.hpp"
#include <gtest/gtest.h>

namespace resonform {
namespace {

// J, K; phases u, v; divisors D1 = J^2 + K + 1, D2 = J^2 + 2 K + 4, D3 = J^2 + 3 K + 9, ...
struct Divided {
    RingPtr ring;
    GeneratorId j, k, u, v;
    std::vector<GeneratorId> divisors;

    explicit Divided(int count) {
        RingBuilder builder;
        j = builder.add(test::named(GeneratorKind::slow, "J"));
        k = builder.add(test::named(GeneratorKind::slow, "K"));
        u = builder.add(test::named(GeneratorKind::phase, "u"));
        v = builder.add(test::named(GeneratorKind::phase, "v"));
        for (int n = 1; n <= count; ++n) {
            Generator d = test::named(GeneratorKind::root, "D" + std::to_string(n));
            d.index = 1;
            d.radicand =
                builder.gen(j, 2) + Rational(n) * builder.gen(k) + Polynomial(Rational(n) * Rational(n));
            divisors.push_back(builder.add(std::move(d)));
        }
        ring = builder.freeze();
    }
    [[nodiscard]] Polynomial over(std::size_t n, int exponent = -1) const {
        return ring->gen(divisors[n], exponent);
    }
};

Polynomial value_of_fractions(const Ring& ring, const std::vector<Fraction>& fractions) {
    Polynomial sum;
    for (const Fraction& f : fractions)
        sum = sum + ring.multiply(ring.reduce(Polynomial(f.factor, 1)), ring.reduce(f.numerator));
    return sum;
}

std::size_t terms_of_fractions(const std::vector<Fraction>& fractions) {
    std::size_t count = 0;
    for (const Fraction& f : fractions) count += f.numerator.size();
    return count;
}

TEST(DivisorFractions, ShortSumsHaveACommonDenominator) {
    const Divided d(2);
    const Polynomial p = d.over(0) + d.over(1);
    const auto fractions = divisor_fractions(*d.ring, p);
    ASSERT_EQ(fractions.size(), 1U);
    EXPECT_EQ(fractions.front().factor,
              d.ring->monomial(d.divisors[0], -1) + d.ring->monomial(d.divisors[1], -1));
    EXPECT_EQ(fractions.front().numerator.size(), 3U); // 2 J^2 + 3 K + 5
    EXPECT_EQ(value_of_fractions(*d.ring, fractions), p);
}

// u D1 D2/(D1^2 D2), as a sum over the powers of D1.
TEST(DivisorFractions, CommonFactorsAreCancelled) {
    const Divided d(2);
    const Ring& ring = *d.ring;
    const Polynomial numerator = plain_product(ring.packing(), ring.generator(d.divisors[0]).radicand,
                                               ring.generator(d.divisors[1]).radicand);
    const Polynomial over =
        Polynomial(ring.monomial(d.divisors[0], -2) + ring.monomial(d.divisors[1], -1), 1);
    const auto fractions = divisor_fractions(
        ring, plain_product(ring.packing(), plain_product(ring.packing(), numerator, over), ring.gen(d.u)));
    ASSERT_EQ(fractions.size(), 1U);
    EXPECT_EQ(fractions.front().factor, ring.monomial(d.divisors[0], -1));
    EXPECT_EQ(fractions.front().numerator, ring.gen(d.u));
}

TEST(DivisorFractions, WhatStandsBesideOtherPhasesIsLeftAlone) {
    const Divided d(3);
    const Polynomial p = d.ring->multiply(d.ring->gen(d.u), d.over(0)) +
                         d.ring->multiply(d.ring->gen(d.v, -1), d.over(1)) + d.over(2, -2);
    const auto fractions = divisor_fractions(*d.ring, p);
    EXPECT_EQ(fractions.size(), 3U);
    EXPECT_EQ(terms_of_fractions(fractions), 3U);
    EXPECT_EQ(value_of_fractions(*d.ring, fractions), p);
}

// One denominator of 12 squares would have a numerator of hundreds of terms.
TEST(DivisorFractions, LongSumsStayAsTheyAre) {
    const Divided d(12);
    Polynomial p;
    for (std::size_t n = 0; n < d.divisors.size(); ++n) p = p + d.over(n, -2);
    const auto fractions = divisor_fractions(*d.ring, p);
    EXPECT_EQ(terms_of_fractions(fractions), d.divisors.size());
    EXPECT_EQ(value_of_fractions(*d.ring, fractions), p);
}

} // namespace
} // namespace resonform
