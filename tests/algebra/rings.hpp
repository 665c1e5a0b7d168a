// SPDX-License-Identifier: GPL-3.0-or-later
// Rings for the tests of this room: one with every kind of generator, and random elements of any ring.
#pragma once

#include "algebra/ring/ring.hpp"

#include <random>
#include <string>
#include <utility>

namespace resonform::testing {

inline Generator named(GeneratorKind kind, const std::string& name, bool positive = false, int weight = 0) {
    Generator g;
    g.kind = kind;
    g.name = name;
    g.positive = positive;
    g.weight = weight;
    return g;
}

inline GeneratorId add_root(RingBuilder& builder, const std::string& name, int index, Polynomial radicand) {
    Generator g = named(GeneratorKind::root, name);
    g.index = index;
    g.radicand = std::move(radicand);
    return builder.add(std::move(g));
}

// z, zbar, eps, g > 0, r > 0, v, xi, G = g^(1/2), sigma = (xi^2 + r^2)^(1/4), C, e^(i theta)
inline RingPtr pendulum_ring() {
    RingBuilder b;
    Generator z = named(GeneratorKind::fast, "z1", false, 1),
              zbar = named(GeneratorKind::fast, "z2", false, 1);
    z.conjugate = 2;
    zbar.conjugate = 1;
    b.add(z);
    b.add(zbar);
    b.add(named(GeneratorKind::small, "eps", false, 1));
    const GeneratorId g = b.add(named(GeneratorKind::parameter, "g", true));
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    b.add(named(GeneratorKind::parameter, "v"));
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    add_root(b, "G", 2, b.gen(g));
    add_root(b, "sigma", 4, b.gen(xi, 2) + b.gen(r, 2));
    b.add(named(GeneratorKind::constant, "C"));
    b.add(named(GeneratorKind::phase, "u"));
    return b.freeze();
}

// A power of a generator that the ring has.
inline Polynomial gen(const Ring& ring, const std::string& name, int exponent = 1) {
    return ring.gen(ring.find(name).value(), exponent);
}

// Up to `terms` terms with exponents in 0 ... degree, for invertible generators in -degree ... degree.
inline Polynomial random_polynomial(const Ring& ring, std::mt19937& random, int terms = 4, int degree = 3) {
    const auto pick = [&random](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    std::vector<Term> out;
    for (int n = pick(1, terms); n > 0; --n) {
        Monomial m;
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            if (pick(0, 2) == 0) continue; // sparse
            const int low = ring.generator(id).invertible ? -degree : 0;
            m = m + ring.monomial(id, pick(low, degree));
        }
        out.push_back({m, Rational(pick(-9, 9)) / Rational(pick(1, 6))});
    }
    return ring.reduce(Polynomial::from_terms(std::move(out)));
}

// p written with the names of the ring, for messages of failed tests.
inline std::string text(const Ring& ring, const Polynomial& p) {
    std::string out;
    for (const Term& t : p.terms()) {
        out += (out.empty() ? "" : " + ") + to_string(t.coefficient);
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const int e = ring.exponent(t.monomial, id);
            if (e != 0) out += "*" + ring.generator(id).name + "^" + std::to_string(e);
        }
    }
    return out.empty() ? "0" : out;
}

} // namespace resonform::testing
