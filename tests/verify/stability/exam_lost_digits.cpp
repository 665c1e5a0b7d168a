// SPDX-License-Identifier: GPL-3.0-or-later
// The part of an output that loses digits is found and named: in graphs of which that is known.
#include "algebra/ring/ring.hpp"
#include "emit/graph/differences.hpp"
#include "emit/graph/lower.hpp"
#include "verify/own_system.hpp"
#include "verify/stability/lost_digits.hpp"
#include "verify/stability/slopes.hpp"
#include "verify/stability/spelled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace resonform {
namespace {

// One output of the parameters a and b at any time, made by `output`.
template <class Output> std::shared_ptr<const Program> made(const Output& output) {
    auto program = std::make_shared<Program>();
    Graph& graph = program->graph;
    program->eps = program->small = graph.symbol("eps");
    program->time = graph.symbol("t");
    program->slow_time = graph.symbol("slow time");
    program->slow_time_end = graph.rational(1);
    const Graph::Node a = graph.symbol("a"), b = graph.symbol("b");
    program->parameters = {{"a", "parameter a", a, graph.rational(1)},
                           {"b", "parameter b", b, graph.rational(1)}};
    program->outputs = {{"x", output(graph, a, b)}};
    return program;
}

// At t = 0, with an output of the scale 1.
std::optional<LostDigits> lost(const std::shared_ptr<const Program>& program, double a, double b) {
    return DigitTracer(std::make_shared<const Interpretation>(program))({0.1, {a, b}, {}, {}}, 1, 0, 0,
                                                                        0x1p-52);
}

Graph::Node per(Graph& graph, Graph::Node n) { return graph.power(n, -1); }

GeneratorId add_parameter(RingBuilder& builder, const char* name) {
    Generator g;
    g.kind = GeneratorKind::parameter;
    g.name = name;
    return builder.add(g);
}

} // namespace

TEST(LostDigits, AreFoundInADifferenceOfNearFrequencies) {
    // b/(sqrt(1 + a) - 1), and more that is done with it
    const auto program = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node one = graph.rational(1);
        const Graph::Node divisor = graph.add({graph.root(graph.add({one, a}), 2), graph.rational(-1)});
        return graph.add({graph.multiply({b, per(graph, divisor)}), graph.function(Graph::Op::sin, {a})});
    });
    const auto found = lost(program, 1e-9, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->expression, "sqrt(1 + a) - 1");
    ASSERT_EQ(found->operands.size(), 2U);
    EXPECT_EQ(found->operands[0].expression, "sqrt(1 + a)");
    EXPECT_EQ(found->operands[1].expression, "-1");
    EXPECT_NEAR(found->value, 5e-10, 1e-15);
    EXPECT_NEAR(found->cancellation, 2e9, 1e3);
    EXPECT_GT(found->growth, 1e7);
    EXPECT_NEAR(found->share, 1, 0.01);
    EXPECT_GT(found->ulp, 1e6);
    EXPECT_FALSE(lost(program, 3, 1)) << "2 - 1 is exact";
}

// With b = 1; of 1 itself the graph writes 2*sin(a/2)^2.
TEST(LostDigits, AreFoundBesideACosineOfASmallAngle) {
    const auto program = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node versed = graph.add({b, graph.negate(graph.function(Graph::Op::cos, {a}))});
        return graph.multiply({graph.root(versed, 2), per(graph, a)});
    });
    const auto found = lost(program, 1.3e-6, 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->expression, "b - cos(a)");
    EXPECT_GT(found->cancellation, 1e12);
    const auto joined = made([](Graph& graph, Graph::Node a, Graph::Node) {
        const Graph::Node versed =
            graph.add({graph.rational(1), graph.negate(graph.function(Graph::Op::cos, {a}))});
        return graph.multiply({graph.root(versed, 2), per(graph, a)});
    });
    EXPECT_FALSE(lost(joined, 1.3e-6, 1));
}

TEST(LostDigits, AreFoundBelowWhereTheErrorIsOnlyPassedOn) {
    const auto slim = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node square = graph.add({graph.rational(1), graph.power(a, 2)});
        const Graph::Node difference = graph.add({graph.root(square, 2), graph.negate(a)});
        return graph.multiply({b, graph.function(Graph::Op::log, {difference})});
    });
    ASSERT_TRUE(lost(slim, 1e5, 1));
    EXPECT_EQ(lost(slim, 1e5, 1)->expression, "sqrt(1 + a^2) - a");
    EXPECT_FALSE(lost(slim, 1e-5, 1));

    // That the result itself vanishes where two large terms meet is not what is told.
    const auto near_zero = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node root = graph.root(graph.add({graph.rational(1), a}), 2);
        const Graph::Node logarithm = graph.function(Graph::Op::log, {root});
        return graph.add({graph.multiply({logarithm, graph.rational(2000000000)}), graph.negate(b)});
    });
    const auto found = lost(near_zero, 1.23456789e-9, 1.2345678);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->expression, "log(sqrt(1 + a))")
        << "the root is rounded, and the logarithm makes it grow";
    EXPECT_GT(found->growth, 1e6);
}

// (e^a - 2 + e^-a)/a^2 and log(1 + a)/a, as they are written and as a lowering and the graph emit them.
TEST(LostDigits, AreKeptByFunctionsOfSmallArguments) {
    using Op = Graph::Op;
    const auto written = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node e = graph.function(Op::exp, {a}), two = graph.rational(-2);
        return graph.multiply({graph.add({e, two, per(graph, e)}), graph.power(a, -2), b});
    });
    ASSERT_TRUE(lost(written, 1e-6, 1));
    EXPECT_EQ(lost(written, 1e-6, 1)->expression, "exp(a) + 1/exp(a) - 2");
    EXPECT_GT(lost(written, 1e-6, 1)->ulp, 1e10);
    const auto lowered = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        RingBuilder builder;
        const GeneratorId e = add_parameter(builder, "e"), x = add_parameter(builder, "x");
        const RingPtr ring = builder.freeze();
        Lowering lowering(graph, ring);
        lowering.define(e, graph.function(Op::exp, {a}), true);
        lowering.define(x, b, true);
        const Polynomial up = ring->gen(e), one = ring->one(), square = ring->multiply(up - one, up - one);
        return graph.multiply({lowering.polynomial(ring->multiply(ring->gen(x), square)),
                               per(graph, graph.function(Op::exp, {a})), graph.power(a, -2)});
    });
    const auto rounding = lost(lowered, 1e-6, 1);
    EXPECT_TRUE(!rounding || rounding->ulp < 4) << rounding->expression;
    EXPECT_EQ(spelled(*lowered, lowered->outputs.front().value), "b*expm1(a)^2/(exp(a)*a^2)");
    const auto joined = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node sum = graph.add({graph.rational(1), a});
        return graph.multiply({graph.function(Op::log, {sum}), per(graph, a), b});
    });
    EXPECT_FALSE(lost(joined, 1e-9, 1));
    EXPECT_EQ(spelled(*joined, joined->outputs.front().value), "b*log1p(a)/a");
}

// b - (a + 1/a) at b = a, beside a term as small: as a sum, and as a difference that is taken first.
TEST(LostDigits, AreKeptByDifferencesInTwiceTheDigits) {
    const auto program_of = [](bool doubled) {
        return made([doubled](Graph& graph, Graph::Node a, Graph::Node b) {
            const Graph::Node rest =
                graph.add({graph.multiply({graph.power(a, 2), per(graph, a)}), per(graph, a)});
            const Graph::Node sum = graph.add({b, graph.negate(graph.multiply({rest, graph.rational(1)}))});
            return graph.multiply({a, doubled ? graph.difference(sum) : sum});
        });
    };
    ASSERT_TRUE(lost(program_of(false), 2.314e7, 2.314e7));
    EXPECT_GT(lost(program_of(false), 2.314e7, 2.314e7)->ulp, 1e6);
    EXPECT_FALSE(lost(program_of(true), 2.314e7, 2.314e7));
    EXPECT_EQ(spelled(*program_of(true), program_of(true)->outputs.front().value), "a*(b - (a + 1/a))");
}

// sqrt(4 a^2 - b^2) at b close to 2 a, as it is written and as a radicand is lowered.
TEST(LostDigits, AreKeptByDifferencesOfSquaresUnderRoots) {
    const auto written = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        const Graph::Node sum = graph.add(
            {graph.multiply({graph.rational(4), graph.power(a, 2)}), graph.negate(graph.power(b, 2))});
        return graph.root(sum, 2);
    });
    const double a = 93.3259, b = 186.65;
    ASSERT_TRUE(lost(written, a, b));
    EXPECT_EQ(lost(written, a, b)->expression, "4*a^2 - b^2");
    const auto lowered = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        RingBuilder builder;
        const GeneratorId x = add_parameter(builder, "x"), y = add_parameter(builder, "y");
        const RingPtr ring = builder.freeze();
        Lowering lowering(graph, ring);
        lowering.define(x, a, true);
        lowering.define(y, b, false);
        const Polynomial p = ring->gen(x), q = ring->gen(y);
        return graph.root(lowering.radicand(Rational(4) * ring->multiply(p, p) - ring->multiply(q, q)), 2);
    });
    EXPECT_FALSE(lost(lowered, a, b));
    EXPECT_EQ(spelled(*lowered, lowered->outputs.front().value), "sqrt((2*a - b)*(b + 2*a))");
}

TEST(LostDigits, OnlyDifferencesOfSquaresAreFactored) {
    Graph graph;
    const Graph::Node a = graph.symbol("a"), b = graph.symbol("b"), square = graph.power(a, 2);
    const auto is_factored = [&](const std::vector<Graph::Node>& terms) {
        const Graph::Node sum = graph.add(terms);
        const std::size_t before = graph.size();
        if (factored_difference(graph, sum) != sum) return true;
        EXPECT_EQ(graph.size(), before) << "no node is left behind";
        return false;
    };
    const auto times = [&](const Rational& c, Graph::Node n) {
        return graph.multiply({graph.rational(c), n});
    };
    EXPECT_TRUE(is_factored({square, graph.rational(-1)}));
    EXPECT_TRUE(is_factored({times(Rational(-9) / 4, square), graph.multiply({square, graph.power(b, -4)})}));
    EXPECT_FALSE(is_factored({square, graph.rational(1)}));
    EXPECT_FALSE(is_factored({times(-1, square), graph.rational(-1)}));
    EXPECT_FALSE(is_factored({times(2, square), graph.rational(-1)}));
    EXPECT_FALSE(is_factored({square, graph.negate(b)}));
    EXPECT_FALSE(is_factored({square, graph.negate(graph.multiply({square, b}))}));
    EXPECT_FALSE(is_factored({square, graph.negate(graph.power(b, 2)), b}));
    EXPECT_FALSE(is_factored({b}));
}

TEST(LostDigits, ConstantsOfARadicandMeetFirst) {
    Graph graph;
    const Graph::Node a = graph.symbol("a"), T = graph.symbol("T"), s = graph.symbol("s");
    const Graph::Node moved = graph.add({T, s});
    EXPECT_EQ(multiplied_out(graph, graph.add({a, graph.negate(moved)})),
              graph.add({a, graph.negate(T), graph.negate(s)}));
    const Graph::Node product = graph.add({a, graph.multiply({T, moved})});
    EXPECT_EQ(multiplied_out(graph, product), product) << "only multiples";
    const Graph::Node moves = graph.add({graph.power(T, 2), graph.power(s, 2)});
    const Graph::Node shared = graph.add({a, graph.negate(moves)});
    EXPECT_EQ(multiplied_out(graph, shared), shared) << "no constant is in it";
    const Graph::Node whole = graph.difference(graph.add({T, graph.negate(s)}));
    const Graph::Node kept = graph.add({a, graph.negate(whole)});
    EXPECT_EQ(multiplied_out(graph, kept), kept) << "it is to stay one term";
}

// A difference of numbers that are doubles is exact as it is.
TEST(LostDigits, DifferencesOfDoublesAreTakenAsTheyAre) {
    Graph graph;
    const Graph::Node a = graph.symbol("a"), b = graph.symbol("b");
    const auto op_of = [&](const Graph::Node other) {
        return graph.at(graph.difference(graph.add({a, graph.negate(other)}))).op;
    };
    EXPECT_EQ(op_of(b), Graph::Op::add);
    EXPECT_EQ(op_of(graph.rational(Rational(3) / 8)), Graph::Op::add);
    EXPECT_EQ(op_of(graph.rational(Rational(1) / 3)), Graph::Op::doubled);
    EXPECT_EQ(op_of(graph.multiply({graph.rational(3), b})), Graph::Op::doubled);
    EXPECT_EQ(op_of(graph.root(b, 2)), Graph::Op::doubled);
    EXPECT_EQ(op_of(graph.callable("f", 0, b)), Graph::Op::add)
        << "no callable has more digits than its type";
    EXPECT_EQ(graph.difference(a), a);
    const Graph::Node c = graph.symbol("c"), whole = graph.difference(graph.add({a, graph.negate(b)}));
    EXPECT_EQ(graph.at(graph.add({c, whole})).operands.size(), 2U) << "one term of a sum";
}

TEST(LostDigits, NothingIsToldOfARounding) {
    const auto program = made([](Graph& graph, Graph::Node a, Graph::Node b) {
        return graph.multiply({graph.function(Graph::Op::exp, {a}), per(graph, graph.add({a, b}))});
    });
    for (const double a : {1e-8, 0.3, 2.0}) EXPECT_FALSE(lost(program, a, 1)) << a;
}

TEST(LostDigits, SlopesAreThoseOfTheFunctions) {
    using Op = Graph::Op;
    for (const Op op : {Op::sin, Op::cos, Op::log, Op::log1p, Op::exp, Op::expm1, Op::asinh, Op::sinh,
                        Op::erf, Op::atan2, Op::sqrt_sum_squares, Op::root, Op::power, Op::multiply}) {
        const auto value_of = [&](const Wide& a, const Wide& b, std::vector<Wide>& nodes, Graph::Node& root) {
            const auto program = made([&](Graph& graph, Graph::Node x, Graph::Node y) {
                if (op == Op::root) return graph.root(x, 4);
                if (op == Op::power) return graph.multiply({graph.power(x, -3), graph.power(y, 5)});
                if (op == Op::multiply) return graph.multiply({graph.rational(3), x, graph.power(x, 2), y});
                if (op == Op::atan2 || op == Op::sqrt_sum_squares) return graph.function(op, {x, y});
                return graph.function(op, {x});
            });
            Interpreter<Wide>(program, Wide(1) / 10, {a, b}, {}, Wide(1)).trace(Wide(0), nodes);
            root = program->outputs.front().value;
            return std::pair(program, nodes.at(static_cast<std::size_t>(root)));
        };
        const Wide a = Wide(7) / 10, b = Wide(13) / 10, step = ldexp(Wide(1), -60);
        std::vector<Wide> nodes, beside;
        Graph::Node root = -1;
        const auto [program, value] = value_of(a, b, nodes, root);
        const std::vector<Wide> slopes = slopes_of_output(program->graph, root, nodes);
        const std::vector<ProgramInput>& inputs = program->parameters;
        const auto slope = [&](std::size_t k) { return slopes[static_cast<std::size_t>(inputs[k].symbol)]; };
        const Wide along_a = (value_of(a + step, b, beside, root).second - value) / step;
        const Wide along_b = (value_of(a, b + step, beside, root).second - value) / step;
        EXPECT_LT(abs(Wide(slope(0) - along_a)), Wide(1e-15)) << static_cast<int>(op);
        EXPECT_LT(abs(Wide(slope(1) - along_b)), Wide(1e-15)) << static_cast<int>(op);
    }
}

TEST(LostDigits, PartsAreSpelledAsAReaderWould) {
    const auto spells = [&](const auto& output) {
        const auto program = made(output);
        return spelled(*program, program->outputs.front().value);
    };
    EXPECT_EQ(spells([](Graph& g, Graph::Node a, Graph::Node b) {
                  return g.add({g.multiply({g.rational(Rational(-3) / 2), a, per(g, b)}), g.power(b, 2)});
              }),
              "b^2 - 3/2*a/b");
    EXPECT_EQ(spells([](Graph& g, Graph::Node a, Graph::Node b) {
                  return per(g, g.multiply({g.root(a, 3), g.add({a, b})}));
              }),
              "a^(2/3)/(a*(a + b))");
    EXPECT_EQ(
        spells([](Graph& g, Graph::Node a, Graph::Node) {
            return g.function(Graph::Op::cos, {g.add({g.symbol("flow tau"), g.symbol("cos theta"), a})});
        }),
        "cos(a + tau + cos(theta))");
    const std::string deep = spells([](Graph& g, Graph::Node a, Graph::Node b) {
        for (int k = 0; k < 60; ++k) a = g.add({g.function(Graph::Op::sin, {a}), g.multiply({a, b})});
        return a;
    });
    EXPECT_NE(deep.find("..."), std::string::npos);
    EXPECT_LE(deep.size(), 84U);
}

} // namespace resonform
