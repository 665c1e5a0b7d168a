// SPDX-License-Identifier: GPL-3.0-or-later
// The three answers of Ring::is_zero.
#include "rings.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using testing::add_root;
using testing::gen;
using testing::named;

TEST(ZeroTest, YesByRelations) {
    const RingPtr ring = testing::pendulum_ring();
    const Polynomial s = gen(*ring, "xi", 2) + gen(*ring, "r", 2);
    EXPECT_EQ(ring->is_zero(Polynomial()), Zero::yes);
    EXPECT_EQ(ring->is_zero(ring->multiply(s, gen(*ring, "sigma", -4)) - ring->one()), Zero::yes);
    EXPECT_EQ(ring->is_zero(ring->power(ring->imaginary(), 2) + ring->one()), Zero::yes);
}

TEST(ZeroTest, NoByAPointOfTheDomain) {
    const RingPtr ring = testing::pendulum_ring();
    EXPECT_EQ(ring->is_zero(gen(*ring, "sigma") - gen(*ring, "r")), Zero::no);
    EXPECT_EQ(ring->is_zero(ring->multiply(gen(*ring, "z1"), gen(*ring, "xi"))), Zero::no);
    EXPECT_EQ(ring->is_zero(gen(*ring, "z1") - gen(*ring, "z2")), Zero::no);
    EXPECT_EQ(ring->is_zero(gen(*ring, "u") - ring->one()), Zero::no);
    // A value that is small, but not zero: sigma - sigma (1 + 10^-60).
    const Rational tiny = cln::expt(Rational(10), Integer(-60));
    EXPECT_EQ(ring->is_zero(tiny * gen(*ring, "sigma")), Zero::no);
}

TEST(ZeroTest, CloseNumbersAreSeparated) {
    RingBuilder b;
    add_root(b, "t", 2, Polynomial(Rational(2)));
    const RingPtr ring = b.freeze();
    // Convergents of sqrt(2): p/q - sqrt(2) falls like 1/q^2; 100 digits are out of reach, 60 are not.
    Integer p = 1, q = 1;
    while (q < cln::expt_pos(Integer(10), Integer(30))) {
        const Integer next = p + 2 * q;
        q = p + q;
        p = next;
    }
    EXPECT_EQ(ring->is_zero(gen(*ring, "t") - Polynomial(Rational(p) / q)), Zero::no);
}

TEST(ZeroTest, YesAfterDenominatorsAreCleared) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    add_root(b, "sigma", 2, b.gen(x) + b.gen(r));
    const RingPtr ring = b.freeze();
    const Polynomial s = gen(*ring, "x") + gen(*ring, "r");
    const Polynomial p = ring->multiply(s, gen(*ring, "sigma", -3)) - gen(*ring, "sigma", -1);
    EXPECT_FALSE(p.empty()); // the form alone does not tell
    EXPECT_EQ(ring->is_zero(p), Zero::yes);
    EXPECT_EQ(ring->is_zero(p + gen(*ring, "sigma", -1)), Zero::no);
}

TEST(ZeroTest, UnknownWhereRootsDepend) {
    RingBuilder b;
    add_root(b, "t2", 2, Polynomial(Rational(2)));
    add_root(b, "t3", 2, Polynomial(Rational(3)));
    add_root(b, "t6", 2, Polynomial(Rational(6)));
    const RingPtr ring = b.freeze();
    const Polynomial product = ring->multiply(gen(*ring, "t2"), gen(*ring, "t3"));
    EXPECT_EQ(ring->is_zero(product - gen(*ring, "t6")), Zero::unknown); // it is zero, unproved
    EXPECT_EQ(ring->is_zero(product + gen(*ring, "t6")), Zero::no);
}

TEST(ZeroTest, UnknownForASquareUnderARoot) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    add_root(b, "sigma", 2, b.gen(x, 2) + Rational(2) * b.gen(x) + Polynomial(Rational(1)));
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->is_zero(gen(*ring, "sigma") - gen(*ring, "x") - ring->one()), Zero::unknown);
    EXPECT_EQ(ring->is_zero(gen(*ring, "sigma") - gen(*ring, "x")), Zero::no);
}

TEST(ZeroTest, PrimitivesMayDepend) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    Generator log = named(GeneratorKind::primitive, "L");
    log.derivatives = {{x, b.gen(x, -1)}};
    b.add(log);
    log.name = "M"; // perhaps the same function
    b.add(log);
    b.add(named(GeneratorKind::constant, "C"));
    const RingPtr ring = b.freeze();
    const Polynomial difference = gen(*ring, "L") - gen(*ring, "M");
    EXPECT_EQ(ring->is_zero(difference), Zero::unknown);
    EXPECT_EQ(ring->is_zero(difference + gen(*ring, "C")), Zero::no); // C is free
    EXPECT_EQ(ring->is_zero(difference - difference), Zero::yes);
}

TEST(ZeroTest, NestedRoots) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    const GeneratorId s = add_root(b, "s", 2, b.gen(x) + Polynomial(Rational(1)));
    add_root(b, "t", 2, b.gen(s) + b.gen(x));
    const RingPtr ring = b.freeze();
    // (t^2 - x)^2 = x + 1
    const Polynomial inner = gen(*ring, "t", 2) - gen(*ring, "x");
    EXPECT_EQ(ring->is_zero(ring->power(inner, 2) - gen(*ring, "x") - ring->one()), Zero::yes);
    const Polynomial cleared = ring->multiply(gen(*ring, "t", -1), gen(*ring, "s") + gen(*ring, "x"));
    EXPECT_EQ(ring->is_zero(cleared - gen(*ring, "t")), Zero::yes);
    EXPECT_EQ(ring->is_zero(gen(*ring, "t") - gen(*ring, "s")), Zero::no);
}

TEST(ZeroTest, FunctionsOfLargeNumbers) {
    RingBuilder b;
    Generator g = named(GeneratorKind::function, "L");
    g.of.function = Function::logarithm;
    g.of.argument = Polynomial(Rational(1000000));
    b.add(g);
    g.name = "E";
    g.of.function = Function::exponential;
    b.add(g);
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->is_zero(gen(*ring, "L") - Polynomial(Rational(1381551) / 100000)), Zero::no);
    EXPECT_EQ(ring->is_zero(gen(*ring, "E") - gen(*ring, "L")), Zero::no);
}

TEST(ZeroTest, EmptyDomainIsUnknown) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    add_root(b, "s", 2, -b.gen(x) - Polynomial(Rational(1))); // never real
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->is_zero(gen(*ring, "s") - gen(*ring, "x")), Zero::unknown);
}

} // namespace
} // namespace resonform
