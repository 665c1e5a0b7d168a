// SPDX-License-Identifier: GPL-3.0-or-later
// What is wanted of scenes whose frequencies hang on no computed flow: 4 ulp of an output's scale in every
// form, in double from 100 starts at 1000 times each, and in long double.
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/emitted_points.hpp"

#include "emit/program/build_program.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>

namespace resonform {
namespace {

constexpr double wanted_ulp = 4;

class SlowFourUnits : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(SlowFourUnits, AreEnoughForClosedScenes) {
    const auto& [system, name] = GetParam();
    const std::filesystem::path cache = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";
    const Scene scene = test::scene_of(system, name);
    const Solution solution = test::solution_of(scene);
    const Program program = build_program(solution, scene, {true, false, true});
    const auto library = EvaluatorLibrary::build(program, cache, {}, "dlfe");
    const EmittedCheck check = check_emitted(program, library, solution, scene, {cache, {}, 100, 100});
    EXPECT_EQ(check.verdict, Verdict::pass) << to_text(check);
    EXPECT_EQ(check.types.at(0).points, 100000U);
    for (const EmittedInType& type : check.types) EXPECT_LE(type.ulp, wanted_ulp) << to_text(check);
}

INSTANTIATE_TEST_SUITE_P(SlowScenes, SlowFourUnits,
                         ::testing::Values(std::tuple("almost_holonomic_pendulum", "as_published"),
                                           std::tuple("disc_on_a_track", "second_order"),
                                           std::tuple("airy", "waves"),
                                           std::tuple("adiabatic_oscillator", "square_root"),
                                           std::tuple("crossing_rates", "through_one_rate"),
                                           std::tuple("transition_state", "aimed")));

} // namespace
} // namespace resonform
