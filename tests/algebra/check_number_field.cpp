// SPDX-License-Identifier: GPL-3.0-or-later
// Inverses of sums of numeric roots: p (1/p) = 1, and no inverse of what is zero or divides zero.
#include "algebra/ring/ring.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

struct Roots {
    RingPtr ring;
    GeneratorId k, two, nested, three;
};

// k > 0 and its root, sqrt(2), sqrt(2 + sqrt(2)), 3^(1/3)
Roots roots() {
    RingBuilder b;
    Roots r;
    const auto root = [&](const std::string& name, int index, const Polynomial& radicand) {
        Generator g;
        g.kind = GeneratorKind::root;
        g.name = name;
        g.invertible = g.positive = true;
        g.index = index;
        g.radicand = radicand;
        return b.add(std::move(g));
    };
    Generator parameter;
    parameter.kind = GeneratorKind::parameter;
    parameter.name = "k";
    parameter.invertible = parameter.positive = true;
    const GeneratorId k = b.add(parameter);
    r.k = root("root k", 2, b.gen(k));
    r.two = root("root 2", 2, Polynomial(Rational(2)));
    r.nested = root("nested", 2, Polynomial(Rational(2)) + b.gen(r.two));
    r.three = root("root 3", 3, Polynomial(Rational(3)));
    r.ring = b.freeze();
    return r;
}

TEST(NumberField, SumsOfRootsAreInverted) {
    const Roots r = roots();
    const Ring& ring = *r.ring;
    std::mt19937 random(1);
    int inverted = 0;
    for (int trial = 0; trial < 30; ++trial) {
        Polynomial p;
        for (int n = 0; n < 4; ++n) {
            Polynomial term(Rational(static_cast<int>(random() % 9) - 4));
            term = ring.multiply(term, ring.gen(r.two, static_cast<int>(random() % 2)));
            term = ring.multiply(term, ring.gen(r.nested, static_cast<int>(random() % 4) - 2));
            term = ring.multiply(term, ring.gen(r.three, static_cast<int>(random() % 3)));
            if (trial % 2 == 0) term = ring.multiply(term, ring.gen(Ring::imaginary_unit, n % 2));
            p = p + ring.multiply(term, ring.gen(r.k, -3));
        }
        if (ring.vanishes(p)) continue;
        const auto inverse = ring.inverse(p);
        ASSERT_TRUE(inverse) << trial;
        EXPECT_TRUE(ring.vanishes(ring.multiply(p, *inverse) - ring.one())) << trial;
        ++inverted;
    }
    EXPECT_GT(inverted, 20);
}

TEST(NumberField, SymbolsAreNoNumbers) {
    const Roots r = roots();
    EXPECT_FALSE(r.ring->inverse(r.ring->gen(r.k) + r.ring->one()));
    EXPECT_FALSE(r.ring->inverse(Polynomial()));
}

// sqrt(2), sqrt(3) and sqrt(6) as three roots: sqrt(2) sqrt(3) - sqrt(6) is zero and has another form.
TEST(NumberField, ZeroDivisorsAreNotInverted) {
    RingBuilder b;
    std::vector<GeneratorId> ids;
    for (const int n : {2, 3, 6}) {
        Generator g;
        g.kind = GeneratorKind::root;
        g.name = "root " + std::to_string(n);
        g.invertible = g.positive = true;
        g.index = 2;
        g.radicand = Polynomial(Rational(n));
        ids.push_back(b.add(std::move(g)));
    }
    const RingPtr ring = b.freeze();
    const Polynomial p = ring->multiply(ring->gen(ids[0]), ring->gen(ids[1])) - ring->gen(ids[2]);
    EXPECT_FALSE(ring->inverse(p));
}

// Dividing by a sum of numbers again and again would not end.
TEST(NumberField, RootsOfTheRadicandAreFound) {
    const Roots r = roots();
    const Polynomial radicand = Polynomial(Rational(2)) + r.ring->gen(r.two);
    const auto root = r.ring->rational_power(radicand, Rational(1) / 2);
    ASSERT_TRUE(root);
    EXPECT_TRUE(r.ring->vanishes(*root - r.ring->gen(r.nested)));
    EXPECT_FALSE(r.ring->rational_power(radicand + r.ring->one(), Rational(1) / 2));
}

} // namespace
} // namespace resonform
