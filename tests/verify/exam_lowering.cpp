// SPDX-License-Identifier: GPL-3.0-or-later
// How large the program of a large map is: a field line of a tokamak, two angles with harmonics of
// both.
#include "emit/program/build_program.hpp"
#include "model/files/read_system.hpp"
#include "support/program.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <gtest/gtest.h>

#include <cstddef>

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

std::size_t terms_of_map(const Solution& solution) {
    const NearIdentityMap& map = solution.normalization->map;
    std::size_t count = 0;
    for (const auto* of : {&map.mode, &map.angle, &map.slow, &map.drift})
        for (const Series& series : *of) count += series.total(series.through()).size();
    return count;
}

// M = 5: a map of 45 000 terms, lowered at each of six substitutions: written out there, it took minutes.
class LoweringOf : public testing::TestWithParam<int> {};

TEST_P(LoweringOf, HasNodesAsTheMapHasTerms) {
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
    const Solution solution = test::solution_of(scene);
    const auto program = std::make_shared<const Program>(build_program(solution, scene));
    EXPECT_LT(program->graph.size(), 6 * terms_of_map(solution));
    // psi at t = 50 by direct integration (Runge-Kutta, h = 0.005)
    const Interpreter<double> evaluator(program, 0.001, {}, {}, 1);
    std::vector<double> found;
    ASSERT_EQ(evaluator.call(50, found), Status::ok);
    EXPECT_NEAR(found[0], 1.3703228782274248, 5e-9);
}

INSTANTIATE_TEST_SUITE_P(Slow, LoweringOf, testing::Values(4, 5));

} // namespace
} // namespace resonform
