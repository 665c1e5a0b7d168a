// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the graph of coefficients: against exact rationals at random points, and of what it decides by
// values.
#include "algebra/graph/bounds.hpp"
#include "algebra/graph/coefficient_graph.hpp"
#include "algebra/graph/derivative.hpp"
#include "algebra/graph/expansion.hpp"
#include "algebra/number/error.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

Rational same(const Rational& q) { return q; }

// Random coefficients built from leaves, together with what builds the same number.
class Coefficients : public ::testing::Test {
protected:
    static constexpr int variables = 3;
    CoefficientGraph graph;
    std::vector<LeafId> leaves;
    std::mt19937_64 random{7};

    void SetUp() override {
        for (const char* name : {"a", "b", "c"}) leaves.push_back(graph.add_leaf(name));
    }
    Coefficient leaf(std::size_t k) { return graph.leaf(leaves[k]); }
    int small() { return static_cast<int>(random() % 9U) - 4; }

    bool equal(Coefficient a, Coefficient b) { return graph.sum(a, b.negative()).is_zero(); }

    LeafPolynomial linear() {
        LeafPolynomial p;
        while (p.empty())
            for (const LeafId id : leaves) p.add({{id, 1}}, small());
        return p;
    }

    [[nodiscard]] std::vector<Rational> point(std::uint64_t seed) const {
        std::mt19937_64 numbers(seed);
        std::vector<Rational> result;
        for (int k = 0; k < variables; ++k)
            result.push_back(Rational(static_cast<int>(numbers() % 97U) + 3) /
                             static_cast<int>(numbers() % 11U + 5));
        return result;
    }

    [[nodiscard]] std::optional<Rational> value(Coefficient c, const std::vector<Rational>& at) const {
        const GraphReplay replay(graph, {c});
        const auto values = replay.evaluate<Rational>([&](LeafId id) { return at[id]; }, same);
        return values ? std::optional(values->front()) : std::nullopt;
    }

    static Rational value(const LeafPolynomial& p, const std::vector<Rational>& at) {
        return p.evaluate<Rational>([&](LeafId id, int exponent) { return cln::expt(at[id], exponent); },
                                    same);
    }
};

TEST_F(Coefficients, agree_with_exact_rationals) {
    const std::vector<Rational> at = point(3);
    std::vector<Coefficient> made{leaf(0), leaf(1), leaf(2), graph.number(Rational(2) / 3)};
    std::vector<Rational> numbers{at[0], at[1], at[2], Rational(2) / 3};
    for (int step = 0; step < 200; ++step) {
        const std::size_t i = random() % made.size(), j = random() % made.size();
        switch (random() % 4) {
        case 0:
            made.push_back(graph.sum(made[i], made[j]));
            numbers.push_back(numbers[i] + numbers[j]);
            break;
        case 1:
            made.push_back(graph.product(made[i], made[j]));
            numbers.push_back(numbers[i] * numbers[j]);
            break;
        case 2: {
            const LeafPolynomial p = linear();
            if (value(p, at) == 0) break;
            made.push_back(graph.inverse(p));
            numbers.push_back(1 / value(p, at));
            break;
        }
        default: {
            std::vector<GraphTerm> terms;
            Rational total = 0;
            for (int k = 0; k < 5; ++k) {
                const std::size_t l = random() % made.size(), r = random() % made.size();
                if (made[l].is_zero() || made[r].is_zero()) continue;
                const Coefficient factor = graph.number(Rational(2 * small() + 1) / 6);
                const RationalId f = graph.rationals().multiply(
                    factor.factor, graph.rationals().multiply(made[l].factor, made[r].factor));
                terms.push_back({f, made[l].node, made[r].node});
                total = total + graph.rationals().value(factor.factor) * numbers[l] * numbers[r];
            }
            made.push_back(graph.dot(terms));
            numbers.push_back(total);
        }
        }
        if (made.size() > 40) made.erase(made.begin() + 4), numbers.erase(numbers.begin() + 4);
        ASSERT_EQ(value(made.back(), at), numbers.back()) << step;
    }
}

TEST_F(Coefficients, nodes_of_equal_values_are_one) {
    const Coefficient a = leaf(0), b = leaf(1);
    const Coefficient difference = graph.sum(a, b.negative()), sum = graph.sum(a, b);
    const Coefficient product = graph.product(difference, sum);
    const Coefficient squares = graph.sum(graph.product(a, a), graph.product(b, b).negative());
    EXPECT_EQ(product, squares);
    EXPECT_EQ(graph.sum(b, a.negative()), difference.negative());
    EXPECT_GT(graph.decisions().merged, 0U);
    // 1/(a - b) - 1/(a + b) = 2 b/(a^2 - b^2)
    LeafPolynomial minus, plus;
    minus.add({{leaves[0], 1}}, 1), minus.add({{leaves[1], 1}}, -1);
    plus.add({{leaves[0], 1}}, 1), plus.add({{leaves[1], 1}}, 1);
    const Coefficient left = graph.sum(graph.inverse(minus), graph.inverse(plus).negative());
    const Coefficient right = graph.product(graph.scaled(graph.rationals().intern(2), b),
                                            graph.product(graph.inverse(minus), graph.inverse(plus)));
    EXPECT_TRUE(equal(left, right)); // their nodes may differ by a number
    EXPECT_EQ(graph.product(a, graph.inverse(LeafPolynomial::leaf(leaves[0]))), graph.number(1));
}

TEST_F(Coefficients, zero_is_seen_by_value) {
    const Coefficient a = leaf(0), b = leaf(1);
    const Coefficient square = graph.power(graph.sum(a, b), 2);
    std::vector<GraphTerm> terms{{square.factor, square.node, CoefficientGraph::one_node},
                                 {RationalTable::minus_one, a.node, a.node},
                                 {RationalTable::minus_one, b.node, b.node},
                                 {graph.rationals().intern(-2), a.node, b.node}};
    EXPECT_TRUE(graph.dot(terms).is_zero());
    EXPECT_EQ(graph.decisions().zeros, 1U);
    EXPECT_LT(bounds_of(graph).error_probability, 1e-30);
}

// The content and the sign of what is divided by are taken out by its form.
TEST_F(Coefficients, divisors_are_primitive) {
    LeafPolynomial p; // -4 a^2 b + 6 a b^2 = -2 a b (2 a - 3 b)
    p.add({{leaves[0], 2}, {leaves[1], 1}}, -4);
    p.add({{leaves[0], 1}, {leaves[1], 2}}, 6);
    const LeafPolynomial::Parts parts = p.parts();
    EXPECT_EQ(parts.primitive.degree(), 1);
    EXPECT_EQ(parts.monomial, (LeafPowers{{leaves[0], 1}, {leaves[1], 1}}));
    const Coefficient inverse = graph.inverse(p);
    EXPECT_EQ(graph.divisors(), 3U);
    EXPECT_TRUE(equal(graph.product(inverse, graph.polynomial(p)), graph.number(1)));
    LeafPolynomial other; // the same but for its factors
    other.add({{leaves[0], 1}}, Rational(1) / 3);
    other.add({{leaves[1], 1}}, Rational(-1) / 2);
    EXPECT_TRUE(equal(graph.product(graph.inverse(other), graph.polynomial(other)), graph.number(1)));
    EXPECT_EQ(graph.divisors(), 3U);
}

// Signs and numbers of nodes do not depend on the points.
TEST(CoefficientGraph, is_the_same_for_every_seed) {
    const auto build = [](std::uint64_t seed) {
        CoefficientGraph graph(seed);
        std::mt19937_64 random(5);
        std::vector<Coefficient> made;
        for (const char* name : {"a", "b", "c"}) made.push_back(graph.leaf(graph.add_leaf(name)));
        std::vector<std::pair<RationalId, NodeId>> trace;
        for (int step = 0; step < 300; ++step) {
            const Coefficient x = made[random() % made.size()], y = made[random() % made.size()];
            made.push_back(step % 3 == 0 ? graph.product(x, y)
                                         : graph.sum(x, step % 2 == 0 ? y.negative() : y));
            trace.emplace_back(made.back().factor, made.back().node);
            if (made.size() > 12) made.erase(made.begin() + 3);
        }
        return trace;
    };
    EXPECT_EQ(build(1), build(2));
    EXPECT_EQ(build(1), build(1));
}

TEST_F(Coefficients, derivative_obeys_leibniz) {
    GraphDerivation derivation(graph);
    const auto of_leaf = [&](LeafId id) { // a' = b, b' = a c, c' = 1
        if (id == leaves[0]) return graph.leaf(leaves[1]);
        if (id == leaves[1]) return graph.product(graph.leaf(leaves[0]), graph.leaf(leaves[2]));
        return graph.number(1);
    };
    const auto d = [&](Coefficient c) { return derivation(c, of_leaf); };
    for (int n = 0; n < 20; ++n) {
        const Coefficient x = graph.product(graph.inverse(linear()), graph.polynomial(linear()));
        const Coefficient y = graph.sum(graph.inverse(linear()), graph.product(x, leaf(0)));
        EXPECT_TRUE(equal(d(graph.product(x, y)), graph.sum(graph.product(d(x), y), graph.product(x, d(y)))));
        EXPECT_TRUE(equal(d(graph.sum(x, y)), graph.sum(d(x), d(y))));
        const LeafPolynomial p = linear();
        EXPECT_TRUE(equal(graph.product(d(graph.inverse(p)), graph.power(graph.polynomial(p), 2)),
                          d(graph.polynomial(p)).negative()));
    }
}

TEST_F(Coefficients, expand_to_quotients) {
    for (int n = 0; n < 12; ++n) {
        // (p/q + r/(q s)) t, with a common factor now and then
        const LeafPolynomial q = linear(), s = linear();
        const Coefficient first = graph.product(graph.polynomial(linear()), graph.inverse(q));
        const Coefficient second = graph.product(graph.inverse(q), graph.inverse(s));
        Coefficient c =
            graph.product(graph.sum(first, graph.scaled(graph.rationals().intern(Rational(3) / 7), second)),
                          graph.polynomial(n % 3 == 0 ? q : linear()));
        const ExpandedCoefficient expanded = expand(graph, c);
        const std::vector<Rational> at = point(static_cast<std::uint64_t>(n) + 11);
        Rational below = 1;
        for (const auto& [divisor, times] : expanded.denominator)
            below = below * cln::expt(value(graph.divisor(divisor), at), times);
        ASSERT_EQ(value(c, at), value(expanded.numerator, at) / below) << n;
        for (const auto& power : expanded.denominator) // q is gone where it was multiplied with
            if (n % 3 == 0 && q.parts().primitive != s.parts().primitive) {
                EXPECT_NE(graph.divisor(power.first), q.parts().primitive);
            }
    }
    EXPECT_TRUE(expand(graph, {}).numerator.empty());
    EXPECT_EQ(expand(graph, graph.number(Rational(-5) / 3)).numerator, LeafPolynomial({}, Rational(-5) / 3));
}

TEST_F(Coefficients, expansion_keeps_its_limit) {
    const Coefficient c = graph.product(graph.power(graph.polynomial(linear()), 12), graph.inverse(linear()));
    const Error error = test::error_when([&] { static_cast<void>(expand(graph, c, {10})); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("up to 10 points"), std::string::npos) << error.what();
}

TEST_F(Coefficients, replay_modulo_primes_and_in_rationals_agree) {
    std::vector<Coefficient> wanted;
    for (int n = 0; n < 10; ++n)
        wanted.push_back(graph.sum(graph.product(graph.inverse(linear()), graph.polynomial(linear())),
                                   graph.scaled(graph.rationals().intern(Rational(small()) / 5), leaf(1))));
    wanted.emplace_back();
    const GraphReplay replay(graph, wanted);
    const PrimeField field(random_prime(random));
    ModularReplay modular(replay, field);
    std::vector<ModularReplay::Block> points(replay.leaves().size());
    for (std::size_t b = 0; b < ModularReplay::block; ++b)
        for (std::size_t k = 0; k < points.size(); ++k)
            points[k][b] = *field.from(point(b)[replay.leaves()[k]]);
    const auto blocks = modular.evaluate(points);
    ASSERT_TRUE(blocks.has_value());
    for (std::size_t b = 0; b < ModularReplay::block; ++b) {
        const std::vector<Rational> at = point(b);
        const auto exact = replay.evaluate<Rational>([&](LeafId id) { return at[id]; }, same);
        ASSERT_TRUE(exact.has_value());
        for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_EQ((*blocks)[k][b], *field.from((*exact)[k]));
    }
}

TEST(PrimeFields, sums_of_products_are_reduced_once) {
    std::mt19937_64 random(9);
    const PrimeField field(random_prime(random));
    const Montgomery form(field);
    PrimeField::ProductSum sum(field);
    Montgomery::Wide wide = 0;
    Residue expected = 0;
    for (int n = 0; n < 1000; ++n) {
        const Residue a = field.prime() - 1 - random() % 5,
                      b = n % 2 == 0 ? field.prime() - 1 : field.random_unit(random);
        expected = field.add(expected, field.multiply(a, b));
        sum.add(a, b);
        form.accumulate(wide, form.enter(a), form.enter(b));
        EXPECT_EQ(sum.value(), expected);
        EXPECT_EQ(form.leave(form.reduce(wide)), expected);
    }
}

} // namespace
} // namespace resonform
