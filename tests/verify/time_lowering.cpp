// SPDX-License-Identifier: GPL-3.0-or-later
// How long the way from a solution to its program is: a field line of a tokamak, two angles with harmonics of
// both.
#include "emit/program/build_program.hpp"
#include "model/files/read_system.hpp"
#include "support/program.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

namespace resonform {
namespace {

const char* const field_line = R"toml(
[system]
name = "field_line"
[parameters]
a = {}
b = {}
[variables]
psi = { role = "slow", positive = true }
theta = { role = "angle" }
phi = { role = "angle" }
[equations]
psi = "psi' = eps*(2*a*sin(2*theta - phi) + 3*b*sin(3*theta - 2*phi))"
theta = "theta' = psi + eps*(a*cos(2*theta - phi) + b*cos(3*theta - 2*phi))"
phi = "phi' = 1"
)toml";

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; } // of this program alone

// M = 5: a map of 45 000 terms, lowered at each of six substitutions.
class LoweringOf : public testing::TestWithParam<int> {};

TEST_P(LoweringOf, TakesNoLongerThanTheDerivation) {
    Scene scene;
    scene.system = std::make_shared<const System>(read_system_text(field_line, "field_line.toml"));
    scene.order = 2;
    scene.truncation = GetParam();
    scene.outputs = {"psi"};
    scene.fix["a"] = 1;
    scene.fix["b"] = GiNaC::numeric(1, 2);
    scene.verify.interval = 1 / scene.system->eps;
    const auto give = [&](const std::string& name, const GiNaC::ex& value) {
        scene.start.push_back({name, value, "", {}});
    };
    give("psi", GiNaC::numeric(137, 100));
    give("theta", GiNaC::numeric(1, 10));
    give("phi", 0);
    const double begin = seconds();
    const Solution solution = test::solution_of(scene);
    const double derived = seconds();
    const auto program = std::make_shared<const Program>(build_program(solution, scene));
    EXPECT_LE(seconds() - derived, std::max(5.0, derived - begin));
    // psi at t = 50 by direct integration (Runge-Kutta, h = 0.005)
    const Interpreter<double> evaluator(program, 0.001, {}, {}, 1);
    std::vector<double> found;
    ASSERT_EQ(evaluator.call(50, found), Status::ok);
    EXPECT_NEAR(found[0], 1.3703228782274248, 5e-9);
}

INSTANTIATE_TEST_SUITE_P(Slow, LoweringOf, testing::Values(4, 5));

} // namespace
} // namespace resonform
