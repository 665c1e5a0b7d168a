// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding constants step by step costs the outputs, and powers whose errors cancel.
#include "emit/cpp/rounding.hpp"
#include "emit/program/straight_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

using Value = StraightLine::Value;

struct Formulas {
    Program program;
    Graph& graph = program.graph;
    Graph::Node T, eps;

    Formulas() {
        program.time = graph.symbol("t");
        program.slow_time = T = graph.symbol("T");
        program.eps = eps = graph.symbol("eps");
    }
    Graph::Node start(const std::string& name, Graph::Node by_default = -1) {
        const Graph::Node symbol = graph.symbol(name);
        program.start.push_back({name, "", symbol, by_default});
        return symbol;
    }
    // Where all that decays is gone: of the second sample.
    RoundingOfOutput rounding_of(Graph::Node output, bool gone = false) const {
        StraightLine code(program);
        const auto found = rounding_of_constants(program, code, {code.lower(output)});
        EXPECT_EQ(found.size(), 2U);
        return found[gone ? 1 : 0];
    }
};

TEST(RoundingOfConstants, CountsByTheShareOfItsTerm) {
    Formulas f;
    const Graph::Node a = f.start("a"), b = f.start("b"), d = f.start("d"), y = f.start("y");
    const Graph::Node product = f.graph.multiply({a, b, d, f.T});
    const RoundingOfOutput alone = f.rounding_of(product); // two steps of a constant, of which one is left
    EXPECT_DOUBLE_EQ(alone.stepwise, std::sqrt(3));
    EXPECT_DOUBLE_EQ(alone.once, std::sqrt(2));
    const double size = 0.75 * 0.75 * 0.75 * 0.75, beside = 0.75 * 0.75 * 0.75;
    const double share = size / (size + beside), rest = 1 - share;
    const RoundingOfOutput sum = f.rounding_of(f.graph.add({product, f.graph.multiply({f.T, f.T, y})}));
    EXPECT_NEAR(sum.stepwise, std::sqrt(1 + 3 * share * share + 2 * rest * rest), 1e-12);
    EXPECT_NEAR(sum.once, std::sqrt(1 + 2 * share * share + 2 * rest * rest), 1e-12);
}

// What is in both factors of a square counts twice, not as two.
TEST(RoundingOfConstants, OfOneValueInTwoPlacesAddUp) {
    Formulas f;
    const Graph::Node a = f.start("a"), b = f.start("b"), d = f.start("d");
    const Graph::Node sum = f.graph.add({f.graph.multiply({a, b}), f.graph.multiply({d, f.T})});
    EXPECT_NEAR(f.rounding_of(f.graph.multiply({sum, sum})).stepwise, std::sqrt(1 + 4 * (1 + 0.25 + 0.25)),
                1e-12);
}

TEST(RoundingOfConstants, LooksAgainWhereWhatDecaysIsGone) {
    Formulas f;
    const Graph::Node a = f.start("a"), b = f.start("b"), d = f.start("d");
    ProgramPhase layer;
    layer.exponential = f.graph.symbol("exp_chi");
    f.program.phases.push_back(layer);
    const Graph::Node chi = f.program.phases.front().exponential;
    const Graph::Node constant = f.graph.multiply({a, a, a, b, d}), decays = f.graph.multiply({a, chi});
    const Graph::Node output = f.graph.add({decays, f.graph.multiply({constant, f.T})});
    EXPECT_LT(f.rounding_of(output).stepwise, f.rounding_of(output, true).stepwise);
    EXPECT_EQ(f.rounding_of(decays, true).stepwise, 0); // nothing is left to be wrong
}

// A table or a variable of a flow is wrong by as much as its integrand is at all nodes, by what that has of
// it.
TEST(RoundingOfConstants, GoesBehindIntegrals) {
    for (const bool flow : {false, true}) {
        Formulas f;
        const Graph::Node a = f.start("a"), b = f.start("b"), d = f.start("d"), begin = f.start("begin");
        const Graph::Node rate = f.graph.multiply({a, b, d, f.T}), Q = f.graph.symbol("Q");
        if (flow)
            f.program.flow.push_back({"Q", begin, rate, Q});
        else
            f.program.tables.push_back({"Q", rate, Q});
        const double size = 0.75 * 0.75 * 0.75 * 0.75, share = flow ? size / (0.75 + size) : 1;
        const RoundingOfOutput found = f.rounding_of(f.graph.multiply({Q, f.T}));
        EXPECT_NEAR(found.stepwise, std::sqrt(1 + 2 * share * share), 1e-12);
        EXPECT_NEAR(found.once, std::sqrt(1 + share * share), 1e-12);
    }
}

// x0 + 8 x0^7: what the power loses does not matter where x0 is of order eps.
TEST(RoundingOfConstants, LooksAtStartsOfTheSizeOfTheirDefaults) {
    for (const bool is_small : {false, true}) {
        Formulas f;
        const Graph::Node x = f.start("x", is_small ? f.eps : f.graph.rational(1));
        const Graph::Node sum =
            f.graph.add({x, f.graph.multiply({f.graph.rational(8), f.graph.power(x, 7)})});
        const RoundingOfOutput found = f.rounding_of(f.graph.multiply({sum, f.T}));
        if (is_small)
            EXPECT_LT(found.stepwise, std::sqrt(2) + 0.01);
        else
            EXPECT_GT(found.stepwise, 2);
    }
}

TEST(RoundingOfConstants, IsMuchOnlyWhereMoreDigitsHelp) {
    EXPECT_TRUE(rounds_much({{1, 1}, {5, 3}}));
    EXPECT_FALSE(rounds_much({{5, 5}, {3, 2}}));
}

TEST(StraightLine, ANegativePowerOfAConstantIsOneOverThatWhichIsThereToo) {
    Formulas f;
    const Graph::Node a = f.start("a");
    const Graph::Node up = f.graph.power(a, 5), down = f.graph.power(a, -5), other = f.graph.power(a, -3);
    const Graph::Node varying = f.graph.power(f.T, -5);
    f.graph.power(f.T, 5);
    StraightLine code(f.program);
    const auto& reciprocal = code.at(code.lower(down));
    EXPECT_EQ(reciprocal.op, StraightLine::Op::reciprocal);
    EXPECT_EQ(reciprocal.operands, std::vector<Value>{code.lower(up)});
    EXPECT_EQ(code.at(code.lower(other)).op, StraightLine::Op::multiply);
    EXPECT_EQ(code.at(code.lower(varying)).op, StraightLine::Op::multiply); // one division at each call
}

} // namespace
} // namespace resonform
