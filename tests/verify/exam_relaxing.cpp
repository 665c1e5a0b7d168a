// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes along slow variables that relax: nothing of them is left to be integrated but phases.
#include "emit/program/build_program.hpp"
#include "own_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace resonform {
namespace {

class Relaxing : public test::InterpretedSystem {
protected:
    // Passes its ladder, is held against 50 digits, and no more variables than these are integrated.
    void expect_passes(const std::string& system, const std::string& scene,
                       const std::vector<std::string>& integrated) {
        const Scene read = written(system, scene);
        std::vector<std::string> names;
        for (const ProgramFlow& variable : build_program(test::solution_of(read), read).flow)
            names.push_back(variable.name);
        EXPECT_EQ(names, integrated);
        expect_pass(read);
    }
};

const std::string start_constants = "amplitude.x = 1\nphase.x = 0\n";
const std::string ladder_text = "[verify]\neps = [\"1/40\", \"1/80\", \"1/160\"]\ninterval = \"1/eps\"\n";

TEST_F(Relaxing, AStiffnessThatFadesOrGrows) {
    for (const char* law : {"-2*eps*s", "eps*s/2"})
        expect_passes("[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\", positive = true }\n"
                      "[equations]\nx = \"x'' + s*x + x^3 = 0\"\ns = \"s' = " +
                          std::string(law) + "\"\n",
                      "order = 2\n[start]\n" + start_constants + "s = 1\n" + ladder_text, {});
}

TEST_F(Relaxing, TwoVariablesBesideAModeThatDecays) {
    expect_passes(
        "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\", weight = 0 }\n"
        "s = { role = \"slow\" }\nu = { role = \"slow\" }\n"
        "[domain]\npositive = [\"2 + s\"]\n"
        "[equations]\nx = \"x'' + (2 + s)*x + x^3 = 0\"\ny = \"y' = -(2 + s)*y + eps*u\"\n"
        "s = \"s' = eps*(1 - 2*s)\"\nu = \"u' = -eps*u/3\"\n",
        "order = 2\noutputs = [\"x\", \"y\", \"s\", \"u\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\ny = 1\n"
        "s = 0\nu = 2\n" +
            ladder_text,
        {"u_x", "v_x"});
}

const std::string cooling = "[parameters]\nb = { positive = true }\n"
                            "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
                            "[domain]\npositive = [\"2 + s\"]\n"
                            "[equations]\nx = \"x'' + (2 + s)*x + x^3 = 0\"\ns = \"s' = eps*(1 - b*s)\"\n";
std::string cooling_at(const std::string& b) {
    return "order = 1\noutputs = [\"s\", \"x\"]\n[fix]\nb = \"" + b + "\"\n[start]\n" + start_constants +
           "s = 1\n";
}

TEST_F(Relaxing, KeepsItsDigitsWhereLittleHasHappened) {
    for (const double T : {1e-18, 1e-9, 1e-3, 1.0}) {
        const Answer slow = at(cooling, cooling_at("1/10^12"), 1e-3, T / 1e-3);
        EXPECT_EQ(slow.status, Status::ok);
        EXPECT_NEAR(slow.values[0], 1 + (1 - 1e-12) * T * (1 - 0.5e-12 * T), 4e-16 * (1 + T));
    }
    EXPECT_NEAR(at(cooling, cooling_at("2"), 1e-3, 700).values[0], 0.5 + 0.5 * std::exp(-1.4), 4e-16);
}

// What is over so soon may lie between all nodes of an integral.
TEST_F(Relaxing, EndsAfterManyRelaxations) {
    EXPECT_EQ(at(cooling, cooling_at("1000"), 1e-6, 4e6).status, Status::ok);
    const Answer later = at(cooling, cooling_at("1000"), 1e-6, 4.2e6);
    EXPECT_EQ(later.status, Status::outside_domain);
    EXPECT_EQ(later.why, "s");
}

// So does an amplitude; its transient is in the rate of the phase, which long intervals see as short ones do.
TEST_F(Relaxing, DampingEndsLikewise) {
    const Scene scene =
        written("[parameters]\nd = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                "[equations]\nx = \"x'' + 2*eps*d*x' + x + x^3 = 0\"\n",
                "order = 2\n[fix]\nd = 1000\n[start]\n" + start_constants);
    const double eps = 1e-3;
    const auto at = [&, program = test::program_of(scene)](double t, double slow_time_end, Status expected) {
        const Interpreter<double> evaluator(program, eps, {}, {}, slow_time_end);
        std::vector<double> values;
        EXPECT_EQ(evaluator.call(t, values), expected) << t;
        EXPECT_STREQ(evaluator.why(Status::outside_domain), slow_time_end > 5 ? "exp(-d*T)" : "");
        return values.front();
    };
    for (const double t : {0.25, 1.0, 3.0})
        EXPECT_NEAR(at(t, 100, Status::ok), at(t, eps * t, Status::ok), 1e-15 * eps) << t;
    at(4090, 100, Status::ok);
    at(4100, 100, Status::outside_domain);
}

} // namespace
} // namespace resonform
