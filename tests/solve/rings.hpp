// SPDX-License-Identifier: GPL-3.0-or-later
// Rings for the tests of quadratures and of hand-typed normal forms.
#pragma once

#include "algebra/ring/ring.hpp"
#include "support/generators.hpp"

namespace resonform::testing {

using test::named;
using test::root_of;

// i, r > 0, v, x, rho with rho^8 = x^2 + r^2
struct EighthRoot {
    RingPtr ring;
    GeneratorId r, v, x, rho;

    EighthRoot() {
        RingBuilder b;
        r = b.add(named(GeneratorKind::parameter, "r", true));
        v = b.add(named(GeneratorKind::parameter, "v"));
        x = b.add(named(GeneratorKind::slow, "x"));
        rho = b.add(root_of("rho", 8, b.gen(x, 2) + b.gen(r, 2)));
        ring = b.freeze();
    }

    // c r^a v^b x^n rho^m
    [[nodiscard]] Polynomial term(const Rational& c, int a, int b, int n, int m) const {
        Polynomial p = c * ring->gen(r, a);
        p = ring->multiply(p, ring->gen(v, b));
        p = ring->multiply(p, ring->gen(x, n));
        return ring->multiply(p, ring->gen(rho, m));
    }
};

} // namespace resonform::testing
