// SPDX-License-Identifier: GPL-3.0-or-later
// The points at which emitted code is asked, and that it is asked in each of its forms.
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/emitted_forms.hpp"
#include "verify/judging/start_scaling.hpp"
#include "verify/scene_line.hpp"

#include "emit/program/build_program.hpp"
#include "model/system/start_names.hpp"
#include "support/compiler.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace resonform {
namespace {

namespace fs = std::filesystem;

Scene asked_scene() { return test::scene_of("slowly_stiffening_oscillator", "third_order"); }

// Else nothing would tell a grid from calls.
TEST(EmittedPoints, OfAGridAreBesideTheTimesAndFewOfThemAreDoubles) {
    std::size_t no_doubles = 0;
    for (const auto& points : emitted_points<double>(asked_scene(), 20, 40, 1)) {
        ASSERT_EQ(points.times.size(), 40U);
        ASSERT_EQ(points.grid.places.size(), 10U);
        std::size_t number = points.times.size();
        for (const auto& [point, place] : points.grid.places) {
            EXPECT_EQ(point, number++);
            ASSERT_LT(place, grid_points);
            const Float128 exact =
                Float128(points.grid.t0) + Float128(static_cast<int>(place)) * Float128(points.grid.dt);
            EXPECT_LE(exact * Float128(points.eps), Float128(points.end));
            no_doubles += Float128(static_cast<double>(exact)) != exact ? 1 : 0;
        }
        const auto first = points.at_first_time();
        EXPECT_EQ(first.times, std::vector<double>{points.times.front()});
        EXPECT_EQ(first.grid.places.size(), 1U);
    }
    EXPECT_GT(no_doubles, 150U);
    for (const auto& points : emitted_points<double>(asked_scene(), 3, 1, 1))
        EXPECT_TRUE(points.at_first_time().grid.places.empty());
}

// The pendulum starts at xi = 0: no coefficient of it would be seen.
TEST(EmittedPoints, StartsAtZeroAreMovedByAsMuchAsTheirWeightSays) {
    const Scene pendulum = test::pendulum_scene("third_order"),
                spring = test::scene_of("stiff_spring", "stiff");
    for (const auto& [scene, name] : {std::pair(&pendulum, "xi"), std::pair(&spring, "x'")}) {
        const int weight = start_weight(*scene->system, name);
        const auto drawn = emitted_points<double>(*scene, 10, 1, 1);
        std::size_t moved = 0;
        for (const auto& points : drawn) {
            const double value = points.start_of(canonical_start(name, *scene->system));
            EXPECT_LE(std::abs(value), std::pow(points.eps, weight));
            moved += value != 0 ? 1 : 0;
        }
        EXPECT_EQ(drawn.front().start_of(canonical_start(name, *scene->system)), 0) << "the scene's own";
        EXPECT_EQ(moved, 5U) << name;
    }
}

// With the library's code edited.
EmittedCheck edited(const std::string& from, const std::string& to) {
    const test::Scratch scratch;
    const test::SceneLine line = test::line_of(asked_scene());
    const Program program = build_program(line.solution, line.scene, {true, false, true});
    const test::OtherCompiler compiler(test::editing_compiler(scratch.path() / "compiler.sh", from, to));
    EmittedCheckOptions options;
    options.cache = fs::path(RESONFORM_BINARY_DIR) / "test_cache";
    options.starts = 5;
    return check_emitted(program, EvaluatorLibrary::build(program, scratch.path(), {}, "dlfe"), line.solution,
                         line.scene, options);
}

TEST(SlowEmittedForms, AreAskedOneByOne) {
    const std::vector<std::vector<std::string>> lies{
        {"locate_end(eps, parameters, start, t, c, a)",
         "locate_end(eps, parameters, start, t * Real(1.000001), c, a)", "at_end"},
        {"this, t0, dt, n", "this, t0, dt * 1.000001, n", "grid"},
        {"this, t, n, std::array{x}", "this, n > 1 ? t + 1 : t, n - 1, std::array{x}", "batch"}};
    for (const std::vector<std::string>& lie : lies) {
        const EmittedCheck check = edited(lie[0], lie[1]);
        EXPECT_EQ(check.verdict, Verdict::fail) << to_text(check);
        EXPECT_EQ(check.types.front().form, lie[2]) << to_text(check);
    }
}

TEST(SlowEmittedForms, AreAllThatTheLibraryHas) {
    const test::SceneLine line = test::line_of(asked_scene());
    const Program program = build_program(line.solution, line.scene, {true, false, true});
    const auto library =
        EvaluatorLibrary::build(program, fs::path(RESONFORM_BINARY_DIR) / "test_cache", {}, "dlfe");
    const auto points = emitted_points<double>(line.scene, 1, 10, 1).front();
    std::set<std::string> forms;
    for (const auto& answers : answers_of<double>({program, library}, points, 0)) {
        forms.insert(to_string(answers.form));
        EXPECT_TRUE(std::all_of(answers.statuses.begin(), answers.statuses.end(), [](unsigned char status) {
            return static_cast<Status>(status) == Status::ok;
        })) << to_string(answers.form);
        EXPECT_EQ(answers.times.size(), answers.form == EmittedForm::grid ? 2U : 10U);
    }
    EXPECT_EQ(forms, (std::set<std::string>{"one call", "batch", "grid", "at_end", "ensemble",
                                            "ensemble without full_phase"}));
    const auto interpreted = EvaluatorLibrary::interpreted(std::make_shared<const Program>(program));
    EXPECT_EQ(answers_of<double>({program, interpreted}, points, 0).size(), 1U);
}

} // namespace
} // namespace resonform
