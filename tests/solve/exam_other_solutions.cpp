// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions that can be read off: envelopes, frequencies, drifts.
#include "solve/line.hpp"
#include "solve/systems.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

TEST(Solution, SpringWithSlowStiffnessKeepsItsAction) {
    const Solution s = solution_of_text(stiffening_spring, 3, 4); // E = omega^(-1/2) = (2 + tau^2)^(-1/4)
    const Ring& ring = *s.ring;
    const ModeSolution& mode = s.modes.front();
    const Polynomial tau = ring.gen(s.slow.front().generator);
    const Polynomial stiffness = Rational(2) * ring.one() + ring.multiply(tau, tau);
    EXPECT_EQ(ring.is_zero(ring.multiply(ring.power(mode.envelope, 4), stiffness) - ring.one()), Zero::yes);
    EXPECT_EQ(mode.amplitude_name, "amplitude_x");
    EXPECT_FALSE(s.slow_time);
}

TEST(Solution, DuffingHasTheKnownFrequency) {
    const Solution s = solution_of_text(duffing, 4, 5); // theta' = 1 + 3/8 a^2 - 15/256 a^4, a = |w|
    const Ring& ring = *s.ring;
    const ModeSolution& mode = s.modes.front();
    EXPECT_EQ(mode.envelope, ring.one());
    EXPECT_EQ(mode.phase_rate.part(0), ring.one());
    const Polynomial a = ring.multiply(ring.gen(s.eps), ring.gen(mode.amplitude));
    EXPECT_EQ(mode.phase_rate.part(2), Rational(3) / 8 * ring.power(a, 2));
    EXPECT_TRUE(s.slow.empty());
    ASSERT_TRUE(s.slow_time);
    // X' = eps (1 + <x^2>) = eps (1 + a^2/2 + ...): linear in T = eps t
    const Polynomial t = ring.gen(*s.slow_time);
    EXPECT_EQ(s.drift.front().value.part(0), ring.gen(s.drift.front().constant) + t);
    EXPECT_EQ(s.drift.front().value.part(2), Rational(1) / 2 * ring.multiply(ring.power(a, 2), t));
    EXPECT_TRUE(s.primitives.empty());
}

TEST(Solution, DampingIsAnExponential) {
    const Solution s = solution_of_text(damped, 3, 4); // E = exp(-T)
    const Ring& ring = *s.ring;
    ASSERT_EQ(s.primitives.size(), 1U);
    EXPECT_EQ(s.primitives.front().kind, PrimitiveKind::exponential);
    EXPECT_EQ(s.primitives.front().argument, -ring.gen(*s.slow_time));
    EXPECT_EQ(s.modes.front().envelope, ring.gen(s.primitives.front().id));
    EXPECT_EQ(ring.derivative(s.modes.front().envelope, *s.slow_time), -s.modes.front().envelope);
}

TEST(Solution, ARateThatDoesNotDivideOutIsIntegratedOverSlowTime) {
    const Solution s = solution_of_text(damped_by_a_slow_variable, 3, 3); // E = exp(-int tau dT)
    ASSERT_EQ(s.primitives.size(), 2U);
    EXPECT_EQ(s.primitives[0].kind, PrimitiveKind::quadrature);
    EXPECT_TRUE(s.primitives[0].over_slow_time);
    EXPECT_EQ(s.primitives[0].argument, s.ring->gen(s.slow.front().generator));
    EXPECT_EQ(s.primitives[1].kind, PrimitiveKind::exponential);
    EXPECT_EQ(s.primitives[1].argument, -s.ring->gen(s.primitives[0].id));
    EXPECT_EQ(s.modes.front().envelope, s.ring->gen(s.primitives[1].id));
}

TEST(Solution, IsTheSameEveryTime) {
    const Solution a = solution_of(pendulum(), 3, 4), b = solution_of(pendulum(), 3, 4);
    ASSERT_EQ(a.ring->size(), b.ring->size());
    for (GeneratorId id = 0; id < a.ring->size(); ++id)
        EXPECT_EQ(a.ring->generator(id).name, b.ring->generator(id).name);
    for (std::size_t k = 0; k < a.outputs.size(); ++k)
        for (int n = 0; n <= 3; ++n) EXPECT_EQ(a.outputs[k].value.part(n), b.outputs[k].value.part(n));
}

} // namespace
