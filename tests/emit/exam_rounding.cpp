// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding constants step by step costs the outputs, and powers whose errors cancel.
#include "emit/cpp/rounding.hpp"
#include "emit/program/straight_line.hpp"

#include <gtest/gtest.h>

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
    double rounding_of(Graph::Node output) const {
        StraightLine code(program);
        return rounding_of_constants(program, code, {code.lower(output)});
    }
};

TEST(RoundingOfConstants, CountsByTheShareOfItsTerm) {
    Formulas f;
    const Graph::Node a = f.start("a"), b = f.start("b"), d = f.start("d"), y = f.start("y");
    const Graph::Node product = f.graph.multiply({a, b, d, f.T});
    EXPECT_DOUBLE_EQ(f.rounding_of(product), 1); // two steps, of which one would be left
    const double size = 0.75 * 0.75 * 0.75 * 0.75;
    EXPECT_NEAR(f.rounding_of(f.graph.add({product, f.graph.multiply({f.T, f.T, y})})),
                size / (size + 0.75 * 0.75 * 0.75), 1e-12);
    EXPECT_EQ(f.rounding_of(f.graph.multiply({a, f.T})), 0);
    EXPECT_EQ(f.rounding_of(f.graph.power(f.T, 9)), 0); // no constant
}

// x0 + 8 x0^7: what the power loses does not matter where x0 is of order eps.
TEST(RoundingOfConstants, LooksAtStartsOfTheSizeOfTheirDefaults) {
    for (const bool is_small : {false, true}) {
        Formulas f;
        const Graph::Node x = f.start("x", is_small ? f.eps : f.graph.rational(1));
        const Graph::Node sum =
            f.graph.add({x, f.graph.multiply({f.graph.rational(8), f.graph.power(x, 7)})});
        const double found = f.rounding_of(f.graph.multiply({sum, f.T}));
        if (is_small)
            EXPECT_LT(found, 0.01);
        else
            EXPECT_GT(found, 3);
    }
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
