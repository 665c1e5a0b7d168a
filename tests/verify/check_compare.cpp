// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of run times: what must hold on any machine.
#include "emit/cpp/cpp.hpp"
#include "scene_line.hpp"
#include "support/documented.hpp"
#include "support/shell.hpp"
#include "verify/comparison/break_even.hpp"
#include "verify/comparison/emitted_code.hpp"
#include "verify/report/figures.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace resonform {
namespace {

// y begins at eps^2 on the slow manifold: at order 1 there is nothing of it, which is no reason to refuse
// order 3.
TEST(SlowCompareOrders, GoDownToWhereAnOutputIsNothing) {
    const test::SceneLine line = test::line_of(test::scene_of("transition_state", "centre_manifold"));
    CompareOptions options;
    static_cast<VerifyOptions&>(options) = test::options();
    options.orders = {1, 3};
    const std::vector<EmittedCode> codes = emitted_codes(line.scene, line.solution, options);
    ASSERT_EQ(codes.size(), 2U);
    EXPECT_EQ(codes.front().prepared().order, 1);
    EXPECT_EQ(codes.back().prepared().order, 3);
}

constexpr std::size_t rivals = 6, with_dear_points = 2;

// One comparison, which takes seconds, for all that is asked of it.
class SlowCompare : public testing::Test {
protected:
    static Comparison of_the_pendulum() {
        const test::SceneLine line = test::pendulum("third_order");
        CompareOptions options;
        static_cast<VerifyOptions&>(options) = test::options();
        options.eps = {Rational(1) / Rational(100), Rational(1) / Rational(50)};
        options.orders = {1, 3};
        options.tasks = {Task::final, Task::dense, Task::grid, Task::ensemble};
        options.points = {1000, 20000};
        options.members = 40;
        options.repetitions = 2;
        options.derivation_seconds = 1;
        return compare(line.system, line.scene, line.solution, options);
    }
    [[nodiscard]] const Comparison& compared() const { return comparison_; }

    [[nodiscard]] const ComparisonRow& emitted(int order, Task task, Form form, std::size_t points) const {
        const auto at =
            std::find_if(compared().rows.begin(), compared().rows.end(), [&](const ComparisonRow& r) {
                return r.order == order && r.task == task && r.form == form && r.points == points;
            });
        EXPECT_NE(at, compared().rows.end());
        return *at;
    }

    void check_rows_of_every_task_and_form() const;
    void check_forms_have_the_same_errors() const;
    void check_rivals_are_tuned_to_the_accuracy_of_each_order() const;
    void check_json_and_csv() const;
    void check_errors_fall_with_the_tolerance() const;

private:
    const Comparison comparison_ = of_the_pendulum();
};

void SlowCompare::check_rows_of_every_task_and_form() const {
    const Comparison& c = compared();
    // two eps; two orders in 2 forms of one point, 3 of two numbers of points, 1 of members; the rivals at
    // ten tolerances for one point and for two numbers of points twice, and tuned to the orders for members
    // and where many points are dear
    EXPECT_EQ(c.rows.size(),
              2U * (2 * (2 + 3 * 2 + 1) + rivals * 10 + (rivals - with_dear_points) * 10 * 2 * 2 +
                    with_dear_points * 2 * 2 * 2 + rivals * 2));
    for (const ComparisonRow& row : c.rows) {
        EXPECT_EQ(row.failure, "") << row.method << ' ' << row.setting;
        EXPECT_GT(row.seconds.low, 0);
        EXPECT_LE(row.seconds.low, row.seconds.median);
        EXPECT_LE(row.seconds.median, row.seconds.high);
        EXPECT_EQ(row.seconds.repetitions, 2);
        const bool constructs = row.form != Form::at_end && row.task != Task::ensemble;
        EXPECT_EQ(row.construction_seconds > 0, constructs) << row.method << ' ' << to_string(row.task);
        EXPECT_EQ(row.members, row.task == Task::ensemble ? 40U : 1U);
        EXPECT_LE(row.run_members, row.members);
        EXPECT_GE(row.run_members, std::min<std::size_t>(row.members, 8));
        EXPECT_EQ(row.is_emitted(), row.method == "emitted");
        EXPECT_EQ(row.is_emitted(), row.order > 0);
        ASSERT_EQ(row.max_error.size(), 3U);
        if (row.method == "Taylor" && row.setting == "tolerance 1e-13") {
            EXPECT_LT(row.max_error[0], 1e-13);
        }
    }
    EXPECT_NEAR(emitted(3, Task::dense, Form::batch, 20000).max_error[0], 2.01e-8, 0.02e-8);
}

// The forms are one formula.
void SlowCompare::check_forms_have_the_same_errors() const {
    for (const int order : {1, 3}) {
        const auto same = [&](const ComparisonRow& a, const ComparisonRow& b) {
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(a.max_error[k], b.max_error[k], 1e-13) << to_string(*a.form);
        };
        same(emitted(order, Task::final, Form::at_end, 1), emitted(order, Task::final, Form::scalar, 1));
        for (const std::size_t points : {1000U, 20000U}) {
            const ComparisonRow& batch = emitted(order, Task::dense, Form::batch, points);
            same(emitted(order, Task::dense, Form::scalar, points), batch);
            same(emitted(order, Task::grid, Form::grid, points), batch);
        }
        // starts differ by a tenth, and phases by anything
        const ComparisonRow& members = emitted(order, Task::ensemble, Form::ensemble, 1);
        const ComparisonRow& along = emitted(order, Task::dense, Form::batch, 20000);
        EXPECT_GT(members.max_error[0], 0);
        EXPECT_LT(members.max_error[0], 2 * along.max_error[0]);
    }
}

void SlowCompare::check_rivals_are_tuned_to_the_accuracy_of_each_order() const {
    const Comparison& c = compared();
    ASSERT_EQ(c.by_eps.size(), 2U);
    ASSERT_EQ(c.by_eps.front().tasks.size(), 2U * (1 + 2 * 2 + 1));
    std::map<std::string, double> loosest;
    for (const BreakEven& b : c.by_eps.front().tasks) {
        ASSERT_EQ(b.rivals.size(), rivals);
        double best = b.emitted_seconds;
        for (const RivalAtEqualAccuracy& r : b.rivals) {
            ASSERT_TRUE(r.seconds.has_value()) << r.method;
            EXPECT_DOUBLE_EQ(*r.ratio, *r.seconds / b.emitted_seconds);
            EXPECT_LE(r.error_ratio, 1);
            EXPECT_GT(r.error_ratio, 0.1) << r.method << " is tuned";
            EXPECT_GE(r.spread.high, r.spread.low);
            best = std::min(best, *r.seconds);
            if (b.order == 1) loosest[r.method] = r.tolerance;
            if (b.order == 3) {
                EXPECT_LT(r.tolerance, loosest[r.method]);
            }
        }
        const bool wins = b.winner == "emitted";
        EXPECT_EQ(wins, best == b.emitted_seconds) << "the winner is the fastest";
        EXPECT_EQ(wins, b.points.has_value());
        if (wins) {
            EXPECT_LE(*b.points, static_cast<double>(b.measured_points));
        }
    }
    // of the members, errors of the rivals are those that they were tuned to, or near
    const double own = emitted(3, Task::dense, Form::batch, 20000).max_error[0];
    for (const ComparisonRow& row : c.rows)
        if (row.task == Task::ensemble && !row.is_emitted()) {
            EXPECT_LT(row.max_error[0], 1e5 * own) << row.method;
        }
}

void SlowCompare::check_json_and_csv() const {
    const auto json = to_json(compared());
    EXPECT_EQ(json["schema"], "resonform.comparison/1");
    EXPECT_EQ(json["eps"], 0.01);
    for (const char* key : {"method", "setting", "task", "form", "order", "points", "members", "rhs",
                            "max_error", "seconds", "construction_seconds"})
        EXPECT_TRUE(json["rows"][0].contains(key)) << key;
    EXPECT_EQ(json["rows"][0]["rhs"], nullptr);
    EXPECT_EQ(json["rows"].back()["rhs"], "compiled");
    EXPECT_EQ(json["rows"].back()["form"], nullptr);
    EXPECT_EQ(json["prepared"][1]["order"], 3);
    EXPECT_GT(json["prepared"][1]["compilation_seconds"], 0);
    EXPECT_GT(json["prepared"][1]["derivation_seconds"], 1);
    EXPECT_EQ(test::undocumented(json, test::file_formats()), std::set<std::string>());
    ASSERT_EQ(json["break_even"].size(), 4U);
    for (const auto& [task, even] : json["break_even"].items()) {
        EXPECT_EQ(even["order"], 3) << task;
        if (task == "dense") {
            EXPECT_EQ(even["measured_points"], 20000);
        }
    }
    EXPECT_EQ(json["by_eps"][0]["break_even"], json["break_even"]);
    EXPECT_EQ(json["by_eps"][1]["eps"], 0.02);
    EXPECT_EQ(json["by_eps"][0]["all"].size(), 12U);
    EXPECT_EQ(json["rows"].back()["eps"], 0.02);

    const std::string csv = to_csv(compared());
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + static_cast<long>(compared().rows.size()));
    EXPECT_NE(
        csv.find("construction_seconds,max_error psi,max_error x,max_error y,failure\n0.01,emitted,order "
                 "1,final,final,1,1,1,1,,"),
        std::string::npos)
        << csv.substr(0, 400);
}

void SlowCompare::check_errors_fall_with_the_tolerance() const {
    const Comparison& c = compared();
    for (const char* method : {"CVODE Adams", "odeint dopri5", "odeint Bulirsch-Stoer", "Taylor"}) {
        std::vector<double> errors;
        for (const ComparisonRow& row : c.rows)
            if (row.method == method && row.task == Task::dense && row.points == 20000 &&
                row.eps == c.by_eps.front().eps)
                errors.push_back(row.max_error[0]);
        EXPECT_GT(errors.front(), 1e6 * errors.back()) << method;
    }
}

TEST_F(SlowCompare, OfThePendulum) {
    check_rows_of_every_task_and_form();
    check_forms_have_the_same_errors();
    check_rivals_are_tuned_to_the_accuracy_of_each_order();
    check_json_and_csv();
    check_errors_fall_with_the_tolerance();
}

// From the normal form of a higher order the same code as from its own.
TEST(SolutionsOfLowerOrder, AreThoseOfTheirOwnDerivation) {
    for (const auto& [system, name] :
         {std::pair("almost_holonomic_pendulum", "third_order"), std::pair("henon_heiles", "third_order")}) {
        const Scene scene = test::scene_of(system, name);
        Scene lower = scene;
        lower.order = 2;
        const ProgramOptions as_emitted{true, false, true};
        EXPECT_EQ(emit_cpp(build_program(lower_solution(lower, test::solution_of(scene)), lower, as_emitted)),
                  emit_cpp(build_program(test::solution_of(lower), lower, as_emitted)))
            << system;
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
    options.points = {2000};
    options.orders = {1, 2};
    options.repetitions = 1;
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
    ASSERT_EQ(c.rows.size(), 2U); // two tasks; order 1 has no corrections that could grow too large
    for (const ComparisonRow& row : c.rows) {
        EXPECT_EQ(row.method, "emitted");
        EXPECT_EQ(row.order, 2);
        EXPECT_EQ(row.failure, "outside_domain: x");
        EXPECT_TRUE(std::isnan(row.max_error.at(0)));
    }
    ASSERT_EQ(c.by_eps.at(0).tasks.size(), 4U);
    for (const BreakEven& b : c.by_eps.at(0).tasks) EXPECT_EQ(b.failure, "outside_domain: x");
    EXPECT_NE(to_text(c).find("dense, 2000 points: the emitted evaluator has no numbers (outside_domain: x)"),
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
TEST(CompareText, SaysThatAnEvaluatorWithoutNumbersIsNoWinner) {
    ComparisonRow emitted;
    emitted.method = "emitted";
    emitted.form = Form::scalar;
    emitted.max_error = {std::nan("")};
    emitted.seconds.median = 1e-6;
    emitted.failure = "outside_domain: x";
    Comparison c;
    c.by_eps = {{Rational(1) / 10, {break_even({emitted}, {{"Taylor", 1e-3}}, {})}}};
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
    EXPECT_NE(text.find("Taylor 1 s (0.5 times)\n    the emitted evaluator loses, Taylor is the fastest\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("Taylor 4 s (2 times)\n    the emitted evaluator is the fastest\n"),
              std::string::npos)
        << text;
}

} // namespace
} // namespace resonform
