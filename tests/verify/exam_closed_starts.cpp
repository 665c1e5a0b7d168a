// SPDX-License-Identifier: GPL-3.0-or-later
// Closed solutions start where their map is close to the identity, from values as from constants; what they
// are held against says the same.
#include "emit/program/build_program.hpp"
#include "own_system.hpp"
#include "support/program.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/symbolic/evaluator.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace resonform {
namespace {

class ClosedFrom : public test::OwnSystem {
protected:
    struct Answer {
        Status status = Status::ok;
        std::string why;
        double x = 0; // the first output at t = 0
    };

    // At t = 0, interpreted; what emitted code is held against says the same, and that code if it is
    // `compiled`.
    Answer answer(const std::string& system, const std::string& scene, double eps, bool compiled = false) {
        const Scene read = written(system, scene);
        const Solution solution = test::solution_of(read);
        const auto program = std::make_shared<const Program>(build_program(solution, read));
        const std::vector<double> start = default_start<double>(*program, eps, {});
        const Interpreter<double> interpreter(program, eps, {}, start, 1);
        std::vector<double> values(program->outputs.size());
        Answer found;
        found.status = interpreter.call(0, values);
        found.why = interpreter.why(found.status);
        found.x = values[0];

        SymbolicInputs inputs = test::symbolic_inputs(*program, eps, start, 1);
        for (const StartValue& given : read.start)
            if (inputs.start.emplace(given.name, Wide(untaken_)).second) inputs.untaken.insert(given.name);
        const SymbolicEvaluator exact(std::make_shared<const SymbolicSolution>(solution, read), inputs,
                                      Wide(eps));
        EXPECT_EQ(exact.construction_status(), found.status) << system << scene;

        if (!compiled) return found;
        const Evaluator<double> emitted(
            EvaluatorLibrary::build(*program, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache", {}),
            eps, {}, start, 1.0);
        EXPECT_EQ(emitted.call(0.0, values.data()), found.status) << system << scene;
        return found;
    }
    static void expect_outside(const Answer& found, const std::string& why) {
        EXPECT_EQ(found.status, Status::outside_domain) << found.x;
        EXPECT_EQ(found.why, why);
    }

private:
    static constexpr double untaken_ = 1e6;
};
using SlowClosedFrom = ClosedFrom;

std::string duffing(const std::string& frequency) {
    return "[parameters]\nd = { positive = true }\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
           "x = \"x'' + " +
           frequency + "*x + x^3 = 0\"\n";
}
std::string started(const std::string& d, const std::string& start) {
    return "order = 3\n[fix]\nd = " + d + "\n[start]\n" + start;
}
std::string constants(const std::string& amplitude) {
    return "amplitude.x = " + amplitude + "\nphase.x = 0\n";
}
std::string values(const std::string& x) { return "x = \"" + x + "\"\n\"x'\" = 0\n"; }

// The correction is 1/32 of eps^2 amplitude^2, over the square of the frequency.
TEST_F(ClosedFrom, AnAmplitudeBeyondTheSeriesHasAStatus) {
    expect_outside(answer(duffing("d^2"), started("1", constants("100")), 0.1, true), "x");
    expect_outside(answer(duffing("d^2"), started("1", values("100*eps")), 0.1, true), "x");
    for (const std::string& start : {constants("2"), values("2*eps")})
        EXPECT_NEAR(answer(duffing("d^2"), started("1", start), 0.1).x, 0.2, 2e-3);
}

TEST_F(ClosedFrom, ADivisorThatIsTooSmallHasAStatus) {
    for (const std::string& start : {constants("1"), values("eps")}) {
        expect_outside(answer(duffing("d^2"), started("1e-12", start), 0.01), "2*d");
        expect_outside(answer(duffing("d^2"), started("1e-3", start), 0.01), "x");
        EXPECT_EQ(answer(duffing("d^2"), started("1e-12", start), 1e-14).status, Status::ok);
    }
}

// Amplitudes follow from primitives without additive constants: 1 - eps C^2 xi/8 is a series where xi is of
// the order of 1.
TEST_F(ClosedFrom, AFactorOfTheAmplitudeThatIsNoSeriesHasAStatus) {
    const std::string system = "[variables]\nxi = { role = \"slow\", positive = true }\n"
                               "x = { role = \"fast\" }\n[equations]\nxi = \"xi' = eps\"\n"
                               "x = \"x'' + x + (1 + 1/xi^2)*x^2*x' = 0\"\n";
    const auto from = [&](const std::string& xi, const std::string& start) {
        return answer(system, "order = 2\n[start]\nxi = " + xi + "\n" + start, 0.01);
    };
    expect_outside(from("1e4", constants("1")), "x");
    expect_outside(from("1e4", values("eps")), "x");
    for (const std::string& start : {constants("1"), values("eps")})
        EXPECT_EQ(from("2", start).status, Status::ok);
}

// The inverse map of the oscillator still leads back, to a half; that of the drift does not.
TEST_F(ClosedFrom, ADriftFromItsValueIsGivenBack) {
    const std::string system = "[parameters]\nd = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                               "X = { role = \"drift\" }\n[equations]\nx = \"x'' + x + d*x^2 = 0\"\n"
                               "X = \"X' = x*x' + x^2*x'\"\n";
    const auto from = [&](const std::string& d) {
        return answer(system,
                      "order = 2\noutputs = [\"X\"]\n[fix]\nd = " + d +
                          "\n[start]\nx = \"eps\"\n\"x'\" = \"eps/2\"\nX = 0\n",
                      0.01);
    };
    EXPECT_NEAR(from("1").x, 0, 1e-6);
    expect_outside(from("40"), "X");
}

// The constant of d and the course of its mean, eps a^2 sqrt(s), cancel at the start; from x' = 0, what the
// map adds to d is less than a rounding of these. With 5 s^2 - 1 that course, s^(5/2) - s^(1/2), cancels by
// itself.
TEST_F(ClosedFrom, ADriftIsGivenBackWithinTheRoundingOfItsTerms) {
    for (const std::string rate : {"x^2", "(5*s^2 - 1)*x^2"}) {
        const std::string system =
            "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\", positive = true }\n"
            "d = { role = \"drift\" }\n[equations]\nx = \"x'' + s*x + x^3 = 0\"\ns = \"s' = eps\"\n"
            "d = \"d' = " +
            rate + "\"\n";
        for (const double eps : {1e-6, 1e-7, 1e-8, 3e-9, 1e-10, 1e-12}) {
            const Answer found = answer(system,
                                        "order = 3\noutputs = [\"d\"]\n[start]\nx = \"3/10*eps\"\n"
                                        "\"x'\" = 0\ns = 1\nd = 0\n",
                                        eps);
            EXPECT_EQ(found.status, Status::ok) << rate << " " << eps << " " << found.why;
            EXPECT_NEAR(found.x, 0, 1e-14 * eps) << rate << " " << eps;
        }
    }
}

// An oscillator on which no output depends is not asked about; the other one is.
TEST_F(ClosedFrom, WhatNoOutputNeedsIsNotAskedAbout) {
    const std::string system = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                               "x = \"x'' + x + x^3 = 0\"\ny = \"y'' + 2*y + y^3 = 0\"\n";
    const auto from = [&](const std::string& x, const std::string& y) {
        return answer(system,
                      "order = 2\noutputs = [\"x\"]\n[start]\n" + constants(x) + "amplitude.y = " + y +
                          "\nphase.y = 0\n",
                      0.1);
    };
    EXPECT_EQ(from("1", "1000").status, Status::ok);
    expect_outside(from("1000", "1"), "x");
}

// xi + sqrt(1 + xi^2) is 0 in double: at the start, too, it is asinh(xi) that is computed.
TEST_F(ClosedFrom, ALogarithmKeepsItsDigitsAtTheStart) {
    const Answer found =
        answer("[variables]\nxi = { role = \"slow\" }\nX = { role = \"drift\" }\n[equations]\n"
               "xi = \"xi' = eps\"\nX = \"X' = eps/sqrt(1 + xi^2)\"\n",
               "order = 2\n[start]\nxi = -1e12\nX = 1\n", 0.01);
    EXPECT_EQ(found.status, Status::ok) << found.why;
    EXPECT_NEAR(found.x, 1, 1e-14);
}

// Near the end of the domain the constants of the start hold high powers of 2 + tau: written out, 8 + 12 tau
// +
// ..., they lost 11 digits at 2 + tau = 1/1000, and the start was refused at 1/2000.
TEST_F(ClosedFrom, NearTheEndOfTheDomainTheStartKeepsItsDigits) {
    const auto damped = [&](const std::string& tau) {
        return answer("[parameters]\nk = {}\n[variables]\nx = { role = \"fast\" }\n"
                      "tau = { role = \"slow\" }\n[domain]\npositive = [\"2 + tau\"]\n[equations]\n"
                      "x = \"x'' + 2*eps*k*x' + (2 + tau)*x + x^2 - x^3 = 0\"\ntau = \"tau' = eps\"\n",
                      "order = 3\n[fix]\nk = \"1/3\"\n[start]\nx = \"eps\"\n\"x'\" = 0\ntau = \"" + tau +
                          "\"\n",
                      1e-12);
    };
    for (const char* tau : {"-19/10", "-199/100", "-1999/1000", "-3999/2000"}) {
        const Answer found = damped(tau);
        EXPECT_EQ(found.status, Status::ok) << found.why;
        EXPECT_NEAR(found.x, 1e-12, 1e-26) << tau;
    }
}

// What was divided by a divisor that turns nothing within 1/eps cancels against its start value: in double
// 0.02 came out for 0.01005, and 1e-30 made -1e40 of it.
TEST_F(SlowClosedFrom, NothingIsDividedByADivisorThatTurnsNothing) {
    const auto pushed = [](const std::string& frequency) {
        return "[parameters]\nw = { positive = true }\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
               "x = \"x'' + w^2*x = eps^2\"\n|order = 2\n[start]\nx = \"eps\"\n\"x'\" = 0\n[fix]\nw = \"" +
               frequency + "\"\n";
    };
    const std::string driven =
        "[variables]\nx = { role = \"fast\" }\np = { role = \"angle\" }\n[equations]\n"
        "x = \"x'' + x = eps^2*cos(p)\"\np = \"p' = 1 + 1/10^17\"\n|order = 2\n[start]\n"
        "x = \"eps\"\n\"x'\" = 0\np = 0\n";
    const auto asked = [&](const std::string& text, bool compiled) {
        const std::size_t bar = text.find('|');
        return answer(text.substr(0, bar), text.substr(bar + 1), 0.01, compiled);
    };
    for (const char* frequency : {"1/10^9", "1/10^30"}) expect_outside(asked(pushed(frequency), true), "w");
    EXPECT_EQ(asked(driven, false).status, Status::outside_domain);
    for (const char* frequency : {"1/1000", "1/2"}) {
        const Answer found = asked(pushed(frequency), true);
        EXPECT_EQ(found.status, Status::ok) << frequency << " " << found.why;
        EXPECT_NEAR(found.x, 0.01, 1e-10);
    }
}

} // namespace
} // namespace resonform
