// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs as rows for tables: which harmonics they have, and which scenes have none.
#include "support/program.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace resonform::test {
namespace {

Program with_rows(const std::string& system, const std::string& name) {
    const Scene scene = scene_of(system, name);
    return build_program(solution_of(scene), scene, {true, false, true, {}});
}

// k and d, of an output.
std::set<std::vector<int>> harmonics(const Program& program, std::size_t output) {
    std::set<std::vector<int>> found;
    for (const ProgramRow& row : program.rows)
        if (row.output == output) found.insert(row.turns);
    return found;
}

} // namespace

// z2 z3, z1 and z1 z3 in x; z1 z2, z3 and z1^2 in y, where z3 = a3 e^{chi + i theta_2}.
TEST(Rows, OfModesThatDecayCarryTheirExponentials) {
    const Program program = with_rows("stiff_spring", "stiff");
    ASSERT_EQ(program.phases.size(), 3U);
    EXPECT_TRUE(program.phases[2].decays());
    EXPECT_EQ(harmonics(program, 0),
              (std::set<std::vector<int>>{{1, -1, 1}, {1, 0, 0}, {1, 1, 1}, {3, 0, 0}}));
    EXPECT_EQ(harmonics(program, 1), (std::set<std::vector<int>>{{0, 0, 0}, {0, 1, 1}, {2, 0, 0}}));
    EXPECT_EQ(program.form_reason, "tables pay below 5 times a call");
}

// A real mode does not turn: one row for each power of its exponential.
TEST(Rows, OfRealModesAreNoPairs) {
    const Program program = with_rows("davis_skodje", "onto_the_manifold");
    ASSERT_EQ(program.phases.size(), 1U);
    for (const ProgramRow& row : program.rows)
        EXPECT_EQ(row.wave, row.turns == std::vector<int>{0} ? ProgramWave::one : ProgramWave::cosine);
    EXPECT_EQ(harmonics(program, 1), (std::set<std::vector<int>>{{0}, {1}}));
}

TEST(Rows, AreLeftOutWhereAModeMayGrowOrADivisorVanish) {
    const Program growing = with_rows("transition_state", "over_the_saddle");
    EXPECT_TRUE(growing.rows.empty());
    EXPECT_EQ(growing.form_reason, "no tables of modes that may grow");
    const Program crossing = with_rows("crossing_rates", "through_one_rate");
    EXPECT_TRUE(crossing.rows.empty());
    EXPECT_EQ(crossing.form_reason, "no tables where a divisor may pass zero");
}

} // namespace resonform::test
