// SPDX-License-Identifier: GPL-3.0-or-later
// Slow flows that can be checked by hand: what rests, what turns, what moves, and on which time scale.
#include "model/files/read_system.hpp"
#include "solve/flow/real_form.hpp"
#include "solve/line.hpp"
#include "solve/systems.hpp"
#include "solve/time_scale.hpp"
#include "solve/truncation.hpp"
#include "support/error_when.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

std::string oscillators(const std::string& equations, const std::string& more = "") {
    return R"(
[system]
name = "two"
[variables]
x = { role = "fast" }
y = { role = "fast" }
)" + more + "[equations]\n" +
           equations;
}

// The paper's particle (section 2): x, y, of finite size, turn with one frequency, and
// z(t) = eps omega (C2 C3 - C1 C4) t, x = C1 cos + C2 sin, y = C3 cos + C4 sin, is the whole motion of z.
TEST(ASlowFlow, TheParticleRisesUniformly) {
    const Solution solution = solution_of_text(test::particle, 3, 4);
    const SlowFlow& flow = *solution.flow;
    EXPECT_TRUE(flow.at_rest());
    ASSERT_EQ(flow.phases.size(), 1U);
    const RealForm real(field(solution));
    const Ring& ring = *real.ring();
    const auto product = [&](GeneratorId a, GeneratorId b) {
        return ring.multiply(ring.gen(a), ring.gen(b));
    };
    const auto [x, y] =
        std::pair{real.modes()[0], real.modes()[1]}; // C1 = u_x, C2 = -v_x, C3 = u_y, C4 = -v_y
    const Polynomial scale = ring.multiply(ring.gen(real.eps()), ring.gen(*ring.find("omega")));
    const RealForm::Value rate = real(flow.drift[0].total(4));
    EXPECT_TRUE(rate.im.empty());
    EXPECT_EQ(rate.re, ring.multiply(scale, product(x.u, y.v) - product(x.v, y.u)));
    for (const FlowOutput& output : flow.outputs)
        if (output.name == "z") {
            EXPECT_TRUE(output.value.total(3).empty());
        } // nothing oscillates
}

// Independent frequencies: the phases take everything, 1 + 3/8 |z1|^2 + ..., and the amplitudes rest.
TEST(ASlowFlow, WithoutResonanceTheAmplitudesRest) {
    const Solution solution = solution_of_text(
        oscillators("x = \"x'' + x + x^3 = 0\"\ny = \"y'' + 3*y + y^3 + x^2*y = 0\"\n"), 2, 3);
    const SlowFlow& flow = *solution.flow;
    EXPECT_TRUE(flow.at_rest());
    EXPECT_EQ(flow_power(field(solution), flow), std::nullopt);
    ASSERT_EQ(flow.phases.size(), 2U);
    const Ring& ring = *field(solution).ring;
    const Mode& x = field(solution).modes[0];
    EXPECT_EQ(flow.phases[0], ring.one() + Rational(3) / 8 * ring.multiply(ring.gen(x.z), ring.gen(x.zbar)));
}

// In 1:1 resonance energy goes to and fro: a1' holds conj(a1) a2^2.
TEST(ASlowFlow, ResonantOscillatorsMoveOnTheirTimeScale) {
    const Solution solution =
        solution_of_text(oscillators("x = \"x'' + x + x*y^2 = 0\"\ny = \"y'' + y + x^2*y = 0\"\n"), 2, 3);
    const SlowFlow& flow = *solution.flow;
    EXPECT_FALSE(flow.at_rest());
    EXPECT_EQ(flow.phases.size(), 1U);
    EXPECT_EQ(flow_power(field(solution), flow), 2);
    const Ring& ring = *field(solution).ring;
    const auto& modes = field(solution).modes;
    // x y^2/2 averaged: i (2 z1 |z2|^2 + conj(z1) z2^2)/8
    const Polynomial z1 = ring.gen(modes[0].z), z2 = ring.gen(modes[1].z);
    const Polynomial expected =
        ring.multiply(Rational(1) / 8 * ring.imaginary(),
                      ring.multiply(ring.multiply(z2, z2), ring.gen(modes[0].zbar)) +
                          Rational(2) * ring.multiply(z1, ring.multiply(z2, ring.gen(modes[1].zbar))));
    EXPECT_EQ(rate_of_mode(solution, 0), expected);
}

// Equal frequencies, different twist: what a drift sees of both phases together is slow, not constant.
TEST(ASlowFlow, ADriftThatSeesTwoTwistsMoves) {
    const std::string text =
        oscillators("x = \"x'' + x + x^3 = 0\"\ny = \"y'' + y = 0\"\nX = \"X' = eps*x*y\"\n",
                    "X = { role = \"drift\" }\n");
    const Solution solution = solution_of_text(text, 2, 3);
    EXPECT_FALSE(solution.flow->at_rest());
    EXPECT_EQ(solution.flow->phases.size(), 1U);
    EXPECT_FALSE(rate_of_mode(solution, 0).empty());
    EXPECT_TRUE(rate_of_mode(solution, 1).empty());
}

// Frequencies in the ratio 1:2 that are symbols: one relation, two phases, and a1' = i conj(a1) a2 at
// order 1.
TEST(ASlowFlow, RelationsOfSymbolsMakeTheFrame) {
    const Solution solution = solution_of(
        read_system(std::string(RESONFORM_SOURCE_DIR) + "/systems/spring_pendulum/system.toml"), 2, 3);
    EXPECT_EQ(solution.flow->phases.size(), 2U);
    EXPECT_EQ(flow_power(field(solution), *solution.flow), 1);
}

TEST(ASlowFlow, MeansAreWhatDoesNotTurn) {
    const Solution solution =
        solution_of_text(oscillators("x = \"x'' + x + x^2 = 0\"\ny = \"y'' + 3*y + x*y = 0\"\n"), 2, 3);
    const GradedField& with = field(solution);
    const FlowOutput& x = solution.flow->outputs.front();
    EXPECT_TRUE(mean_part(with, *solution.flow, x.value.part(1)).empty());
    const Ring& ring = *with.ring;
    const Mode& mode = with.modes.front();
    EXPECT_EQ(mean_part(with, *solution.flow, x.value.part(2)), // x = ... - |z1|^2/2
              Rational(-1) / 2 * ring.multiply(ring.gen(mode.z), ring.gen(mode.zbar)));
    EXPECT_EQ(first_oscillation(with, *solution.flow, "x"), 1);
}

Scene long_scene(int order, int time_scale) {
    Scene s;
    s.order = order;
    s.time_scale = time_scale;
    return s;
}

TEST(ASlowFlow, CountsItsWeights) {
    const auto one_to_one = field_of(read_system_text(
        oscillators("x = \"x'' + x + x*y^2 = 0\"\ny = \"y'' + y + x^2*y = 0\"\n"), "test.toml"));
    EXPECT_EQ(count_truncation(*one_to_one, long_scene(3, 1)).truncation, 4);
    EXPECT_EQ(count_truncation(*one_to_one, long_scene(3, 2)).truncation, 6);
    EXPECT_EQ(count_truncation(*one_to_one, long_scene(3, 0)).truncation, 3);
    const auto rotation =
        field_of(read_system(std::string(RESONFORM_SOURCE_DIR) + "/systems/rotating_pendulum/system.toml"));
    const auto count = count_truncation(*rotation, long_scene(2, 1)); // J' = eps cos(phi), phi' = J
    EXPECT_EQ(count.truncation, 4);
    EXPECT_EQ(count.reason,
              "order 2 on t = O(1/eps): rates neglected at weight 5 act over 1/eps, so M = N + 2p = 4");
}

// On t = 1/eps^2 a flow of order eps^2 goes a finite way, one of order eps may go anywhere.
TEST(ASlowFlow, LongTimesAreForFlowsThatAreSlowEnough) {
    const std::string one_to_one = oscillators("x = \"x'' + x + x*y^2 = 0\"\ny = \"y'' + y + x^2*y = 0\"\n");
    EXPECT_NO_THROW(check_time_scale(solution_of_text(one_to_one, 2, 5), long_scene(2, 2)));
    const std::string one_to_two = oscillators("x = \"x'' + x + x*y = 0\"\ny = \"y'' + 4*y + x^2 = 0\"\n");
    EXPECT_NO_THROW(check_time_scale(solution_of_text(one_to_two, 2, 3), long_scene(2, 1)));
    const Error e =
        test::error_when([&] { check_time_scale(solution_of_text(one_to_two, 2, 5), long_scene(2, 2)); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().value, "time_scale = 2, the flow has rates of order eps^1");
    EXPECT_EQ(e.diagnostic().hint, "use time_scale = 1, or give the truncation yourself");
}

} // namespace
