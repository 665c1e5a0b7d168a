// SPDX-License-Identifier: GPL-3.0-or-later
// Law: what close_primitive returns differentiates back to the integrand; the derivative of an element
// without logarithm is always closed.
#include "solve/quadrature.hpp"
#include "solve/rings.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace resonform;
using resonform::testing::EighthRoot;

namespace {

Polynomial derivative(const Ring& ring, GeneratorId x, const ClosedForm& f) {
    Polynomial d = ring.derivative(f.algebraic, x);
    for (const auto& [coefficient, logarithm] : f.logarithmic)
        d = d + ring.multiply(coefficient, logarithm.derivative);
    return d;
}

TEST(Quadrature, InvertsTheDerivation) {
    const EighthRoot e;
    std::mt19937 random(20231);
    const auto pick = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    for (int round = 0; round < 60; ++round) {
        Polynomial f;
        std::string spelled;
        for (int k = 0; k < 3; ++k) {
            const int c = pick(1, 9), a = pick(0, 3), b = pick(0, 2), n = pick(0, 3), m = pick(-20, 6);
            f = f + e.term(Rational(c), a, b, n, m);
            spelled += std::to_string(c) + " r^" + std::to_string(a) + " v^" + std::to_string(b) + " x^" +
                       std::to_string(n) + " rho^" + std::to_string(m) + " + ";
        }
        const Polynomial integrand = e.ring->derivative(f, e.x);
        const auto closed = close_primitive(*e.ring, e.x, integrand);
        ASSERT_TRUE(closed) << spelled;
        EXPECT_EQ(derivative(*e.ring, e.x, *closed), integrand) << spelled;
    }
}

TEST(Quadrature, EveryLogarithmHasTheDerivativeItClaims) {
    const EighthRoot e;
    const auto known = logarithms(*e.ring, e.x);
    ASSERT_EQ(known.size(), 2U);
    for (const Logarithm& log : known)
        EXPECT_EQ(e.ring->multiply(log.argument, log.derivative), e.ring->derivative(log.argument, e.x));
}

} // namespace
