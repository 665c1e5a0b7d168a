// SPDX-License-Identifier: GPL-3.0-or-later
// The exact solution as numbers: its scales, and a second route to its values.
#include "verify/evaluate/interpreter.hpp"
#include "verify/run/cache.hpp"
#include "verify/symbolic/evaluator.hpp"

#include "emit/program/build_program.hpp"
#include "model/files/read_scene.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace resonform {
namespace {

namespace fs = std::filesystem;

SymbolicPoint at_scene(const Scene& scene, const Solution& solution, const Wide& eps,
                       const std::map<std::string, Wide>& start, const Wide& t) {
    const auto symbolic = std::make_shared<const SymbolicSolution>(solution, scene);
    return SymbolicEvaluator(symbolic, {eps, {}, start, 1}, eps * t)(t);
}

// x = eps C (2 + tau^2)^(-1/4) cos theta: the scale is the amplitude, whatever the cosine.
TEST(SymbolicEvaluator, ScaleOfOneTermIsItsAmplitude) {
    Scene scene = test::scene_of("slowly_stiffening_oscillator", "third_order");
    scene.order = 1;
    const Solution solution = test::solution_of(scene);
    for (const double t : {0.0, 3.0, 50.0}) {
        const SymbolicPoint point = at_scene(scene, solution, Wide(0.01),
                                             {{"tau", 0.5}, {"amplitude.x", 2}, {"phase.x", 1}}, Wide(t));
        const Wide tau = Wide(0.5) + Wide(0.01) * Wide(t), amplitude = Wide(0.02) / sqrt(sqrt(2 + tau * tau));
        EXPECT_EQ(point.status, Status::ok);
        EXPECT_LT(abs(Wide(point.scales[0] / amplitude - 1)), Wide(1e-45));
        EXPECT_LE(abs(point.values[0]), point.scales[0]);
        EXPECT_EQ(point.phase_parts[0], 0);
    }
}

// s is driven from 0.24 through zero by an amplitude: known to the last places of what cancels there, not to
// its own. The scale was 0.016, and honest code wrong by 43 ulp of it.
TEST(SymbolicEvaluator, AZeroOfADrivenVariableIsNoScale) {
    const fs::path cache = fs::path(RESONFORM_BINARY_DIR) / "test_cache", system = cache / "driven";
    fs::create_directories(system / "scenes");
    write_atomically(system / "system.toml",
                     "[system]\nname = \"driven\"\n[variables]\nx = { role = \"fast\", weight = 0 }\n"
                     "s = { role = \"slow\" }\n[equations]\n"
                     "x = \"x'' = -3/2*x - eps/8*x' - eps*2/3/(1 + s^2)*x*x'\"\n"
                     "s = \"s' = eps*(7/5) - eps*s*3/4 - eps*5/4*x'^2\"\n");
    write_atomically(system / "scenes/s.toml",
                     "order = 1\ntime_scale = 1\noutputs = [\"x\", \"s\"]\n[start]\nx = 1.43\n\"x'\" = 0\n"
                     "s = 0.24\n");
    const Scene scene = read_scene(system / "scenes/s.toml", cache);
    const Solution solution = test::solution_of(scene);
    const Wide eps(1e-4);
    const std::map<std::string, Wide> start{{"x", 1.43}, {"x'", 0}, {"s", 0.24}};
    const auto symbolic = std::make_shared<const SymbolicSolution>(solution, scene);
    const SymbolicEvaluator at(symbolic, {eps, {}, start, 1}, Wide(1));
    std::size_t passes = 0;
    Wide before = 1;
    for (int k = 0; k <= 100; ++k) {
        const SymbolicPoint point = at(k / (100 * eps));
        ASSERT_EQ(point.status, Status::ok);
        if (point.values[1] * before < 0) ++passes;
        before = point.values[1];
        EXPECT_GT(point.scales[1], Wide(0.23)) << k;
        EXPECT_LT(point.scales[1], Wide(10)) << k;
        EXPECT_LT(point.scales[0], Wide(10)) << k;
    }
    EXPECT_GT(passes, 0U);
}

// Two routes from the solution to the numbers, the graph and the terms.
TEST(SymbolicEvaluator, AgreesWithTheInterpreterInFiftyDigits) {
    const Scene scene = test::scene_of("henon_heiles", "third_order");
    const Solution solution = test::solution_of(scene);
    const Program program = build_program(solution, scene, {true, false, true});
    const std::map<std::string, Wide> start{{"x", 0.001}, {"y", 0.002}, {"px", -0.0015}, {"py", 0.0005}};
    std::vector<Wide> given, values;
    for (const ProgramInput& input : program.start) given.push_back(start.at(input.canonical));
    const Wide eps(0.01), t(70);
    const Interpreter<Wide> interpreter(std::make_shared<const Program>(program), eps, {}, given, Wide(1));
    ASSERT_EQ(interpreter.call(t, values), Status::ok);
    const SymbolicPoint point = at_scene(scene, solution, eps, start, t);
    for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_LT(abs(Wide((values[k] - point.values[k]) / point.scales[k])), Wide(1e-28));
}

} // namespace
} // namespace resonform
