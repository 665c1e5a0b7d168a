// SPDX-License-Identifier: GPL-3.0-or-later
// The mass on a stiff spring (systems/stiff_spring) at every rate: ladders where they are strict, and one
// evaluator, whose argument the rate is, against implicit integration at any.
#include "verify/evaluate/interpreter.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/own_system.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace resonform {
namespace {

using Dd = DoubleDouble;

class StiffSpringLadder : public testing::TestWithParam<int> {};

TEST_P(StiffSpringLadder, IsAsAccurateInTheLayerAsBehindIt) {
    Scene scene = test::scene_of("stiff_spring", "stiff");
    scene.fix["K"] = GetParam();
    const Verification v = test::verified(test::line_of(std::move(scene)));
    for (const OutputVerdict& o : v.outputs) {
        EXPECT_EQ(o.verdict, Verdict::pass) << o.name << ": " << o.reason;
        EXPECT_EQ(o.found_order, 2) << o.name;
        EXPECT_FALSE(o.layer.empty()) << o.name;
    }
    EXPECT_TRUE(v.as_expected()) << to_text(v.emitted);
}

INSTANTIATE_TEST_SUITE_P(Slow, StiffSpringLadder, testing::Values(100, 1000));

class StiffSpringAt : public testing::TestWithParam<double> {
protected:
    static std::array<double, 5> times(double k) { return {0.1 / k, 1 / k, 10 / k, 1, 100}; }
    static const std::shared_ptr<const Program>& program() {
        static const auto made =
            test::program_of(test::scene_of("stiff_spring", "stiff"), {false, true, false, {}});
        return made;
    }
    // x, x', y, y'/K of the formula with K for an argument.
    static std::vector<double> formula(double k, double eps, double t) {
        const Interpreter<double> evaluator(program(), eps, {k}, {}, 200 * eps);
        std::vector<double> state;
        EXPECT_EQ(evaluator.state(t, state), Status::ok) << t;
        state.at(3) /= k;
        return state;
    }
};

// An error of the order of eps within the layer would be 10 and 20 times as large as these bounds.
TEST_P(StiffSpringAt, IsWhereImplicitIntegrationIs) {
    const double k = GetParam();
    const FirstOrderSystem system = solve_for_highest(test::scene_of("stiff_spring", "stiff").system);
    for (const double eps : {0.01, 0.005}) {
        std::vector<Dd> at;
        for (const double t : times(k)) at.emplace_back(t);
        const auto exact = integrate_implicit<Dd>(Tape::rates(system), {Dd(k)}, Dd(eps),
                                                  {Dd(1), Dd(0), Dd(1), Dd(0)}, at, 1e-25);
        ASSERT_EQ(exact.failure, "");
        for (std::size_t i = 0; i < at.size(); ++i) {
            const std::vector<double> found = formula(k, eps, times(k)[i]);
            for (std::size_t state = 0; state < 4; ++state)
                EXPECT_NEAR(found.at(state), to_double_value(exact.values[state][i]) / (state == 3 ? k : 1),
                            eps * eps)
                    << "state " << state << " at t = " << times(k)[i] << ", eps = " << eps;
        }
    }
}

// The same operations with 33 digits.
TEST_P(StiffSpringAt, IsExactToTheLastPlaces) {
    const double k = GetParam(), eps = 0.01;
    const Interpreter<double> in_double(program(), eps, {k}, {}, 2);
    const Interpreter<Float128> exact(program(), Float128(eps), {Float128(k)}, {}, 2);
    for (const double t : times(k)) {
        std::vector<double> found;
        std::vector<Float128> expected, scale;
        ASSERT_EQ(in_double.call(t, found), Status::ok) << t;
        ASSERT_EQ(exact.call(t, expected), Status::ok) << t;
        ASSERT_EQ(exact.scale(t, scale), Status::ok) << t;
        for (std::size_t o = 0; o < found.size(); ++o)
            EXPECT_LT(std::abs(static_cast<double>((Float128(found[o]) - expected[o]) / scale[o])),
                      16 * 2.3e-16)
                << program()->outputs[o].name << " at t = " << t;
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, StiffSpringAt, testing::Values(10, 1e3, 1e5, 1e8));

} // namespace
} // namespace resonform
