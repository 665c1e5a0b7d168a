// SPDX-License-Identifier: GPL-3.0-or-later
// Homomorphisms between rings.
#include "algebra/number/error.hpp"
#include "rings.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using testing::add_root;
using testing::gen;
using testing::named;
using testing::random_polynomial;
using testing::text;

// The pendulum's ring with finer roots: s = (xi^2 + r^2)^(1/8), h = g^(1/4), one generator more.
RingPtr refined_ring() {
    RingBuilder b;
    Generator z = named(GeneratorKind::fast, "z1", false, 1),
              zbar = named(GeneratorKind::fast, "z2", false, 1);
    z.conjugate = 2;
    zbar.conjugate = 1;
    b.add(z);
    b.add(zbar);
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    const GeneratorId g = b.add(named(GeneratorKind::parameter, "g", true));
    b.add(named(GeneratorKind::parameter, "v"));
    b.add(named(GeneratorKind::small, "eps", false, 1));
    add_root(b, "s", 8, b.gen(xi, 2) + b.gen(r, 2));
    add_root(b, "h", 4, b.gen(g));
    b.add(named(GeneratorKind::constant, "C"));
    b.add(named(GeneratorKind::phase, "u"));
    for (int k = 0; k < 8; ++k) b.add(named(GeneratorKind::constant, "c" + std::to_string(k)));
    return b.freeze();
}

RingMap refinement(const RingPtr& from, const RingPtr& to) {
    return RingMap::by_name(
        from, to,
        {{from->find("sigma").value(), gen(*to, "s", 2)}, {from->find("G").value(), gen(*to, "h", 2)}});
}

TEST(RingMap, IsAHomomorphism) {
    const RingPtr from = testing::pendulum_ring(), to = refined_ring();
    const RingMap map = refinement(from, to);
    std::mt19937 random(3);
    for (int n = 0; n < 40; ++n) {
        const Polynomial a = random_polynomial(*from, random), b = random_polynomial(*from, random);
        EXPECT_EQ(map(a + b), map(a) + map(b));
        EXPECT_EQ(map(from->multiply(a, b)), to->multiply(map(a), map(b))) << text(*from, a) << "\n"
                                                                           << text(*from, b);
        EXPECT_EQ(map(from->conjugate(a)), to->conjugate(map(a)));
        const GeneratorId here = from->find("xi").value(), there = to->find("xi").value();
        EXPECT_EQ(map(from->derivative(a, here)), to->derivative(map(a), there));
    }
    EXPECT_EQ(map(from->imaginary()), to->imaginary());
}

TEST(RingMap, SubstitutesSums) {
    const RingPtr ring = testing::pendulum_ring();
    const GeneratorId z1 = ring->find("z1").value(), z2 = ring->find("z2").value();
    const Polynomial shift = gen(*ring, "eps") + ring->multiply(ring->imaginary(), gen(*ring, "xi"));
    const RingMap map = RingMap::by_name(ring, ring, {{z1, gen(*ring, "z1") + shift}, {z2, Polynomial()}});
    EXPECT_EQ(map(gen(*ring, "z1", 3)), ring->power(gen(*ring, "z1") + shift, 3));
    EXPECT_TRUE(map(ring->multiply(gen(*ring, "z1"), gen(*ring, "z2"))).empty());
    std::mt19937 random(5);
    for (int n = 0; n < 20; ++n) {
        const Polynomial a = random_polynomial(*ring, random), b = random_polynomial(*ring, random);
        EXPECT_EQ(map(ring->multiply(a, b)), ring->multiply(map(a), map(b)));
    }
}

TEST(RingMap, ScalesThatKeepTheRelationAreAccepted) {
    const RingPtr ring = testing::pendulum_ring();
    // xi -> 4 xi, r -> 4 r, sigma -> 2 sigma
    const RingMap map = RingMap::by_name(ring, ring,
                                         {{ring->find("xi").value(), Rational(4) * gen(*ring, "xi")},
                                          {ring->find("r").value(), Rational(4) * gen(*ring, "r")},
                                          {ring->find("sigma").value(), Rational(2) * gen(*ring, "sigma")}});
    EXPECT_EQ(map(gen(*ring, "sigma", -1)), Rational(1) / 2 * gen(*ring, "sigma", -1));
}

TEST(RingMap, Refuses) {
    const RingPtr ring = testing::pendulum_ring(), to = refined_ring();
    const auto rule = [&](const char* name, const Polynomial& image) {
        try {
            (void)RingMap::by_name(ring, ring, {{ring->find(name).value(), image}});
        } catch (const Error& e) {
            return e.diagnostic().rule + ": " + e.diagnostic().value;
        }
        return std::string("accepted");
    };
    EXPECT_EQ(rule("sigma", gen(*ring, "sigma", 2)), "a map of rings keeps relations: the image of sigma");
    EXPECT_EQ(rule("G", gen(*ring, "r")), "a map of rings keeps relations: the image of G");
    EXPECT_EQ(rule("I", ring->one()), "a map of rings keeps relations: the image of I");
    EXPECT_EQ(rule("I", -ring->imaginary()), "accepted");
    EXPECT_THROW((void)RingMap::by_name(ring, to), Error); // sigma and G are not there
    EXPECT_THROW((void)RingMap(ring, ring, {}), Error);

    const RingMap vanishing = RingMap::by_name(ring, ring, {{ring->find("u").value(), gen(*ring, "xi")}});
    EXPECT_THROW((void)vanishing(gen(*ring, "u", -1)), Error);
}

TEST(RingBuilder, ImportsByName) {
    const RingPtr ring = testing::pendulum_ring();
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    const Polynomial p = ring->multiply(gen(*ring, "xi"), gen(*ring, "r", -2)) + Polynomial(Rational(2) / 3);
    EXPECT_EQ(b.import(*ring, p), b.multiply(b.gen(xi), b.gen(r, -2)) + Polynomial(Rational(2) / 3));
    EXPECT_THROW((void)b.import(*ring, gen(*ring, "v")), Error);
}

} // namespace
} // namespace resonform
