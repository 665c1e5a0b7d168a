// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of a differential ring with conjugation, for random elements of rings whose relations are
// of every kind (canonical or not).
#include "rings.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace resonform {
namespace {

using testing::add_root;
using testing::named;
using testing::random_polynomial;
using testing::text;

struct Case {
    const char* name;
    RingPtr (*make)();
    bool canonical; // equal elements have equal forms
};

// sigma^2 = xi^2 + r^2 and tau^3 = 2 xi + g: each eliminates another variable, or none.
RingPtr two_roots() {
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    const GeneratorId g = b.add(named(GeneratorKind::parameter, "g"));
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    add_root(b, "sigma", 2, b.gen(xi, 2) + b.gen(r, 2));
    add_root(b, "tau", 3, Rational(2) * b.gen(xi) + b.gen(g));
    return b.freeze();
}

// All variables are invertible: nothing can be eliminated.
RingPtr not_canonical() {
    RingBuilder b;
    const GeneratorId r = b.add(named(GeneratorKind::parameter, "r", true));
    const GeneratorId x = b.add(named(GeneratorKind::slow, "x", true));
    add_root(b, "sigma", 2, b.gen(x) + b.gen(r));
    add_root(b, "tau", 4, b.gen(x, 2) + b.multiply(b.gen(x), b.gen(r)) + b.gen(r, 2));
    return b.freeze();
}

RingPtr nested() {
    RingBuilder b;
    const GeneratorId g = b.add(named(GeneratorKind::parameter, "g", true));
    const GeneratorId xi = b.add(named(GeneratorKind::slow, "xi"));
    const GeneratorId sigma = add_root(b, "sigma", 2, b.gen(xi, 2) + b.gen(g));
    add_root(b, "tau", 2, b.gen(sigma) + b.gen(g));
    add_root(b, "G", 3, b.gen(g));
    return b.freeze();
}

RingPtr numeric_and_monomial() {
    RingBuilder b;
    const GeneratorId a = b.add(named(GeneratorKind::parameter, "a", true));
    const GeneratorId c = b.add(named(GeneratorKind::slow, "c", true));
    add_root(b, "t2", 2, Polynomial(Rational(2)));
    add_root(b, "A", 2, Rational(3) * b.gen(a, 3));
    add_root(b, "P", 3, b.multiply(b.gen(a), b.gen(c)));
    return b.freeze();
}

class RingLaws : public ::testing::TestWithParam<Case> {
protected:
    RingPtr ring = GetParam().make();
    std::mt19937 random{20240501};
    Polynomial any() { return random_polynomial(*ring, random, 3, 2); }
    void expect_same(const Polynomial& a, const Polynomial& b) {
        if (GetParam().canonical) {
            EXPECT_EQ(a, b) << text(*ring, a) << "\n" << text(*ring, b);
        }
        EXPECT_EQ(ring->is_zero(a - b), Zero::yes) << text(*ring, a) << "\n" << text(*ring, b);
    }
    void each_independent(const std::function<void(GeneratorId)>& check) {
        for (GeneratorId id = 0; id < ring->size(); ++id) {
            const GeneratorKind kind = ring->generator(id).kind;
            if (kind == GeneratorKind::slow || kind == GeneratorKind::parameter) check(id);
        }
    }
};

TEST_P(RingLaws, ProductsAssociateCommuteAndDistribute) {
    for (int n = 0; n < 25; ++n) {
        const Polynomial a = any(), b = any(), c = any();
        expect_same(ring->multiply(ring->multiply(a, b), c), ring->multiply(a, ring->multiply(b, c)));
        expect_same(ring->multiply(a, b), ring->multiply(b, a));
        expect_same(ring->multiply(a, b + c), ring->multiply(a, b) + ring->multiply(a, c));
        expect_same(ring->dot({{&a, &b}, {&b, &c}}), ring->multiply(b, a + c));
        expect_same(ring->power(a, 3), ring->multiply(a, ring->multiply(a, a)));
    }
}

TEST_P(RingLaws, RelationsHold) {
    for (GeneratorId id = 0; id < ring->size(); ++id) {
        const Generator& g = ring->generator(id);
        if (g.kind != GeneratorKind::root) continue;
        expect_same(ring->gen(id, g.index), ring->reduce(g.radicand));
        expect_same(ring->multiply(ring->gen(id, -1), ring->gen(id)), ring->one());
        const auto inverse = ring->inverse(g.radicand);
        ASSERT_TRUE(inverse) << g.name;
        expect_same(*inverse, ring->gen(id, -g.index));
        each_independent([&](GeneratorId v) { // differentiated: k sigma^(k-1) sigma' = P'
            const Polynomial left =
                ring->multiply(ring->gen(id, g.index - 1), ring->derivative(ring->gen(id), v));
            expect_same(Rational(g.index) * left, ring->derivative(g.radicand, v));
        });
    }
}

TEST_P(RingLaws, DerivativesObeyLeibnizAndCommute) {
    for (int n = 0; n < 8; ++n) {
        const Polynomial a = any(), b = any();
        each_independent([&](GeneratorId x) {
            const Polynomial da = ring->derivative(a, x), db = ring->derivative(b, x);
            expect_same(ring->derivative(ring->multiply(a, b), x),
                        ring->multiply(da, b) + ring->multiply(a, db));
            each_independent([&](GeneratorId y) {
                expect_same(ring->derivative(da, y), ring->derivative(ring->derivative(a, y), x));
            });
        });
    }
}

TEST_P(RingLaws, ConjugationIsAnAutomorphism) {
    for (int n = 0; n < 25; ++n) {
        const Polynomial a = any(), b = any();
        EXPECT_EQ(ring->conjugate(ring->conjugate(a)), a);
        expect_same(ring->conjugate(ring->multiply(a, b)),
                    ring->multiply(ring->conjugate(a), ring->conjugate(b)));
        each_independent([&](GeneratorId x) {
            expect_same(ring->conjugate(ring->derivative(a, x)), ring->derivative(ring->conjugate(a), x));
        });
    }
}

TEST_P(RingLaws, UnitsHaveInverses) {
    for (int n = 0; n < 25; ++n) {
        Polynomial unit = ring->one();
        for (GeneratorId id = 0; id < ring->size(); ++id) {
            const int e = static_cast<int>(random() % 7U) - 3;
            if (ring->generator(id).invertible) unit = ring->multiply(unit, ring->gen(id, e));
        }
        const auto inverse = ring->inverse(Rational(-2) / 3 * unit);
        ASSERT_TRUE(inverse) << text(*ring, unit);
        expect_same(Rational(-2) / 3 * ring->multiply(unit, *inverse), ring->one());
    }
}

TEST_P(RingLaws, ExpandedFormHasTheSameValue) {
    for (int n = 0; n < 25; ++n) {
        const Polynomial p = any();
        Polynomial total;
        for (const auto& element : ring->expanded_form(p)) {
            total = total + ring->multiply(Polynomial(element.first, Rational(1)), element.second);
            for (GeneratorId id = 0; id < ring->size(); ++id) {
                const Generator& g = ring->generator(id);
                int lowest = 1000;
                for (const Term& t : element.second.terms())
                    lowest = std::min(lowest, ring->exponent(t.monomial, id));
                EXPECT_GE(lowest, 0) << g.name;
                if (g.invertible && g.kind != GeneratorKind::imaginary) {
                    EXPECT_EQ(lowest, 0) << g.name;
                }
                if (!g.invertible) {
                    EXPECT_EQ(ring->exponent(element.first, id), 0) << g.name;
                }
            }
        }
        expect_same(total, p);
    }
}

TEST_P(RingLaws, NonZeroIsProved) {
    for (int n = 0; n < 25; ++n) {
        const Polynomial p = any();
        if (ring->is_zero(p) == Zero::yes) continue;
        EXPECT_EQ(ring->is_zero(p), Zero::no) << text(*ring, p);
    }
}

TEST_P(RingLaws, CollectedPartsAddUp) {
    for (int n = 0; n < 25; ++n) {
        const Polynomial p = any();
        Polynomial total;
        for (const auto& group : ring->collect(p, {0, 2, ring->size() - 1})) {
            total = total + ring->multiply(Polynomial(group.first, Rational(1)), group.second);
        }
        EXPECT_EQ(total, p);
    }
}

INSTANTIATE_TEST_SUITE_P(Rings, RingLaws,
                         ::testing::Values(Case{"pendulum", testing::pendulum_ring, true},
                                           Case{"two_roots", two_roots, true},
                                           Case{"not_canonical", not_canonical, false},
                                           Case{"nested", nested, false},
                                           Case{"numeric_and_monomial", numeric_and_monomial, true}),
                         [](const auto& which) { return std::string(which.param.name); });

} // namespace
} // namespace resonform
