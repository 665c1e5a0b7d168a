// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of run times: what must hold on any machine.
#include "scene_line.hpp"
#include "support/documented.hpp"
#include "support/shell.hpp"
#include "verify/report/figures.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace resonform {
namespace {

// One comparison for all its tests.
class Compare : public testing::Test {
protected:
    static void SetUpTestSuite() {
        const test::SceneLine line = test::pendulum("third_order");
        CompareOptions options;
        static_cast<VerifyOptions&>(options) = test::options();
        options.eps = {Rational(1) / Rational(100), Rational(1) / Rational(50)};
        options.dense_points = 20000;
        comparison_ = std::make_unique<Comparison>(compare(line.system, line.scene, line.solution, options));
    }
    static void TearDownTestSuite() { comparison_.reset(); }
    static const Comparison& compared() { return *comparison_; }

private:
    inline static std::unique_ptr<Comparison> comparison_; // NOLINT: what SetUpTestSuite is for
};
using SlowCompare = Compare;

TEST_F(Compare, RowsBreakEvenAndJson) {
    const Comparison& c = compared();
    // two eps, two tasks; orders 1 ... 3, three rivals at ten tolerances
    EXPECT_EQ(c.rows.size(), 2U * 2 * (3 + 3 * 10));
    for (const ComparisonRow& row : c.rows) {
        EXPECT_EQ(row.failure, "") << row.method << ' ' << row.setting;
        EXPECT_GT(row.seconds.low, 0);
        EXPECT_LE(row.seconds.low, row.seconds.median);
        EXPECT_LE(row.seconds.median, row.seconds.high);
        EXPECT_GE(row.seconds.repetitions, 3);
        EXPECT_GT(row.construction_seconds, 0);
        ASSERT_EQ(row.max_error.size(), 3U);
        if (row.task == Task::dense) {
            EXPECT_GE(row.points, 20000U);
        }
        if (row.method == "Taylor" && row.setting == "tolerance 1e-13") {
            EXPECT_LT(row.max_error[0], 1e-13);
        }
        if (row.method == "emitted" && row.setting == "order 3" && row.task == Task::dense &&
            row.eps == Rational(1) / 100) {
            EXPECT_NEAR(row.max_error[0], 2.01e-8, 0.02e-8);
        }
    }
    ASSERT_EQ(c.by_eps.size(), 2U);
    ASSERT_EQ(c.by_eps.front().tasks.size(), 2U);
    for (const BreakEven& b : c.by_eps.front().tasks) {
        ASSERT_EQ(b.rivals.size(), 3U);
        double best = b.emitted_seconds;
        for (const RivalAtEqualAccuracy& r : b.rivals) {
            ASSERT_TRUE(r.seconds.has_value()) << r.method;
            EXPECT_DOUBLE_EQ(*r.ratio, *r.seconds / b.emitted_seconds);
            best = std::min(best, *r.seconds);
        }
        const bool emitted_wins = b.winner == "emitted";
        EXPECT_EQ(emitted_wins, best == b.emitted_seconds) << "the winner is the fastest";
    }
    const auto json = to_json(c);
    EXPECT_EQ(json["schema"], "resonform.comparison/1");
    EXPECT_EQ(json["eps"], 0.01);
    for (const char* key :
         {"method", "setting", "task", "points", "max_error", "seconds", "construction_seconds"})
        EXPECT_TRUE(json["rows"][0].contains(key)) << key;
    EXPECT_EQ(test::undocumented(json, test::file_formats()), std::set<std::string>());
    for (const auto& [task, even] : json["break_even"].items()) {
        EXPECT_EQ(test::keys_of(even), (std::set<std::string>{"emitted_seconds", "rivals", "winner", "method",
                                                              "seconds", "ratio"}))
            << task;
    }
    EXPECT_EQ(json["break_even"].size(), 2U);
    EXPECT_EQ(json["by_eps"][0]["break_even"], json["break_even"]);
    EXPECT_EQ(json["by_eps"][1]["eps"], 0.02);
    EXPECT_EQ(json["rows"].back()["eps"], 0.02);
}

TEST_F(SlowCompare, ErrorsOfAMethodFallWithItsTolerance) {
    const Comparison& c = compared();
    for (const char* method : {"CVODE Adams", "odeint dopri5", "Taylor"}) {
        std::vector<double> errors;
        for (const ComparisonRow& row : c.rows)
            if (row.method == method && row.task == Task::dense && row.eps == c.by_eps.front().eps)
                errors.push_back(row.max_error[0]);
        EXPECT_GT(errors.front(), 1e6 * errors.back()) << method;
    }
}

namespace {

using Lines = std::vector<std::string>;

// A spring with negative damping, whose motion outgrows its evaluator where t is some 5/eps.
test::SceneLine growing(const test::Scratch& scratch, const std::string& interval) {
    const auto folder = scratch.path() / "systems/growing";
    test::write(folder / "system.toml", "[system]\nname = \"growing\"\n[variables]\nx = { role = \"fast\" }\n"
                                        "[equations]\nx = \"x'' - 2*eps*x' + x + x^3 = 0\"\n");
    test::write(folder / "scenes/s.toml", "order = 2\n[start]\nx = \"eps\"\n\"x'\" = 0\n[verify]\n"
                                          "interval = \"" +
                                              interval + "\"\n");
    return test::line_of(read_scene(folder / "scenes/s.toml", scratch.path() / "systems"));
}

Comparison comparison_of(const test::SceneLine& line, Lines& progress) {
    CompareOptions options;
    static_cast<VerifyOptions&>(options) = test::options();
    options.progress = [&](const std::string& text) { progress.push_back(text); };
    options.eps = {Rational(1) / 50};
    options.dense_points = 2000;
    options.silence = 0;
    return compare(line.system, line.scene, line.solution, options);
}

bool told(const Lines& progress, const std::string& beginning) {
    return std::any_of(progress.begin(), progress.end(),
                       [&](const std::string& line) { return line.rfind(beginning, 0) == 0; });
}

} // namespace

// The evaluator is asked first: where it has no numbers the long integrations would be in vain.
TEST(SlowCompareRefused, NothingIsIntegrated) {
    const test::Scratch scratch;
    Lines progress;
    const Comparison c = comparison_of(growing(scratch, "10/eps"), progress);
    EXPECT_FALSE(told(progress, "integrating directly"));
    EXPECT_FALSE(told(progress, "timing"));
    EXPECT_TRUE(
        told(progress, "the emitted code of order 2 has no numbers at eps = 1/50 (outside_domain: x)"));
    ASSERT_EQ(c.rows.size(), 4U); // two orders, two tasks
    for (const ComparisonRow& row : c.rows) {
        EXPECT_EQ(row.method, "emitted");
        EXPECT_EQ(row.failure, "outside_domain: x");
        EXPECT_TRUE(std::isnan(row.max_error.at(0)));
    }
    for (const BreakEven& b : c.by_eps.at(0).tasks) EXPECT_EQ(b.failure, "outside_domain: x");
    EXPECT_NE(to_text(c).find("dense: the emitted evaluator has no numbers (outside_domain: x)"),
              std::string::npos)
        << to_text(c);
    const report::Figures figures(*growing(scratch, "10/eps").scene.system, scratch.path());
    EXPECT_TRUE(figures.work(c).figures.empty()); // a plot of no curve is none
}

// What is long says where it is.
TEST(SlowCompareRefused, RivalsTellWhatIsUnderWay) {
    const test::Scratch scratch;
    Lines progress;
    const Comparison c = comparison_of(growing(scratch, "1/eps"), progress);
    EXPECT_TRUE(told(progress, "timing CVODE Adams, dense, tolerance 1e-13"));
    EXPECT_EQ(c.by_eps.at(0).tasks.at(0).failure, "");
}

// An evaluator that refuses is fast, and has no accuracy that anybody could reach.
TEST(BreakEvenOf, AnEvaluatorWithoutNumbersIsNoWinner) {
    ComparisonRow emitted;
    emitted.method = "emitted";
    emitted.max_error = {std::nan("")};
    emitted.seconds.median = 1e-6;
    emitted.failure = "outside_domain: x";
    ComparisonRow rival;
    rival.method = "Taylor";
    rival.max_error = {1e-12};
    rival.seconds.median = 1e-3;
    Comparison c;
    c.by_eps = {{Rational(1) / 10, {break_even({emitted, rival}, emitted, emitted)}}};
    EXPECT_EQ(c.by_eps.front().tasks.front().winner, "");
    const auto json = to_json(c);
    EXPECT_EQ(json["break_even"]["final"]["winner"], nullptr);
    EXPECT_EQ(json["break_even"]["final"]["emitted_seconds"], nullptr);
    EXPECT_NE(
        to_text(c).find("final: the emitted evaluator has no numbers (outside_domain: x), and nothing is "
                        "compared\n"),
        std::string::npos)
        << to_text(c);
}

// Who is the fastest is said, whoever it is.
TEST(CompareText, SaysThatTheEvaluatorLosesWhereItDoes) {
    Comparison c;
    c.system = "a";
    c.scene = "b";
    c.by_eps = {{Rational(1) / 100,
                 {{Task::final, 2, {{"Taylor", 1.0, 0.5}}, "Taylor"},
                  {Task::dense, 2, {{"Taylor", 4.0, 2.0}}, "emitted"}}}};
    const std::string text = to_text(c);
    EXPECT_NE(text.find("Taylor 1 s (0.5 times); the emitted evaluator loses, Taylor is the fastest\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("Taylor 4 s (2 times); the emitted evaluator is the fastest\n"), std::string::npos)
        << text;
}

} // namespace
} // namespace resonform
