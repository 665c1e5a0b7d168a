// SPDX-License-Identifier: GPL-3.0-or-later
// Law: the state of a solution at the start, taken as physical start values, gives back the constants
// of that solution through weight M.
#include "solve/initial_values.hpp"
#include "solve/line.hpp"
#include "solve/systems.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

void expect_zero(const Ring& ring, const Polynomial& p, int through) {
    const auto parts = ring.by_weight(p, through);
    for (std::size_t n = 0; n < parts.size(); ++n)
        EXPECT_EQ(ring.is_zero(parts[n]), Zero::yes) << "weight " << n << ": " << parts[n].size() << " terms";
}

void expect_round_trip(const Solution& s) {
    const InitialValues values = initial_values(s);
    ASSERT_EQ(values.start.size(), s.state.size());
    // start values -> the state at the start, where slow time and quadratures are zero
    std::vector<std::pair<GeneratorId, Polynomial>> zeros;
    if (s.slow_time) zeros.emplace_back(*s.slow_time, Polynomial());
    for (const Primitive& p : s.primitives)
        if (p.kind == PrimitiveKind::quadrature) {
            zeros.emplace_back(p.id, Polynomial());
        } else if (p.kind == PrimitiveKind::exponential && s.slow_time) {
            zeros.emplace_back(p.id, s.ring->one()); // exp(-T) at T = 0
        }
    const RingMap at_start = RingMap::by_name(s.ring, s.ring, zeros);
    std::vector<std::pair<GeneratorId, Polynomial>> images;
    for (std::size_t k = 0; k < s.state.size(); ++k)
        images.emplace_back(values.start[k], at_start(s.state[k].value.total(s.truncation)));
    const RingMap put = RingMap::by_name(values.ring, s.ring, images);

    const Ring& ring = *s.ring;
    const ModeSolution& mode = s.modes.front();
    const Polynomial w = put(values.w_real) + ring.multiply(ring.imaginary(), put(values.w_imaginary));
    const Polynomial amplitude = ring.multiply(ring.gen(mode.amplitude), at_start(put(values.scale)));
    expect_zero(ring, w - ring.multiply(amplitude, ring.gen(mode.phase)), s.truncation);
    for (std::size_t d = 0; d < s.drift.size(); ++d)
        expect_zero(ring, put(values.drift[d]) - ring.gen(s.drift[d].constant), s.truncation);
}

TEST(InitialValues, GiveBackTheConstantsOfThePendulum) {
    for (int truncation : {3, 4}) expect_round_trip(solution_of(pendulum(), 3, truncation));
}

TEST(InitialValues, GiveBackTheConstantsOfOtherSystems) {
    expect_round_trip(solution_of_text(stiffening_spring, 3, 4));
    expect_round_trip(solution_of_text(duffing, 3, 4));
    expect_round_trip(solution_of_text(damped, 3, 4));
}

TEST(InitialValues, AreRealAndSayWhetherTheAmplitudeIsImplicit) {
    const Solution s = solution_of(pendulum(), 3, 4);
    const InitialValues values = initial_values(s);
    EXPECT_EQ(values.ring->conjugate(values.w_real), values.w_real);
    EXPECT_EQ(values.ring->conjugate(values.w_imaginary), values.w_imaginary);
    EXPECT_FALSE(values.implicit); // B_2 of the pendulum is free of C
    for (const Term& t : values.leading_scale.terms()) EXPECT_GT(t.coefficient, 0);
}

} // namespace
