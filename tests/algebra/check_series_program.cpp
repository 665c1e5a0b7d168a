// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of graded series: against Taylor's formulas, by their functional equations, and
// correct() against a run that had the right input from the start.
#include "algebra/number/error.hpp"
#include "algebra/series/series_program.hpp"
#include "rings.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace resonform {
namespace {

using Node = SeriesProgram::Node;
using testing::gen;
using testing::text;

constexpr int through = 7;

class Functions : public ::testing::Test {
protected:
    RingPtr ring = testing::pendulum_ring();
    SeriesProgram program{ring};
    Node u = program.input("u");
    std::mt19937 random{11};

    // A random homogeneous part.
    Polynomial part(int weight) {
        Polynomial p = Rational(weight) * ring->multiply(gen(*ring, "z1", weight), gen(*ring, "sigma", -1));
        for (int n = 0; n < 2; ++n) {
            const int a = static_cast<int>(random() % static_cast<unsigned>(weight + 1));
            const Polynomial powers = ring->multiply(gen(*ring, "z2", a), gen(*ring, "eps", weight - a));
            const Rational c = Rational(static_cast<int>(random() % 9U) - 4) / 3;
            p = p + c * ring->multiply(powers, gen(*ring, n == 0 ? "xi" : "G"));
        }
        return p;
    }
    // u = start + random parts of weight 1 ... through.
    Series random_series(const Polynomial& start) {
        Series s;
        s.set(0, start);
        for (int n = 1; n <= through; ++n) s.set(n, part(n));
        return s;
    }
    SeriesRun run(const Series& input) const {
        SeriesRun r(program);
        for (int n = 0; n <= through; ++n) {
            r.set_input(u, n, input.part(n));
            r.advance(n);
        }
        return r;
    }
    // sum_k c_k (input - start)^k through the weight, by plain products.
    Series taylor(const Series& input, const std::function<Rational(int)>& c) const {
        Series small = input;
        small.set(0, Polynomial());
        Series power({ring->one()}), total;
        for (int k = 0; k <= through; ++k) {
            for (int n = 0; n <= through; ++n) total.set(n, total.part(n) + c(k) * power.part(n));
            power = multiply(*ring, power, small, through);
        }
        return total;
    }
    void expect_same(const Series& a, const Series& b) const {
        for (int n = 0; n <= through; ++n) {
            EXPECT_EQ(a.part(n), b.part(n)) << "weight " << n << "\n"
                                            << text(*ring, a.part(n)) << "\n"
                                            << text(*ring, b.part(n));
        }
    }
    Series constant(const Polynomial& p) const { return Series::split(*ring, p, through); }
};

Rational factorial(int k) { return k < 2 ? Rational(1) : Rational(k) * factorial(k - 1); }

TEST_F(Functions, AgreeWithTaylorAboutZero) {
    const Node s = program.sine(u), c = program.cosine(u), e = program.exponential(u);
    const Node square = program.product(u, u);
    const Node slope = program.power(program.sum({{1, program.constant(ring->one())}, {1, square}}), -1);
    const Node atan = program.antiderivative(u, slope);
    const Series input = random_series(Polynomial());
    const SeriesRun r = run(input);
    const auto sign = [](int k) { return Rational(k % 4 < 2 ? 1 : -1); };
    expect_same(r.series(s), taylor(input, [&](int k) { return k % 2 == 1 ? sign(k) / factorial(k) : 0; }));
    expect_same(r.series(c), taylor(input, [&](int k) { return k % 2 == 0 ? sign(k) / factorial(k) : 0; }));
    expect_same(r.series(e), taylor(input, [](int k) { return 1 / factorial(k); }));
    expect_same(r.series(atan), taylor(input, [&](int k) { return k % 2 == 1 ? sign(k) / k : 0; }));
}

TEST_F(Functions, AgreeWithTaylorAboutOne) {
    const Rational a = Rational(-3) / 4;
    const Node l = program.logarithm(u), p = program.power(u, a);
    const Series input = random_series(ring->one());
    const SeriesRun r = run(input);
    expect_same(r.series(l),
                taylor(input, [](int k) { return k == 0 ? 0 : Rational(k % 2 == 1 ? 1 : -1) / k; }));
    expect_same(r.series(p), taylor(input, [&](int k) {
                    Rational binomial = 1;
                    for (int j = 0; j < k; ++j) binomial = binomial * (a - j) / (j + 1);
                    return binomial;
                }));
}

TEST_F(Functions, ObeyTheirEquations) {
    const Node s = program.sine(u), c = program.cosine(u);
    const Node one = program.sum({{1, program.product(s, s)}, {1, program.product(c, c)}});
    const Node inverse = program.logarithm(program.exponential(u));
    const Series input = random_series(Polynomial());
    const SeriesRun r = run(input);
    expect_same(r.series(one), constant(ring->one()));
    expect_same(r.series(inverse), input);
}

TEST_F(Functions, PowersOfAUnitThatIsNotOne) {
    const Node half = program.power(u, Rational(1) / 2), back = program.power(half, 2);
    const Node minus = program.power(u, Rational(-3) / 2);
    const Node one = program.product(program.product(minus, u), half);
    const Node reciprocal = program.power(u, -1), unit = program.product(reciprocal, u);
    const Series input =
        random_series(Rational(4) / 9 * gen(*ring, "xi", 2) + Rational(4) / 9 * gen(*ring, "r", 2));
    const SeriesRun r = run(input);
    EXPECT_EQ(r.part(half, 0), Rational(2) / 3 * gen(*ring, "sigma", 2));
    expect_same(r.series(back), input);
    expect_same(r.series(one), constant(ring->one()));
    expect_same(r.series(unit), constant(ring->one()));
}

TEST_F(Functions, NonNegativeIntegerPowersNeedNoUnit) {
    const Node seventh = program.power(u, 7), none = program.power(u, 0);
    const Series input = random_series(gen(*ring, "xi"));
    const SeriesRun r = run(input);
    Series expected({ring->one()});
    for (int k = 0; k < 7; ++k) expected = multiply(*ring, expected, input, through);
    expect_same(r.series(seventh), expected);
    expect_same(r.series(none), constant(ring->one()));
}

// Every node's part after correct() equals that of a run with the corrected inputs.
void expect_corrected(const SeriesProgram& program, Node u, const Series& first, const Series& second) {
    SeriesRun corrected(program), fresh(program);
    for (int n = 0; n <= through; ++n) {
        corrected.set_input(u, n, first.part(n));
        corrected.advance(n);
        corrected.set_input(u, n, second.part(n)); // twice, as a map and then a normal form would
        corrected.set_input(u, n, second.part(n) + second.part(n) - first.part(n));
        corrected.set_input(u, n, second.part(n));
        corrected.correct(n);
        fresh.set_input(u, n, second.part(n));
        fresh.advance(n);
        for (Node k = 0; k < static_cast<Node>(program.instructions().size()); ++k) {
            EXPECT_EQ(corrected.part(k, n), fresh.part(k, n)) << "node " << k << " weight " << n;
        }
    }
}

TEST_F(Functions, CorrectionEqualsRecomputationAboutZero) {
    const Node sine = program.sine(u), cosine = program.cosine(u), e = program.exponential(u);
    const Node product = program.product(program.sum({{2, e}, {Rational(-1) / 3, cosine}}), sine);
    const Node shifted = program.sum({{1, program.constant(ring->one() + gen(*ring, "z1"))}, {1, product}});
    program.logarithm(shifted);
    program.antiderivative(shifted, program.power(shifted, Rational(-2) / 5));
    expect_corrected(program, u, random_series(Polynomial()), random_series(Polynomial()));
}

TEST_F(Functions, CorrectionEqualsRecomputationAboutAUnit) {
    program.power(program.power(u, Rational(-1) / 2), 3);
    const Polynomial s = gen(*ring, "xi", 2) + gen(*ring, "r", 2);
    expect_corrected(program, u, random_series(Polynomial(Rational(9))),
                     random_series(s)); // also at weight 0
}

// f = (1 + z1) (sin u + exp u) + u is asked for at each weight; what only it needs is given back.
TEST_F(Functions, ForgetWhatNoLaterWeightNeeds) {
    const Node sine = program.sine(u), e = program.exponential(u);
    const Node inner = program.sum({{1, sine}, {1, e}});
    const Node outer = program.product(program.constant(ring->one() + gen(*ring, "z1")), inner);
    const Node f = program.sum({{1, outer}, {1, u}});
    const Series input = random_series(Polynomial());
    SeriesRun all(program), forgetful(program);
    for (int n = 0; n <= through; ++n) {
        for (SeriesRun* r : {&all, &forgetful}) {
            r->set_input(u, n, input.part(n));
            r->advance(n);
        }
        EXPECT_EQ(forgetful.part(f, n), all.part(f, n)) << "weight " << n;
        const Polynomial change = n == 0 ? Polynomial() : part(n);
        for (SeriesRun* r : {&all, &forgetful}) {
            r->set_input(u, n, input.part(n) + change);
            r->correct(n);
        }
        EXPECT_EQ(forgetful.part(f, n), all.part(f, n)) << "corrected, weight " << n;
        forgetful.forget();
    }
    EXPECT_EQ(forgetful.part(sine, 1), all.part(sine, 1));               // its recurrence needs it
    EXPECT_EQ(forgetful.part(inner, through), all.part(inner, through)); // z1 times it has weight through + 1
    EXPECT_EQ(forgetful.part(f, 0), all.part(f, 0));
    EXPECT_THROW(static_cast<void>(forgetful.part(f, through)), std::logic_error);
    EXPECT_THROW(static_cast<void>(forgetful.part(inner, through - 1)), std::logic_error);
}

TEST_F(Functions, RefuseOtherStartingValues) {
    const auto rule = [&](Node (SeriesProgram::*function)(Node), const Polynomial& start) {
        SeriesProgram p(ring);
        const Node in = p.input("u");
        (p.*function)(in);
        SeriesRun r(p);
        r.set_input(in, 0, start);
        try {
            r.advance(0);
        } catch (const Error& e) {
            EXPECT_EQ(e.kind(), ErrorKind::refused);
            return e.diagnostic().rule;
        }
        return std::string("accepted");
    };
    const Polynomial r = gen(*ring, "r");
    EXPECT_EQ(rule(&SeriesProgram::sine, r), "a sine is expanded about zero");
    EXPECT_EQ(rule(&SeriesProgram::exponential, r), "an exponential is expanded about exp(0)");
    EXPECT_EQ(rule(&SeriesProgram::logarithm, r), "a logarithm is expanded about log(1)");
    EXPECT_EQ(rule(&SeriesProgram::logarithm, ring->one()), "accepted");

    const Node half = program.power(u, Rational(1) / 2);
    ASSERT_GE(half, 0);
    for (const Polynomial& start : {Polynomial(), gen(*ring, "xi", 2), r, Rational(-1) * ring->one()}) {
        SeriesRun broken(program);
        broken.set_input(u, 0, start);
        EXPECT_THROW(broken.advance(0), Error) << text(*ring, start);
    }
}

TEST_F(Functions, CallsOutOfOrderAreErrorsOfTheProgrammer) {
    SeriesRun r(program);
    EXPECT_THROW(r.advance(1), std::logic_error);
    r.advance(0);
    r.advance(1);
    EXPECT_THROW(r.set_input(u, 0, ring->one()), std::logic_error);
    EXPECT_THROW(r.correct(0), std::logic_error);
    r.set_input(u, 1, gen(*ring, "z1"));
    EXPECT_THROW(r.advance(2), std::logic_error);
}

TEST_F(Functions, EqualOperationsAreOneNode) {
    EXPECT_EQ(program.cosine(u), program.sine(u) + 1);
    EXPECT_EQ(program.sine(u), program.sine(u));
    const Node c = program.constant(gen(*ring, "xi", 2));
    EXPECT_EQ(c, program.constant(gen(*ring, "sigma", 4) - gen(*ring, "r", 2)));
    EXPECT_EQ(program.product(u, c), program.product(c, u));
    EXPECT_EQ(program.sum({{1, u}, {2, c}}), program.sum({{1, c}, {1, u}, {1, c}}));
    EXPECT_EQ(program.sum({{1, u}, {1, c}, {-1, c}}), u);
    EXPECT_EQ(program.power(u, 4), program.product(program.power(u, 2), program.power(u, 2)));
    EXPECT_NE(program.power(u, -1), program.power(u, -2));
    EXPECT_NE(program.input("u"), u);
}

TEST_F(Functions, SeriesKeepTheirParts) {
    const Polynomial p = gen(*ring, "z1", 2) + gen(*ring, "r") + gen(*ring, "eps", 5);
    const Series s = Series::split(*ring, p, 3);
    EXPECT_EQ(s.through(), 3);
    EXPECT_EQ(s.total(9), gen(*ring, "z1", 2) + gen(*ring, "r"));
    EXPECT_EQ(s.total(1), gen(*ring, "r"));
    EXPECT_TRUE(s.part(-1).empty());
    EXPECT_TRUE(s.part(4).empty());
    expect_same(multiply(*ring, s, s, through), constant(ring->power(s.total(3), 2)));
}

} // namespace
} // namespace resonform
