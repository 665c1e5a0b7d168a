// SPDX-License-Identifier: GPL-3.0-or-later
// Known answers of the expression graph.
#include "emit/graph/graph.hpp"

#include "algebra/number/error.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

class GraphOfTwoSymbols : public ::testing::Test {
protected:
    Graph graph;
    Graph::Node x = graph.symbol("x"), y = graph.symbol("y");
    Graph::Node number(int n, int d = 1) { return graph.rational(Rational(n) / d); }
};

} // namespace

TEST_F(GraphOfTwoSymbols, EqualExpressionsAreOneNode) {
    EXPECT_EQ(graph.add({x, y}), graph.add({y, x}));
    EXPECT_EQ(graph.multiply({x, graph.multiply({y, x})}), graph.multiply({graph.power(x, 2), y}));
    EXPECT_EQ(graph.add({graph.add({x, number(2)}), graph.add({y, number(-2)})}), graph.add({x, y}));
    EXPECT_EQ(graph.symbol("x"), x);
    EXPECT_NE(graph.function(Graph::Op::sin, {x}), graph.function(Graph::Op::cos, {x}));
}

TEST_F(GraphOfTwoSymbols, NumbersAreFolded) {
    EXPECT_EQ(graph.add({number(1, 3), number(1, 6)}), number(1, 2));
    EXPECT_EQ(graph.multiply({number(2), x, number(1, 2)}), x);
    EXPECT_EQ(graph.multiply({number(0), x}), number(0));
    EXPECT_EQ(graph.add({x, graph.negate(x)}), number(0));
    EXPECT_EQ(graph.add({x, x}), graph.multiply({number(2), x}));
    EXPECT_EQ(graph.power(number(2, 3), -2), number(9, 4));
    EXPECT_EQ(graph.function(Graph::Op::exp, {number(0)}), number(1));
    EXPECT_EQ(graph.function(Graph::Op::log, {number(1)}), number(0));
}

TEST_F(GraphOfTwoSymbols, ExactRootsAreFoldedAndOthersKept) {
    EXPECT_EQ(graph.root(number(4), 2), number(2));
    EXPECT_EQ(graph.root(number(16, 81), 4), number(2, 3));
    const Graph::Node root_2 = graph.root(number(2), 2);
    EXPECT_EQ(graph.at(root_2).op, Graph::Op::root);
    EXPECT_EQ(graph.power(root_2, 2), number(2));
}

// Of 1 - cos(x) in double, 8 of 16 digits are left at x = 1e-4.
TEST_F(GraphOfTwoSymbols, ADifferenceOfCosinesIsASquare) {
    const Graph::Node cosine = graph.function(Graph::Op::cos, {x});
    const Graph::Node square =
        graph.power(graph.function(Graph::Op::sin, {graph.multiply({number(1, 2), x})}), 2);
    EXPECT_EQ(graph.add({number(1), graph.negate(cosine)}), graph.multiply({number(2), square}));
    EXPECT_EQ(graph.add({graph.multiply({number(3), y, cosine}), graph.multiply({number(-3), y}), number(7)}),
              graph.add({graph.multiply({number(-6), y, square}), number(7)}));
    for (const Graph::Node other : {graph.add({number(1), cosine}),               //
                                    graph.add({number(2), graph.negate(cosine)}), //
                                    graph.add({y, graph.negate(cosine)}),         //
                                    graph.add({number(1), graph.negate(graph.power(cosine, 2))})})
        EXPECT_EQ(graph.at(other).operands.size(), 2U) << "nothing of it is joined";
    EXPECT_EQ(graph.at(graph.add({number(1), cosine})).op, Graph::Op::add);
}

// x^(-13/8) = x^-2 x^(1/4) x^(1/8), from the square roots of x one inside the other.
TEST_F(GraphOfTwoSymbols, PowersOfFineRootsAreProductsOfNestedRoots) {
    const Graph::Node eighth = graph.root(x, 8), fourth = graph.root(x, 4);
    EXPECT_EQ(graph.at(eighth).operands.front(), fourth);
    EXPECT_EQ(graph.power(eighth, 8), x);
    EXPECT_EQ(graph.power(eighth, 2), fourth);
    EXPECT_EQ(graph.power(eighth, -13), graph.multiply({graph.power(x, -2), fourth, eighth}));
    EXPECT_EQ(graph.multiply({graph.power(eighth, 3), graph.power(eighth, 5)}), x);
    EXPECT_EQ(graph.power(graph.root(x, 3), -2), graph.multiply({graph.power(x, -1), graph.root(x, 3)}));
}

TEST_F(GraphOfTwoSymbols, OperandsComeBeforeTheirUsers) {
    graph.multiply({graph.add({x, y}), graph.root(graph.add({graph.power(x, 2), number(1)}), 8)});
    for (std::size_t n = 0; n < graph.size(); ++n)
        for (const Graph::Node operand : graph.at(static_cast<Graph::Node>(n)).operands)
            EXPECT_LT(operand, static_cast<Graph::Node>(n));
}

TEST_F(GraphOfTwoSymbols, DivisionByZeroAndRootsOfNegativeNumbersAreRefused) {
    const Error division = test::error_when([&] { graph.power(number(0), -1); });
    EXPECT_EQ(division.kind(), ErrorKind::refused);
    EXPECT_EQ(division.diagnostic().rule, "a division by zero cannot be emitted");
    const Error root = test::error_when([&] { graph.root(number(-2), 2); });
    EXPECT_EQ(root.kind(), ErrorKind::refused);
    EXPECT_EQ(root.diagnostic().value, "-2");
}

} // namespace resonform
