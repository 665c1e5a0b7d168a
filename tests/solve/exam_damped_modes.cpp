// SPDX-License-Identifier: GPL-3.0-or-later
// Modes that are damped at eps = 0: what their exponents take of the rates, what is left within the frame,
// and how far normal forms must go.
#include "model/files/read_system.hpp"
#include "solve/flow/slow_flow.hpp"
#include "solve/line.hpp"
#include "solve/truncation.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

const std::string michaelis_menten = R"toml([system]
name = "kinetics"
[parameters]
kappa = { positive = true }
lam = { positive = true }
[variables]
s = { role = "slow", positive = true }
c = { role = "fast", weight = 0 }
[equations]
s = "s' = eps*(-s + (s + kappa - lam)*c)"
c = "c' = s - (s + kappa)*c"
[equilibrium]
c = "s/(s + kappa)"
)toml";

// A spiral y'' + 2 y' + 3 y beside an oscillator that it detunes, and whose square detunes it.
const std::string spiral = test::system_text(
    "spiral", {{"x", "fast", "x'' + x + x*y = 0"}, {"y", "fast", "y'' + 2*y' + 3*y + x^2 + y^2 = 0"}});

// The exponent of c is -(s + kappa) - eps kappa (s + kappa - lam)/(s + kappa)^2 + ..., through weight N, and
// its amplitude rests.
TEST(ADampedMode, GivesItsWholeRateToTheExponent) {
    const Solution solution = solution_of_text(michaelis_menten, 2, 3);
    const SlowFlow& flow = *solution.flow;
    EXPECT_TRUE(flow.phases.empty());
    ASSERT_EQ(flow.decays.size(), 1U);
    EXPECT_FALSE(flow.modes[0].phase);
    EXPECT_EQ(flow.modes[0].decay, 0U);
    EXPECT_TRUE(rate_of_mode(solution, 0).empty());
    const Ring& ring = *field(solution).ring;
    const Polynomial& z = ring.gen(field(solution).modes[0].z);
    EXPECT_EQ(ring.multiply(flow.decays[0], z), solution.normalization->normal_form.mode[0].total(2));
    const Polynomial s = ring.gen(*ring.find("s")), kappa = ring.gen(*ring.find("kappa"));
    EXPECT_EQ(ring.by_weight(flow.decays[0], 0).front(), -(s + kappa));
}

// lambda + Lambda = growth + i turning, by the conjugate of the whole rate.
TEST(ADampedMode, ThatTurnsHasExponentAndPhase) {
    const Solution solution = solution_of_text(spiral, 3, 4);
    const SlowFlow& flow = *solution.flow;
    const GradedField& f = field(solution);
    ASSERT_EQ(flow.decays.size(), 1U);
    ASSERT_EQ(flow.phases.size(), 2U);
    ASSERT_TRUE(flow.modes[1].phase && flow.modes[1].decay);
    EXPECT_FALSE(flow.modes[0].decay);
    const Polynomial turning = flow.phases[*flow.modes[1].phase];
    const Polynomial own = flow.decays[0] + f.ring->multiply(f.ring->imaginary(), turning);
    EXPECT_EQ(f.ring->multiply(own, f.ring->gen(f.modes[1].z)),
              solution.normalization->normal_form.mode[1].total(4));
    // The square of the oscillation changes both.
    EXPECT_GT(flow.decays[0].size(), 1U);
    EXPECT_GT(turning.size(), 1U);
}

// y' = -2 y + u^2 is driven as fast as it decays itself, y = (b + a^2 t) e^{-2t}: the exponents take the
// eigenvalues alone, and the amplitude of y grows evenly.
TEST(ADampedMode, InExactResonanceIsDrivenWithinTheFrame) {
    const Solution solution = solution_of_text(R"toml([system]
name = "triangular"
[variables]
u = { role = "fast" }
y = { role = "fast" }
[equations]
u = "u' = -u"
y = "y' = -2*y + u^2"
)toml",
                                               3, 4);
    const SlowFlow& flow = *solution.flow;
    const GradedField& f = field(solution);
    ASSERT_EQ(flow.decays.size(), 2U);
    EXPECT_TRUE(rate_of_mode(solution, 0).empty());
    EXPECT_EQ(rate_of_mode(solution, 1), f.ring->power(f.ring->gen(f.modes[0].z), 2));
}

// A real mode of eigenvalue 0 neither turns nor decays: the centre manifold x' = x y = x^3 + ...
TEST(AModeOfEigenvalueZero, MovesWithTheFlow) {
    const Solution solution = solution_of_text(
        test::system_text("centre", {{"x", "fast", "x' = x*y"}, {"y", "fast", "y' = -y - x^2"}}), 3, 3);
    const SlowFlow& flow = *solution.flow;
    const GradedField& f = field(solution);
    EXPECT_FALSE(flow.modes[0].phase);
    EXPECT_FALSE(flow.modes[0].decay);
    EXPECT_EQ(rate_of_mode(solution, 0), -f.ring->power(f.ring->gen(f.modes[0].z), 3));
    EXPECT_EQ(flow_power(f, flow), 2);
}

// At equal frequencies the oscillation turns the spiral back into itself: conj(z3) z1^2 stays in its rate.
TEST(ADampedMode, InResonanceWithAnOscillatorMovesWithinTheFrame) {
    const Solution solution =
        solution_of_text(test::system_text("resonant", {{"x", "fast", "x'' + x = 0"},
                                                        {"y", "fast", "y'' + 2*y' + 2*y + x^2*y = 0"}}),
                         3, 4);
    const SlowFlow& flow = *solution.flow;
    EXPECT_EQ(flow.phases.size(), 1U);
    EXPECT_EQ(flow.decays, std::vector<Polynomial>{-field(solution).ring->one()});
    EXPECT_FALSE(rate_of_mode(solution, 1).empty());
}

// The mean of an output has no transient in it.
TEST(ADampedMode, IsNoPartOfTheMeanMotion) {
    const Solution solution = solution_of_text(michaelis_menten, 1, 2);
    const GradedField& f = field(solution);
    for (const FlowOutput& output : solution.flow->outputs) {
        const Polynomial all = output.value.total(1), mean = mean_part(f, *solution.flow, all);
        EXPECT_LT(mean.size(), all.size());
        for (const Term& t : mean.terms()) EXPECT_EQ(degree_in(f, t.monomial, 0), 0);
    }
}

// On the slow manifold nothing is left of them, but at the start.
TEST(ADampedMode, IsLeftOutWithoutTransients) {
    SolveOptions options{3, 4};
    options.transients = false;
    const Solution all = solution_of_text(spiral, 3, 4),
                   solution = solution_of(read_system_text(spiral, "test.toml"), options);
    const SlowFlow& flow = *solution.flow;
    const GradedField& f = field(solution);
    EXPECT_TRUE(flow.decays.empty());
    EXPECT_EQ(flow.phases.size(), 1U);
    EXPECT_TRUE(flow.modes[1].is_left_out);
    ASSERT_EQ(flow.outputs.size(), all.flow->outputs.size());
    for (std::size_t k = 0; k < flow.outputs.size(); ++k) {
        const Polynomial lasting = flow.outputs[k].value.total(3);
        const Polynomial left_out = all.flow->outputs[k].value.total(3) - lasting;
        EXPECT_FALSE(lasting.empty());
        EXPECT_FALSE(left_out.empty());
        for (const Term& t : lasting.terms()) EXPECT_FALSE(has_damped_mode(f, t.monomial));
        for (const Term& t : left_out.terms()) EXPECT_TRUE(has_damped_mode(f, t.monomial));
    }
    for (std::size_t k = 0; k < flow.state.size(); ++k)
        EXPECT_EQ(flow.state[k].value.total(4), all.flow->state[k].value.total(4));
}

// Nothing turns for long: no phase needs one weight more.
TEST(Truncation, OfDampedModesCountsNoPhase) {
    Scene scene;
    scene.order = 2;
    const auto count = [&](const std::string& toml) {
        return count_truncation(*field_of(read_system_text(toml, "test.toml")), scene).truncation;
    };
    EXPECT_EQ(count(michaelis_menten), 3);
    scene.time_scale = 2;
    EXPECT_EQ(count(michaelis_menten), 4);
    scene.time_scale = 1;
    EXPECT_EQ(count(spiral), 3);
    scene.time_scale = 2;
    EXPECT_EQ(count(spiral), 5);
}

} // namespace
