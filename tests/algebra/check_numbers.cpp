// SPDX-License-Identifier: GPL-3.0-or-later
// Balls, matrices of balls, and the domain of numbers against the ring.
#include "algebra/number/ball_matrix.hpp"
#include "algebra/series/number_domain.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

constexpr std::int64_t bits = 200;

RealBall ball(std::int64_t p, std::int64_t q = 1) { return RealBall(Rational(p) / q, bits); }
ComplexBall real(std::int64_t p, std::int64_t q = 1) { return {ball(p, q), RealBall()}; }

TEST(Ball, IsRoundedToDigits) {
    EXPECT_EQ(rounded(ball(1, 4), 10), Rational(1) / 4);
    EXPECT_EQ(rounded(ball(0), 10), 0);
    const Rational third = rounded(ball(-1, 3), 10);
    EXPECT_EQ(third * power_of_ten(10), -3333333333LL);
    EXPECT_EQ(rounded(ball(2000003), 6), 2000000);
}

TEST(Ball, HasAMiddle) {
    for (const Rational& exact : {Rational(0), Rational(-3) / 4, cln::expt(Rational(2), Integer(-300)),
                                  Rational(5) * cln::expt(Rational(2), Integer(190))})
        EXPECT_EQ(middle(RealBall(exact, bits)), exact);
    EXPECT_LT(cln::abs(middle(ball(-1, 3)) + Rational(1) / 3), cln::expt(Rational(2), Integer(-190)));
    EXPECT_EQ(nearest_double(ball(-1, 3)), -1.0 / 3);
    EXPECT_EQ(ball(-1, 3).sign(), -1);
}

TEST(Ball, KnowsWhatItKnows) {
    RealBall difference;
    arb_sub(difference.get(), ball(1, 3).get(), ball(1, 3).get(), bits);
    EXPECT_TRUE(difference.contains_zero());
    EXPECT_FALSE(difference.is_zero());
    EXPECT_LT(binary_exponent(difference), -190);
    EXPECT_GT(accurate_bits(ball(1, 3)), 190);
    EXPECT_LE(accurate_bits(difference), 0);
    EXPECT_TRUE(ball(1, 3).is_positive());
}

// l A = lambda l, A u = lambda u, l u = 1; companion matrix of (x - 1)(x - 2)(x - 3)
TEST(BallMatrix, HasItsEigensystem) {
    const BallMatrix a = {
        {real(0), real(1), real(0)}, {real(0), real(0), real(1)}, {real(6), real(-11), real(6)}};
    const auto system = simple_eigensystem(a, bits);
    ASSERT_TRUE(system.has_value());
    int seen = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::int64_t root = 1; root <= 3; ++root) seen += system->values[k].overlaps(real(root)) ? 1 : 0;
        for (std::size_t j = 0; j < 3; ++j) {
            ComplexBall image;
            for (std::size_t m = 0; m < 3; ++m)
                image = plus(image, times(a[j][m], system->columns[k][m], bits), bits);
            EXPECT_TRUE(image.overlaps(times(system->values[k], system->columns[k][j], bits)));
            ComplexBall product;
            for (std::size_t m = 0; m < 3; ++m)
                product = plus(product, times(system->rows[j][m], system->columns[k][m], bits), bits);
            EXPECT_TRUE(product.overlaps(real(j == k ? 1 : 0)));
        }
    }
    EXPECT_EQ(seen, 3);
    EXPECT_FALSE(simple_eigensystem({{real(1), real(1)}, {real(0), real(1)}}, bits)); // double
    EXPECT_FALSE(solution({{real(1), real(2)}, {real(2), real(4)}}, {real(1), real(1)}, bits));
}

struct Both {
    RingPtr ring;
    GeneratorId z, zbar, eps, s;
};

// i, z, zbar, eps, s = 2^(1/2)
Both small_ring() {
    RingBuilder builder;
    Both b{};
    Generator g;
    g.kind = GeneratorKind::fast;
    g.weight = 1;
    g.name = "z1";
    g.conjugate = 2;
    b.z = builder.add(g);
    g.name = "z2";
    g.conjugate = 1;
    b.zbar = builder.add(g);
    g = {};
    g.kind = GeneratorKind::small;
    g.name = "eps";
    g.weight = 1;
    b.eps = builder.add(g);
    g = {};
    g.kind = GeneratorKind::root;
    g.name = "s";
    g.index = 2;
    g.invertible = g.positive = true;
    g.radicand = Polynomial(Rational(2));
    b.s = builder.add(g);
    b.ring = builder.freeze();
    return b;
}

Polynomial random_polynomial(const Both& b, std::mt19937& random) {
    std::vector<Polynomial> terms;
    for (int k = 0; k < 6; ++k) {
        Polynomial term(Rational(static_cast<long>(random() % 19) - 9) / 7);
        for (const GeneratorId id : {b.z, b.zbar, b.eps, b.s})
            term = b.ring->multiply(term, b.ring->gen(id, static_cast<int>(random() % 3)));
        terms.push_back(random() % 2 == 0 ? term : b.ring->multiply(b.ring->imaginary(), term));
    }
    return sum(terms);
}

// Every coefficient of one holds that of the other.
void expect_same(const NumberDomain& domain, const NumberPart& found, const NumberPart& wanted) {
    const NumberPart difference = domain.combination({{1, &found}, {-1, &wanted}});
    EXPECT_TRUE(domain.is_zero(difference));
    for (const RealBall& c : difference.coefficients) EXPECT_LT(binary_exponent(c), -150);
}

TEST(NumberDomain, IsAHomomorphismOfTheRing) {
    const Both b = small_ring();
    const NumberDomain domain(b.ring, 12, bits, {});
    std::mt19937 random(7);
    for (int n = 0; n < 40; ++n) {
        const Polynomial p = random_polynomial(b, random), q = random_polynomial(b, random);
        const Polynomial real_p = p + b.ring->conjugate(p), real_q = q + b.ring->conjugate(q);
        for (const auto& [left, right] : {std::pair{p, q}, std::pair{real_p, real_q}}) {
            const NumberPart x = domain.constant(left), y = domain.constant(right);
            expect_same(domain, domain.dot({{Rational(2) / 3, &x, &y}}),
                        domain.constant((Rational(2) / 3) * b.ring->multiply(left, right)));
            expect_same(domain, domain.combination({{3, &x}, {-1, &y}}),
                        domain.constant(Rational(3) * left - right));
            expect_same(domain, domain.conjugate(x), domain.constant(b.ring->conjugate(left)));
            for (const GeneratorId id : {b.z, b.zbar, b.eps})
                expect_same(domain, domain.derivative(x, id), domain.constant(b.ring->derivative(left, id)));
        }
        EXPECT_TRUE(domain.constant(real_p).real);
    }
}

TEST(NumberDomain, DividesByWhatIsNotZeroOnly) {
    const Both b = small_ring();
    const NumberDomain domain(b.ring, 4, bits, {});
    const Polynomial c = b.ring->one() + b.ring->multiply(b.ring->imaginary(), b.ring->gen(b.s));
    const NumberPart x = domain.constant(c);
    const auto inverse = domain.inverse(x);
    ASSERT_TRUE(inverse.has_value());
    EXPECT_TRUE(domain.is_one(domain.dot({{1, &x, &*inverse}})));
    const NumberPart s = domain.constant(b.ring->gen(b.s)), two = domain.constant(Polynomial(Rational(2)));
    const NumberPart square = domain.dot({{1, &s, &s}});
    EXPECT_FALSE(domain.inverse(domain.combination({{1, &square}, {-1, &two}})));
    EXPECT_FALSE(domain.inverse(domain.constant(b.ring->gen(b.z))));
    const auto root = domain.rational_power(two, Rational(1) / 2);
    ASSERT_TRUE(root.has_value());
    expect_same(domain, *root, s);
}

} // namespace
} // namespace resonform
