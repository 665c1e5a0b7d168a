// SPDX-License-Identifier: GPL-3.0-or-later
// What is wanted of scenes whose frequencies hang on no computed flow: 4 ulp of an output's scale in every
// form, from 100 starts at 1000 times each. What falls short of it has a limit of its own.
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

class SlowFourUnits
    : public ::testing::TestWithParam<std::tuple<std::string, std::string, std::string, double>> {};

TEST_P(SlowFourUnits, AreEnoughForClosedScenes) {
    const auto& [system, name, forms, most] = GetParam();
    const std::filesystem::path cache = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";
    const Scene scene = test::scene_of(system, name);
    const Solution solution = test::solution_of(scene);
    const Program program = build_program(solution, scene, {true, false, true});
    const auto library = EvaluatorLibrary::build(program, cache, {}, forms);
    const EmittedCheck check = check_emitted(program, library, solution, scene, {cache, {}, 100, 100});
    EXPECT_EQ(check.verdict, Verdict::pass) << to_text(check);
    EXPECT_EQ(check.types.at(0).points, 100000U);
    EXPECT_LE(check.types.at(0).ulp, most) << to_text(check);
}

// Final points of the disc have their integrals in double: 4.24 ulp.
INSTANTIATE_TEST_SUITE_P(
    SlowScenes, SlowFourUnits,
    ::testing::Values(std::tuple("almost_holonomic_pendulum", "as_published", "dlfe", wanted_ulp),
                      std::tuple("disc_on_a_track", "second_order", "dl", wanted_ulp),
                      std::tuple("airy", "waves", "dlfe", wanted_ulp),
                      std::tuple("adiabatic_oscillator", "square_root", "dlfe", wanted_ulp),
                      std::tuple("crossing_rates", "through_one_rate", "dlfe", wanted_ulp),
                      std::tuple("transition_state", "aimed", "dlfe", 4.1)));

} // namespace
} // namespace resonform
