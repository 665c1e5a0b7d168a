// SPDX-License-Identifier: GPL-3.0-or-later
// Functions as generators: their relations, derivatives and zero tests.
#include "algebra/number/error.hpp"
#include "rings.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using testing::add_root;
using testing::gen;
using testing::named;

GeneratorId add_function(RingBuilder& b, const std::string& name, FunctionOf of) {
    Generator g = named(GeneratorKind::function, name);
    g.of = std::move(of);
    return b.add(std::move(g));
}

struct Names {
    GeneratorId tau, a;
};

Names start(RingBuilder& b) {
    return {b.add(named(GeneratorKind::slow, "tau")), b.add(named(GeneratorKind::parameter, "a"))};
}

void add_circle(RingBuilder& b, const Polynomial& u, const std::string& of) {
    const GeneratorId sine = add_function(b, "sin " + of, {Function::sine, u});
    add_function(b, "cos " + of, {Function::cosine, u, sine});
}

TEST(RingFunctions, ASineAndItsCosine) {
    RingBuilder b;
    const Names n = start(b);
    add_circle(b, b.multiply(b.gen(n.tau), b.gen(n.a)), "a tau");
    const RingPtr ring = b.freeze();
    EXPECT_EQ(gen(*ring, "sin a tau", 2), ring->one() - gen(*ring, "cos a tau", 2));
    EXPECT_EQ(ring->derivative(gen(*ring, "sin a tau"), n.tau),
              ring->multiply(gen(*ring, "a"), gen(*ring, "cos a tau")));
    EXPECT_EQ(ring->derivative(gen(*ring, "cos a tau"), n.a),
              -ring->multiply(gen(*ring, "tau"), gen(*ring, "sin a tau")));
    EXPECT_TRUE(ring->is_canonical());
    EXPECT_EQ(ring->is_zero(gen(*ring, "sin a tau") - gen(*ring, "cos a tau")), Zero::no);
}

// sigma^2 = 2 + cos tau eliminates the cosine, and then the sine is ruled by sigma.
TEST(RingFunctions, ACosineUnderARoot) {
    RingBuilder b;
    const Names n = start(b);
    add_circle(b, b.gen(n.tau), "tau");
    add_root(b, "sigma", 2, Polynomial(Rational(2)) + b.gen(b.id("cos tau")));
    const RingPtr ring = b.freeze();
    EXPECT_TRUE(ring->is_canonical());
    EXPECT_EQ(gen(*ring, "cos tau"), gen(*ring, "sigma", 2) - Polynomial(Rational(2)));
    const Polynomial s = gen(*ring, "sin tau"), c = gen(*ring, "cos tau");
    EXPECT_TRUE((ring->multiply(s, s) + ring->multiply(c, c) - ring->one()).empty());
    EXPECT_EQ(ring->derivative(gen(*ring, "sigma", 2), n.tau), -s);
}

TEST(RingFunctions, Exponentials) {
    RingBuilder b;
    const Names n = start(b);
    add_function(b, "E", {Function::exponential, Rational(1) / 2 * b.gen(n.tau)});
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->derivative(gen(*ring, "E", -4), n.tau), Rational(-2) * gen(*ring, "E", -4));
    EXPECT_TRUE(ring->is_canonical());
    EXPECT_EQ(ring->is_zero(gen(*ring, "E") - gen(*ring, "tau")), Zero::no);
}

TEST(RingFunctions, LogarithmsAndArcs) {
    RingBuilder b;
    const Names n = start(b);
    const Polynomial u = Polynomial(Rational(1)) + b.gen(n.tau, 2);
    add_root(b, "sigma", 2, u);
    add_function(b, "log", {Function::logarithm, u});
    add_function(b, "atan", {Function::arc_tangent, b.gen(n.tau)});
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->derivative(gen(*ring, "log"), n.tau),
              Rational(2) * ring->multiply(gen(*ring, "tau"), gen(*ring, "sigma", -2)));
    EXPECT_EQ(ring->derivative(gen(*ring, "atan"), n.tau), gen(*ring, "sigma", -2));
    EXPECT_EQ(ring->is_zero(gen(*ring, "log") - gen(*ring, "atan")), Zero::no);
}

// log(a b) - log a - log b: not zero as a polynomial, zero as a function; it must not be called non-zero.
TEST(RingFunctions, WhatMayDependIsUnknown) {
    RingBuilder b;
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    const GeneratorId y = b.add(named(GeneratorKind::slow, "y", true));
    const auto log = [&](const std::string& name, const Polynomial& u) {
        Generator g = named(GeneratorKind::function, name);
        g.of = {Function::logarithm, u};
        g.independent = false;
        b.add(g);
    };
    log("log x", b.gen(x));
    log("log y", b.gen(y));
    log("log xy", b.multiply(b.gen(x), b.gen(y)));
    const RingPtr ring = b.freeze();
    EXPECT_FALSE(ring->is_canonical());
    const Polynomial p = gen(*ring, "log xy") - gen(*ring, "log x") - gen(*ring, "log y");
    EXPECT_EQ(ring->is_zero(p), Zero::unknown);
    EXPECT_EQ(ring->is_zero(p + ring->one()), Zero::no);
}

TEST(RingFunctions, KnownByTheirNames) {
    RingBuilder b;
    const Names n = start(b);
    for (int k = 0; k <= 1; ++k)
        add_function(b, "omega " + std::to_string(k),
                     {Function::named, b.multiply(b.gen(n.tau), b.gen(n.tau)), -1, "omega", k});
    const RingPtr ring = b.freeze();
    EXPECT_EQ(ring->derivative(gen(*ring, "omega 0"), n.tau),
              Rational(2) * ring->multiply(gen(*ring, "tau"), gen(*ring, "omega 1")));
    EXPECT_TRUE(ring->derivative(gen(*ring, "omega 1"), n.a).empty());
    EXPECT_THROW(static_cast<void>(ring->derivative(gen(*ring, "omega 1"), n.tau)), Error);
    EXPECT_EQ(ring->is_zero(gen(*ring, "omega 0") - gen(*ring, "omega 1")), Zero::no);
}

TEST(RingFunctions, ACosineNeedsItsSine) {
    RingBuilder b;
    const Names n = start(b);
    EXPECT_THROW(add_function(b, "cos", {Function::cosine, b.gen(n.tau)}), Error);
    const GeneratorId sine = add_function(b, "sin", {Function::sine, b.gen(n.tau)});
    EXPECT_THROW(add_function(b, "cos", {Function::cosine, b.gen(n.a), sine}), Error);
}

} // namespace
} // namespace resonform
