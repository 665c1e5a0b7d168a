// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose solutions are slow flows: their ladders, liars among them, and what evaluators answer.
#include "emit/program/build_program.hpp"
#include "model/files/read_scene.hpp"
#include "model/files/read_system.hpp"
#include "scene_line.hpp"
#include "support/error_when.hpp"
#include "support/system_text.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

test::SceneLine shortened(const std::string& system, const std::string& scene) {
    Scene read = test::scene_of(system, scene);
    read.verify.eps.clear();
    for (const int inverse : {20, 50, 100, 200}) read.verify.eps.push_back(Rational(1) / Rational(inverse));
    read.verify.eps_given = true;
    return test::line_of(std::move(read));
}

void expect_passes(const Verification& v, int order) {
    for (const OutputVerdict& o : v.outputs) {
        EXPECT_EQ(o.verdict, Verdict::pass) << v.system << " " << o.name << ": " << o.reason;
        EXPECT_EQ(o.found_order, order) << v.system << " " << o.name;
    }
    EXPECT_EQ(v.emitted.verdict, Verdict::pass) << to_text(v.emitted);
}

TEST(SlowFlowLadder, EveryKindOfFlowHasItsOrder) {
    expect_passes(test::verified(shortened("henon_heiles", "third_order")), 4);
    expect_passes(test::verified(shortened("spring_pendulum", "exchange")), 3);
    expect_passes(test::verified(shortened("van_der_pol", "to_the_cycle")), 3);
    expect_passes(test::verified(shortened("rotating_pendulum", "fast_rotation")), 3);
}

// One weight less in the normal form costs the order that the count promises.
TEST(SlowFlowLadder, ThePlainTruncationLosesAnOrder) {
    test::SceneLine line = shortened("spring_pendulum", "exchange");
    line.scene.time_scale.reset();
    line.scene.truncation = 2;
    const Verification v = test::verified(test::line_of(line.scene));
    for (const OutputVerdict& o : v.outputs) {
        EXPECT_EQ(o.verdict, Verdict::fail) << o.name;
        EXPECT_EQ(o.found_order, 2) << o.name;
    }
}

TEST(SlowFlowLadder, AWrongSignInTheFlowIsFound) {
    test::SceneLine line = shortened("henon_heiles", "third_order");
    SlowFlow wrong = *line.solution.flow;
    wrong.modes[1].rate.set(3, -wrong.modes[1].rate.part(3));
    line.solution.flow = std::make_shared<const SlowFlow>(wrong);
    for (const OutputVerdict& o : test::verified(line).outputs) EXPECT_EQ(o.verdict, Verdict::fail) << o.name;
}

Scene scene_text(const std::string& folder, const std::string& text) {
    const std::filesystem::path systems = test::source_dir() / "systems";
    return read_scene_text(text, systems / folder / "scenes" / "test.toml", systems);
}

std::vector<double> values(const Scene& scene, double eps, double t) {
    const Interpreter<double> evaluator(test::program_of(scene), eps, {}, {}, 2);
    std::vector<double> result;
    EXPECT_EQ(evaluator.call(t, result), Status::ok);
    return result;
}

// From constants to the state at t = 0, and from there through the inverse map: the same motion.
TEST(FlowStart, ConstantsAndPhysicalValuesAgree) {
    const std::string head = "order = 4\noutputs = [\"x\", \"y\"]\n[fix]\nw1 = 1\ns = 1\na = 1\n[start]\n";
    const Scene constants = scene_text("spring_pendulum", head + "\"amplitude.x\" = 0.7\n\"phase.x\" = 0.3\n"
                                                                 "\"amplitude.y\" = 0.5\n\"phase.y\" = 2\n");
    const double eps = 1.0 / 64;
    const Interpreter<double> motion(test::program_of(constants, {true, true}), eps, {}, {}, 2);
    std::vector<double> start;
    ASSERT_EQ(motion.state(0.0, start), Status::ok);
    Scene physical = scene_text("spring_pendulum", head + "x = 0\n\"x'\" = 0\ny = 0\n\"y'\" = 0\n");
    const std::vector<double> expected = values(constants, eps, 40);
    const Interpreter<double> again(test::program_of(physical), eps, {}, start, 2);
    std::vector<double> found;
    ASSERT_EQ(again.call(40, found), Status::ok);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(found[k], expected[k], 4 * std::pow(eps, 5)) << k; // M = 5: eps^6 over 1/eps
}

TEST(FlowStart, KindsAreNotMixed) {
    const Scene mixed =
        scene_text("spring_pendulum", "order = 2\noutputs = [\"x\"]\n[fix]\nw1 = 1\ns = 1\na = 1\n[start]\n"
                                      "x = \"eps\"\n\"x'\" = 0\n\"amplitude.y\" = 1\n\"phase.y\" = 0\n");
    const Error e = test::error_when([&] { test::program_of(mixed); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().value, "x from its value, y from its amplitude and phase");
    EXPECT_EQ(e.diagnostic().hint, "give y and its derivatives under [start]");
}

TEST(FlowStart, AMomentumHasNoAmplitude) {
    const Scene scene = scene_text(
        "henon_heiles", "order = 2\n[start]\n\"amplitude.x\" = 1\n\"phase.x\" = 0\n\"amplitude.y\" = 1\n"
                        "\"phase.y\" = 0\n\"amplitude.px\" = 1\n\"phase.px\" = 0\n\"amplitude.py\" = 1\n"
                        "\"phase.py\" = 0\n");
    const Error e = test::error_when([&] { test::program_of(scene); });
    EXPECT_EQ(e.diagnostic().value, "px");
    EXPECT_EQ(e.diagnostic().hint, "give physical values of all fast variables");
}

// Without its oscillation a program of amplitudes at rest has neither a flow nor phases.
TEST(FlowProgram, LeavesOutWhatASceneDoesNotNeed) {
    const std::string head =
        "order = 2\noscillating = false\noutputs = [\"x\"]\n[fix]\nw1 = 1\ns = 1\na = 1\n";
    const std::string start =
        "[start]\n\"amplitude.x\" = 1\n\"phase.x\" = 0\n\"amplitude.y\" = 1\n\"phase.y\" = 0\n";
    const auto mean = test::program_of(scene_text("spring_pendulum", head + start));
    EXPECT_TRUE(mean->phases.empty());
    EXPECT_TRUE(mean->flow.empty()); // the mean of x is zero through this order
    const auto chain = test::program_of(test::scene_of("three_oscillators_chain", "third_order"));
    EXPECT_TRUE(chain->flow.empty()); // no resonance
    EXPECT_EQ(chain->phases.size(), 3U);
    const auto exchange = test::program_of(test::scene_of("spring_pendulum", "exchange"));
    EXPECT_EQ(exchange->flow.size(), 4U);
}

// z(t) = eps omega (C2 C3 - C1 C4) t: a product, and nothing that is tabulated.
TEST(FlowProgram, TheParticleRisesWithoutAnIntegrator) {
    Scene scene;
    scene.system = std::make_shared<const System>(read_system_text(test::particle, "particle.toml"));
    scene.time_scale = 1;
    scene.outputs = {"x", "z"};
    scene.fix["omega"] = 2;
    scene.verify.interval = 1 / scene.system->eps;
    const auto give = [&](const std::string& name, const GiNaC::ex& value) {
        scene.start.push_back({name, value, "", {}});
    };
    give("x", 3);      // C1
    give("x'", 2 * 5); // omega C2
    give("y", -1);     // C3
    give("y'", 2 * 7); // omega C4
    give("z", 4);
    const auto program = test::program_of(scene);
    EXPECT_TRUE(program->flow.empty());
    EXPECT_TRUE(program->tables.empty());
    EXPECT_EQ(program->phases.size(), 1U);
    const double eps = 0.01, t = 60, omega = 2;
    const Interpreter<double> evaluator(program, eps, {}, {}, 1);
    std::vector<double> found;
    ASSERT_EQ(evaluator.call(t, found), Status::ok);
    EXPECT_NEAR(found[0], 3 * std::cos(omega * t) + 5 * std::sin(omega * t), 1e-13);
    EXPECT_NEAR(found[1], 4 + eps * omega * (5 * -1 - 3 * 7) * t, 1e-13);
}

const char* const slow_growth = R"toml(
[system]
name = "slow_growth"
[variables]
x = { role = "fast" }
[equations]
x = "x'' - eps^2*x' + x^2*x' + x + x^3 = 0"
)toml";

// One oscillator whose amplitude moves as eps^2 t, up to t = 1/eps^2: no quadrature in eps t, a slow flow.
TEST(SlowFlowLadder, OneOscillatorOnLongTimes) {
    Scene scene;
    scene.name = "long_time";
    scene.system = std::make_shared<const System>(read_system_text(slow_growth, "slow_growth.toml"));
    scene.order = 2;
    scene.time_scale = 2;
    scene.outputs = {"x"};
    scene.verify.interval = GiNaC::pow(scene.system->eps, -2);
    scene.start.push_back({"x", scene.system->eps, "", {}});
    scene.start.push_back({"x'", 0, "", {}});
    for (const int inverse : {10, 20, 30, 40}) scene.verify.eps.push_back(Rational(1) / Rational(inverse));
    scene.verify.eps_given = true;
    const test::SceneLine line = test::line_of(scene);
    ASSERT_TRUE(line.solution.flow);
    expect_passes(test::verified(line), 3);
}

// Without a bound: the amplitude grows without limit in finite slow time; beyond it there is no answer.
TEST(FlowProgram, AnswersUpToWhereTheFlowEnds) {
    const Scene scene =
        scene_text("van_der_pol", "order = 1\n[start]\n\"amplitude.x\" = 1\n\"phase.x\" = 0\n");
    const Solution solution = test::solution_of(scene);
    SlowFlow explosive = *solution.flow;
    explosive.modes[0].rate.set(1, -explosive.modes[0].rate.part(1)); // a' = -eps a/2 (1 - |a|^2/4)
    Solution changed = solution;
    changed.flow = std::make_shared<const SlowFlow>(explosive);
    const auto program = std::make_shared<const Program>(build_program(changed, scene));
    const Interpreter<double> evaluator(program, 0.01, {}, {3.0, 0.0}, 10);
    std::vector<double> result;
    EXPECT_EQ(evaluator.call(1, result), Status::ok);
    EXPECT_NE(evaluator.call(900, result), Status::ok);
    EXPECT_EQ(evaluator.construction_status(), Status::ok);
}

} // namespace
} // namespace resonform
