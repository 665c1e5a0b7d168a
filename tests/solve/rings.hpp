// SPDX-License-Identifier: GPL-3.0-or-later
// Rings for the tests of quadratures and of hand-typed normal forms.
#pragma once

#include "algebra/ring/ring.hpp"

#include <string>

namespace resonform::testing {

inline Generator generator(GeneratorKind kind, const std::string& name, bool positive = false) {
    Generator g;
    g.kind = kind;
    g.name = name;
    g.positive = positive;
    g.invertible = positive;
    g.weight = kind == GeneratorKind::fast || kind == GeneratorKind::small ? 1 : 0;
    return g;
}

inline Generator root(const std::string& name, int index, const Polynomial& radicand) {
    Generator g = generator(GeneratorKind::root, name, true);
    g.index = index;
    g.radicand = radicand;
    return g;
}

// i, r > 0, v, x, rho with rho^8 = x^2 + r^2
struct EighthRoot {
    RingPtr ring;
    GeneratorId r, v, x, rho;

    EighthRoot() {
        RingBuilder b;
        r = b.add(generator(GeneratorKind::parameter, "r", true));
        v = b.add(generator(GeneratorKind::parameter, "v"));
        x = b.add(generator(GeneratorKind::slow, "x"));
        rho = b.add(root("rho", 8, b.gen(x, 2) + b.gen(r, 2)));
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
