// SPDX-License-Identifier: GPL-3.0-or-later
// A point of a sweep over errors has the numbers that verify has for a scene with the same arguments; a point
// of one over digits is held against 50 of them.
#include "emit/program/build_program.hpp"
#include "own_system.hpp"
#include "verify/sweep/errors.hpp"
#include "verify/sweep/stability.hpp"

#include <cmath>

namespace resonform {
namespace {

constexpr const char* spring = "[parameters]\nk = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                               "[equations]\nx = \"x'' + x + k*x^3 = 0\"\n";

// Both rows of all points: T and x.
struct Swept {
    std::vector<double> numbers;
    std::vector<unsigned char> status;
    [[nodiscard]] double end(std::size_t i) const { return numbers[4 * i]; }
    [[nodiscard]] double error(std::size_t i) const { return numbers[4 * i + 1]; }
    [[nodiscard]] double order(std::size_t i) const { return numbers[4 * i + 3]; }
    [[nodiscard]] Status answer(std::size_t i) const { return static_cast<Status>(status[2 * i]); }
};

// The six that a sweep keeps.
void expect_digits(double error, const LadderRung& rung) { EXPECT_NEAR(error / rung.max_error, 1, 1e-5); }

class SweepChecks : public test::OwnSystem {
protected:
    static Swept errors(const test::SceneLine& line, const std::vector<std::string>& over) {
        const SweepGrid grid(over, {});
        const SweepErrors compute(std::make_shared<const Program>(build_program(line.solution, line.scene)),
                                  line.scene, line.solution, line.system, grid);
        Swept swept{std::vector<double>(4 * grid.points()), std::vector<unsigned char>(2 * grid.points())};
        compute(0, grid.points(), swept.numbers.data(), swept.status.data());
        return swept;
    }
    // Of the only output, along eps, eps/2, eps/4, eps/8.
    OutputVerdict of_verify(const std::string& fix, const std::string& start, const std::string& ladder) {
        return test::verified(
                   test::line_of(written(spring, "order = 3\n" + fix + "[start]\n" + start +
                                                     "[verify]\ninterval = 5\neps = [" + ladder + "]\n")))
            .outputs.front();
    }
    // T and x of each point; the code that is tried may be that of another solution.
    static Swept digits(const test::SceneLine& line, const Solution& tried,
                        const std::vector<std::string>& over) {
        const SweepGrid grid(over, {});
        const auto program = std::make_shared<const Program>(build_program(tried, line.scene));
        const SweepStability compute(program, line.scene, line.solution, grid,
                                     EvaluatorLibrary::interpreted(program));
        Swept swept{std::vector<double>(2 * grid.points()), std::vector<unsigned char>(grid.points())};
        compute(0, grid.points(), swept.numbers.data(), swept.status.data());
        return swept;
    }
};

TEST_F(SweepChecks, ErrorsAreThoseOfVerify) {
    const OutputVerdict verify =
        of_verify("[fix]\nk = 2\n", "amplitude.x = 0.75\nphase.x = 0\n", "0.125, 0.0625, 0.03125, 0.015625");
    const test::SceneLine line = test::line_of(
        written(spring, "order = 3\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = 5\n"));
    const Swept swept = errors(line, {"k=1,2", "eps=0.125,0.0625", "amplitude.x=0.75"});
    expect_digits(swept.error(2), verify.ladder[0]);
    expect_digits(swept.error(3), verify.ladder[1]);
    EXPECT_LT(swept.error(0), swept.error(2)); // a softer spring
    EXPECT_EQ(swept.order(2), *verify.found_order);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(swept.answer(i), Status::ok);
        EXPECT_EQ(swept.end(i), 5);
    }
}

// A start of x itself is at a point a number, and along the ladder of weight 1.
TEST_F(SweepChecks, StartsOfFastVariablesShrinkDownTheLadder) {
    const OutputVerdict verify =
        of_verify("[fix]\nk = 1\n", "x = \"0.5*eps\"\n\"x'\" = 0\n", "0.125, 0.0625, 0.03125, 0.015625");
    const test::SceneLine line = test::line_of(written(
        spring, "order = 3\n[fix]\nk = 1\n[start]\nx = \"eps\"\n\"x'\" = 0\n[verify]\ninterval = 5\n"));
    const Swept swept = errors(line, {"eps=0.125", "x=0.0625"});
    expect_digits(swept.error(0), verify.ladder[0]);
    EXPECT_EQ(swept.order(0), *verify.found_order);
}

TEST_F(SweepChecks, APointThatCannotBeIntegratedHasAStatus) {
    const test::SceneLine line = test::line_of(
        written("[variables]\ntau = { role = \"slow\" }\nx = { role = \"fast\" }\n"
                "[domain]\npositive = [\"2 - tau\"]\n[equations]\ntau = \"tau' = eps\"\nx = \"x'' + (2 - "
                "tau)*x = 0\"\n",
                "order = 1\noutputs = [\"x\"]\n[start]\ntau = 0\namplitude.x = 1\nphase.x = 0\n"));
    const Swept swept = errors(line, {"eps=0.125", "tau=0,1.5"});
    EXPECT_EQ(swept.answer(0), Status::ok);
    EXPECT_GT(swept.error(0), 0);
    EXPECT_EQ(swept.answer(1), Status::outside_domain); // it leaves the declared domain at t = 4
    EXPECT_TRUE(std::isnan(swept.error(1)));
    EXPECT_TRUE(std::isnan(swept.order(1)));
}

// What is left is rounding, which is no error.
TEST_F(SweepChecks, AnExactFormulaHasNoErrorAndNoOrder) {
    const test::SceneLine line =
        test::line_of(written("[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x = 0\"\n",
                              "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n"));
    const Swept swept = errors(line, {"eps=0.1"});
    EXPECT_EQ(swept.answer(0), Status::ok);
    EXPECT_EQ(swept.error(0), 0);
    EXPECT_TRUE(std::isnan(swept.order(0)));
}

TEST_F(SweepChecks, AnIntervalTooLongToBeIntegratedHasAStatus) {
    const test::SceneLine line =
        test::line_of(written(spring, "order = 3\n[fix]\nk = 1\n[start]\namplitude.x = 1\nphase.x = 0\n"
                                      "[verify]\ninterval = \"1/eps^30\"\neps = [0.5]\n"));
    const Swept swept = errors(line, {"eps=1e-9"});
    EXPECT_EQ(swept.answer(0), Status::outside_interval);
    EXPECT_TRUE(std::isnan(swept.error(0)));
}

TEST_F(SweepChecks, WhatTheFormulaLeavesOutCounts) {
    const auto text = [&](const std::string& term, const std::string& start) {
        const test::SceneLine line = test::line_of(written(
            "[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x^3" + term + " = 0\"\n",
            "order = 1\n[start]\namplitude.x = " + start + "\nphase.x = 0\n"));
        return equations_text(build_program(line.solution, line.scene), line.scene);
    };
    EXPECT_EQ(text("", "1"), text("", "1"));
    EXPECT_NE(text("", "1"), text(" + x^7", "1"));
    EXPECT_NE(text("", "1"), text("", "2"));
}

TEST_F(SweepChecks, DigitsAreHeldAgainstTheExactSolution) {
    const test::SceneLine line =
        test::line_of(written(spring, "order = 3\n[fix]\nk = 1\n[start]\namplitude.x = 1\nphase.x = 0\n"));
    const std::vector<std::string> over{"eps=1e-3,0.1", "amplitude.x=0.5,1e200"};
    const Swept swept = digits(line, line.solution, over);
    for (const std::size_t i : {0U, 2U}) {
        EXPECT_EQ(static_cast<Status>(swept.status[i]), Status::ok);
        EXPECT_GT(swept.numbers[2 * i + 1], 0);
        EXPECT_LT(swept.numbers[2 * i + 1], 4);
    }
    EXPECT_EQ(swept.numbers[0], 1000);
    for (const std::size_t i : {1U, 3U}) {
        EXPECT_NE(static_cast<Status>(swept.status[i]), Status::ok);
        EXPECT_TRUE(std::isnan(swept.numbers[2 * i + 1]));
    }

    Solution lie = line.solution; // the first correction with the opposite sign
    lie.outputs.front().value.set(3, -lie.outputs.front().value.part(3));
    const Swept caught = digits(line, lie, over);
    EXPECT_GT(caught.numbers[1], 1e6);
}

} // namespace
} // namespace resonform
