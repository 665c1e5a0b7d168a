// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas as text that a loop walks, against the formulas.
#include "algebra/number/binary_parts.hpp"
#include "emit/cpp/walk.hpp"
#include "runtime/twice.hpp"
#include "runtime/walk.hpp"

#include <cln/float.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace resonform {
namespace {

using Value = StraightLine::Value;
using Op = Graph::Op;

struct Formula {
    Program program;
    std::vector<Graph::Node> symbols;

    Formula() {
        program.time = program.graph.symbol("t");
        program.slow_time = program.graph.symbol("T");
    }
    Graph::Node symbol(const std::string& name) {
        symbols.push_back(program.graph.symbol(name));
        return symbols.back();
    }
};

constexpr std::size_t most_places = 20000, most_numbers = 20000;

std::vector<Ratio> ratios_of(const CppWalk& walk) {
    const std::string none = "##$"; // 0, for those that are not there
    std::string list = walk.numbers;
    for (std::size_t k = walk.count; k < most_numbers; ++k) list += none;
    const auto all = ratios<most_numbers>(list.c_str());
    return {all.begin(), all.end()};
}

// The roots, where the symbols are `numbers`.
template <int Digits>
std::vector<double> walked(const CppWalk& walk, const std::vector<double>& inputs,
                           const std::vector<Value>& roots) {
    std::vector<double> places(most_places);
    const std::vector<Ratio> numbers = ratios_of(walk);
    for (std::size_t k = 0; k < inputs.size(); ++k) places[walk.inputs[k].second] = inputs[k];
    for (const std::string& text : walk.texts) {
        EXPECT_LT(text.size(), 65536U);
        Walk<Digits, 0x7ff, double>(places.data(), numbers.data(), text.c_str()).run();
    }
    std::vector<double> result(roots.size());
    Walk<Digits, 0, double>(places.data(), nullptr, walk.list(roots).c_str()).copy_to(result);
    return result;
}

std::vector<double> walked(const Formula& f, const std::vector<Graph::Node>& wanted,
                           const std::vector<double>& numbers, int digits = 2) {
    StraightLine code(f.program);
    std::set<Value> known;
    std::vector<Value> roots;
    std::map<Value, double> given;
    for (std::size_t k = 0; k < f.symbols.size(); ++k) given[code.lower(f.symbols[k])] = numbers[k];
    for (const auto& [v, number] : given) known.insert(v);
    for (const Graph::Node n : wanted) roots.push_back(code.lower(n));
    const auto walk = cpp_walk(code, code.behind(roots, true), known, roots);
    if (!walk) return {};
    EXPECT_EQ(walk->digits, digits);
    EXPECT_LT(walk->places, most_places);
    std::vector<double> inputs;
    for (const auto& [v, place] : walk->inputs)
        inputs.push_back(given.contains(v) ? given.at(v) : cln::double_approx(code.at(v).number));
    return walk->digits == 2 ? walked<2>(*walk, inputs, roots) : walked<3>(*walk, inputs, roots);
}

TEST(Walk, EveryKindOfOperation) {
    Formula f;
    Graph& g = f.program.graph;
    const Graph::Node x = f.symbol("x"), y = f.symbol("y");
    const Rational third = Rational(1) / 3, large = Rational(Integer("12345678901234567890123")) / 7;
    const std::vector<Graph::Node> roots{g.add({x, g.negate(y), g.rational(third)}),
                                         g.add({g.negate(x), g.negate(y)}),
                                         g.multiply({g.rational(-third), x, y}),
                                         g.add({g.multiply({g.rational(large), x}), y}),
                                         g.power(g.add({x, y}), -3),
                                         g.root(x, 2),
                                         g.root(x, 3),
                                         g.function(Op::sin, {x}),
                                         g.function(Op::cos, {x}),
                                         g.function(Op::log, {x}),
                                         g.function(Op::exp, {x}),
                                         g.function(Op::log1p, {x}),
                                         g.function(Op::expm1, {x}),
                                         g.function(Op::asinh, {x}),
                                         g.function(Op::sinh, {x}),
                                         g.function(Op::erf, {x}),
                                         g.function(Op::atan2, {x, y}),
                                         g.function(Op::sqrt_sum_squares, {x, y}),
                                         g.rational(third),
                                         x};
    const double a = 1.25, b = -0.75;
    const std::vector<double> expected{a - b + 1.0 / 3,
                                       -a - b,
                                       -a * b / 3,
                                       12345678901234567890123.0 / 7 * a + b,
                                       1 / ((a + b) * (a + b) * (a + b)),
                                       std::sqrt(a),
                                       std::cbrt(a),
                                       std::sin(a),
                                       std::cos(a),
                                       std::log(a),
                                       std::exp(a),
                                       std::log1p(a),
                                       std::expm1(a),
                                       std::asinh(a),
                                       std::sinh(a),
                                       std::erf(a),
                                       std::atan2(a, b),
                                       std::hypot(a, b),
                                       1.0 / 3,
                                       a};
    const std::vector<double> found = walked(f, roots, {a, b});
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_NEAR(found[k], expected[k], 1e-15 * std::abs(expected[k])) << k;
}

template <class Real> Real walked_number(const Rational& value) {
    Formula f;
    StraightLine code(f.program);
    const std::vector<Value> roots{code.number(value)};
    const auto walk = cpp_walk(code, code.behind(roots, true), {}, roots);
    EXPECT_TRUE(walk && walk->inputs.empty());
    std::array<Real, 4> places{};
    std::array<Real, 1> result{};
    Walk<2, 0, Real>(places.data(), nullptr, walk->texts.at(0).c_str()).run();
    Walk<2, 0, Real>(places.data(), nullptr, walk->list(roots).c_str()).copy_to(result);
    return result[0];
}

// Exactly, for a Twice<Real> as well.
Rational exact(double x) { return cln::rational(cln::cl_float(x)); }
Rational exact(const Twice<double>& x) { return exact(x.high) + exact(x.low); }

// Numbers whose parts have many digits: the double next to them, and all the digits of wider types.
TEST(Walk, LongNumbers) {
    std::mt19937_64 random(3);
    std::vector<Rational> numbers;
    for (int k = 0; k < 300; ++k) {
        Integer n = 1, d = 1;
        for (int j = 0; j < 1 + k % 4; ++j) {
            n = n * (Integer(1) << 60) + static_cast<unsigned long>(random() >> 4);
            d = d * (Integer(1) << 50) + static_cast<unsigned long>(random() >> 14);
        }
        numbers.push_back(Rational(k % 2 == 0 ? n : Integer(-n)) / d);
    }
    const Integer large = (Integer(1) << 90);
    for (const int sign : {-1, 0, 1}) { // about powers of two, and halfway between doubles
        numbers.push_back(Rational(large + sign));
        numbers.push_back(Rational(1) / (large + sign * 3));
        numbers.push_back(Rational((Integer(1) << 54) + 2) + Rational(sign) / large);
    }
    numbers.push_back(Rational(large) / 3 * cln::expt_pos(Integer(10), 200));
    numbers.push_back(Rational(1) / (3 * cln::expt_pos(Integer(10), 200)));
    for (const Rational& value : numbers) {
        EXPECT_EQ(walked_number<double>(value),
                  binary_parts(value, 1).parts[0] * std::ldexp(1.0, binary_parts(value, 1).exponent));
        const Rational rest = cln::abs(exact(walked_number<Twice<double>>(value)) - value);
        EXPECT_LE(rest * (Integer(1) << 104), cln::abs(value));
    }
}

// More operands than a digit can tell, more places than two digits can tell.
TEST(Walk, LongSumsAndProductsAndManyPlaces) {
    Formula f;
    Graph& g = f.program.graph;
    std::vector<Graph::Node> terms, factors, roots;
    std::vector<double> numbers;
    double sum = 0, product = 1;
    for (int k = 0; k < 200; ++k) {
        const Graph::Node x = f.symbol("x" + std::to_string(k));
        numbers.push_back(1 + 1 / (k + 2.0));
        terms.push_back(k % 3 == 0 ? g.negate(x) : x);
        factors.push_back(x);
        sum += k % 3 == 0 ? -numbers.back() : numbers.back();
        product *= numbers.back();
    }
    terms.push_back(g.rational(7));
    factors.push_back(g.rational(Rational(3) / 16));
    roots = {g.add(terms), g.multiply(factors)};
    std::vector<double> found = walked(f, roots, numbers);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0], sum + 7, 1e-12);
    EXPECT_NEAR(found[1], product * 3 / 16, 1e-12 * product);

    roots.clear();
    for (int k = 0; k < 9000; ++k)
        roots.push_back(
            g.add({g.multiply({g.rational(k + 2), factors[0]}), g.rational(Rational(1) / (k + 2))}));
    found = walked(f, roots, numbers, 3);
    ASSERT_EQ(found.size(), 9000U) << "text of several pieces";
    for (std::size_t k = 0; k < found.size(); k += 100)
        EXPECT_NEAR(found[k], (static_cast<double>(k) + 2) * numbers[0] + 1 / (static_cast<double>(k) + 2),
                    1e-11);
}

// Its texts go no further; what others use of them, too, keeps its place.
TEST(Walk, SomeRootsComeFirst) {
    Formula f;
    Graph& g = f.program.graph;
    const Graph::Node x = f.symbol("x"), y = f.symbol("y");
    const Graph::Node both = g.add({x, g.rational(2)});
    const Graph::Node late = g.multiply({g.function(Op::sin, {both}), y});
    const Graph::Node early = g.add({g.function(Op::cos, {both}), x});
    StraightLine code(f.program);
    const std::vector<Value> roots{code.lower(late), code.lower(early)};
    const std::vector<Value> inputs{code.lower(x), code.lower(y)};
    const auto walk =
        cpp_walk(code, code.behind(roots, true), {inputs.begin(), inputs.end()}, roots, {roots[1]});
    ASSERT_TRUE(walk);
    ASSERT_EQ(walk->first_texts, 1U);
    ASSERT_EQ(walk->texts.size(), 2U);
    std::array<double, 20> places{};
    for (const auto& [v, place] : walk->inputs) places[place] = v == inputs[0] ? 0.25 : 3;
    const std::vector<Ratio> numbers = ratios_of(*walk);
    Walk<2, 0x7ff, double>(places.data(), numbers.data(), walk->texts[0].c_str()).run();
    EXPECT_NEAR(places[walk->place_of.at(roots[1])], std::cos(2.25) + 0.25, 1e-15);
    Walk<2, 0x7ff, double>(places.data(), numbers.data(), walk->texts[1].c_str()).run();
    EXPECT_NEAR(places[walk->place_of.at(roots[0])], 3 * std::sin(2.25), 1e-15);
    EXPECT_NEAR(places[walk->place_of.at(roots[1])], std::cos(2.25) + 0.25, 1e-15);

    const std::set<Value> known{inputs.begin(), inputs.end()};
    EXPECT_EQ(cpp_walk(code, code.behind(roots, true), known, roots, roots)->first_texts, 1U) << "all";
    const std::vector<Value> with_input{roots[1], inputs[1]};
    const auto input_first = cpp_walk(code, code.behind(with_input, true), known, with_input, {inputs[1]});
    EXPECT_EQ(input_first->first_texts, 0U) << "known without a step";
}

// Places that nothing needs any more are used again.
TEST(Walk, PlacesAreUsedAgain) {
    Formula f;
    Graph& g = f.program.graph;
    const Graph::Node x = f.symbol("x");
    Graph::Node y = x;
    double expected = 0.5;
    for (int k = 0; k < 100; ++k) {
        y = g.function(Op::sin, {g.add({y, g.rational(k + 1)})});
        expected = std::sin(expected + k + 1);
    }
    StraightLine code(f.program);
    const Value root = code.lower(y), start = code.lower(x);
    const auto walk = cpp_walk(code, code.behind({root}, true), {start}, {root});
    ASSERT_TRUE(walk);
    EXPECT_LE(walk->places, 3U);
    EXPECT_NEAR(walked(f, {y}, {0.5}).at(0), expected, 1e-12);
}

TEST(Walk, WhatACallerGivesIsNotWalked) {
    Formula f;
    const Graph::Node x = f.symbol("x");
    EXPECT_TRUE(walked(f, {f.program.graph.callable("omega", 0, x)}, {1}).empty());
}

} // namespace
} // namespace resonform
