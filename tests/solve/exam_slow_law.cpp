// SPDX-License-Identifier: GPL-3.0-or-later
// Slow variables that relax, xi' = eps (a - b xi): which laws are known, and solutions along them.
#include "algebra/number/error.hpp"
#include "solve/line.hpp"
#include "solve/slow_law.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <optional>

using namespace resonform;
using namespace resonform::testing;

namespace {

std::string relaxing(const std::string& law, const std::string& equation = "x'' + (1 + s^2)*x + x^3 = 0") {
    return test::system_text("relaxing", {{"x", "fast", equation}, {"s", "slow", law}},
                             "[parameters]\na = {}\nb = { positive = true }\nk = {}\n"
                             "[domain]\npositive = [\"2 + s\"]\n");
}

struct Path {
    std::shared_ptr<const GradedField> field;
    std::optional<SlowPath> path;

    [[nodiscard]] Polynomial symbol(const std::string& name) const {
        return field->ring->gen(*field->ring->find(name));
    }
    [[nodiscard]] Polynomial times_eps(const Polynomial& p) const {
        return field->ring->multiply(field->ring->gen(field->eps), p);
    }
};
Path path_of(const std::string& system) {
    Path found{field_of(read_system_text(system, "test.toml")), {}};
    const SlowVariable& slow = found.field->slow.front();
    found.path = slow_path(*found.field->ring, slow.generator, slow.rate);
    return found;
}

TEST(SlowLaw, IsLinearWithARateThatIsNotZero) {
    for (const char* law : {"s' = eps*a", "s' = -eps*b*s", "s' = eps*(a - b*s)", "s' = eps*(a + b*s/3)",
                            "s' = -2*eps*s", "s' = eps^2*(a - s)", "s' = eps*a - eps^2*s"})
        EXPECT_TRUE(path_of(relaxing(law)).path) << law;
    // k and b - 1 may be 0, and so may b + eps for some eps
    for (const char* law : {"s' = -eps*k*s", "s' = eps*(1 - b)*s", "s' = -eps*(b + eps)*s", "s' = eps*s^2",
                            "s' = eps*s*(1 - s)", "s' = eps*sin(s)"})
        EXPECT_FALSE(path_of(relaxing(law)).path) << law;
}

TEST(SlowLaw, SplitsIntoDriveAndDecline) {
    const Path found = path_of(relaxing("s' = eps*(a - 2*b*s)"));
    ASSERT_TRUE(found.path);
    EXPECT_EQ(found.path->drive, found.times_eps(found.symbol("a")));
    EXPECT_EQ(found.path->decline, Rational(2) * found.times_eps(found.symbol("b")));
}

TEST(SlowLaw, IsFoundWhereTheRingWritesTheVariableByARoot) {
    const Path found = path_of(relaxing("s' = eps*(a - b*s)", "x'' + (2 + s)*x + x^3 = 0"));
    ASSERT_TRUE(found.path);
    EXPECT_EQ(found.path->decline, found.times_eps(found.symbol("b")));
}

TEST(RelaxingSolution, IsClosed) {
    const Solution s = solution_of_text(relaxing("s' = eps*(a - b*s)"), 3, 4);
    ASSERT_FALSE(s.flow);
    const Ring& ring = *s.ring;
    const Polynomial& envelope = s.modes.front().envelope;
    const Polynomial slow = ring.gen(s.slow.front().generator);
    EXPECT_EQ(ring.is_zero(ring.multiply(ring.power(envelope, 4), ring.one() + ring.multiply(slow, slow)) -
                           ring.one()),
              Zero::yes);
    EXPECT_TRUE(s.primitives.empty());
}

// Its integral over slow time is known, that over the slow variable is not.
TEST(RelaxingSolution, HasConstantDampingAsAnExponentialOfSlowTime) {
    const Solution s =
        solution_of_text(relaxing("s' = eps*(a - b*s)", "x'' + 2*eps*b*x' + (2 + s)*x + x^3 = 0"), 3, 4);
    ASSERT_FALSE(s.flow);
    ASSERT_TRUE(s.slow_time);
    ASSERT_EQ(s.primitives.size(), 1U);
    const Primitive& decay = s.primitives.front();
    EXPECT_EQ(decay.kind, PrimitiveKind::exponential);
    EXPECT_TRUE(decay.over_slow_time);
    EXPECT_EQ(decay.argument, -s.ring->multiply(s.ring->gen(*s.ring->find("b")), s.ring->gen(*s.slow_time)));
}

// An exponential of a quadrature over slow time moves with it: what it stands in is no primitive over s.
TEST(RelaxingSolution, TakesNoExponentialOverSlowTimeForAConstant) {
    const Solution s = solution_of_text(
        relaxing("s' = eps*(a - b*s)", "x'' + 2*eps*s^2*x' + (2 + s)*x + s^2*x'^3 = 0"), 3, 4);
    ASSERT_FALSE(s.flow);
    for (const Primitive& p : s.primitives) EXPECT_TRUE(p.over_slow_time) << p.name;
}

TEST(RelaxingSolution, IsAFlowWhereTheRateMayVanishOrTimesAreLonger) {
    EXPECT_TRUE(solution_of_text(relaxing("s' = -eps*k*s"), 3, 4).flow);
    EXPECT_TRUE(solution_of_text(relaxing("s' = -eps*b*s"), 3, 5, 2).flow);
}

} // namespace
