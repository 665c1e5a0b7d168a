// SPDX-License-Identifier: GPL-3.0-or-later
// Hostile systems: whatever exact algebra would cost, the command ends in time with one message.
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <string>

namespace resonform::test {

namespace {

std::string system_of(const std::string& variables, const std::string& equations) {
    return "[system]\nname = \"hostile\"\n[parameters]\na = { positive = true }\nb = { positive = true }\n"
           "c = { positive = true }\n[variables]\nx = { role = \"fast\" }\n" +
           variables + "[equations]\n" + equations;
}

std::string with_equation(const std::string& equation) {
    return system_of("tau = { role = \"slow\" }\n", "x = \"" + equation + "\"\ntau = \"tau' = eps\"\n");
}

std::string repeated(int from, int to, const std::string& between, const std::function<std::string(int)>& f) {
    std::string text;
    for (int k = from; k <= to; ++k) text += (k == from ? "" : between) + f(k);
    return text;
}

// Derives the system with the options given; it is the only file beside script and streams. What does not
// end by itself in half a minute ends with 124.
Outcome derive(const std::string& system, const std::string& options) {
    const Scratch scratch;
    write(scratch.path() / "systems/hostile/system.toml", system);
    return run("timeout 30 resonform derive hostile " + options, scratch.path());
}

// Where a derivation of one second stops: done, told to be refused, or told to be bad input.
void expect_an_end(const std::string& name, const std::string& system, const std::string& order) {
    const Outcome outcome = derive(system, "--format json --time-limit 1 --order " + order);
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 2 || outcome.code == 3) << name << " " << outcome.code;
    const bool is_error = outcome.out.find("\"schema\": \"resonform.error/1\"") != std::string::npos;
    EXPECT_EQ(is_error, outcome.code != 0) << name << "\n" << outcome.out.substr(0, 200);
    EXPECT_EQ(outcome.err.find("fault of the engine"), std::string::npos) << name << "\n" << outcome.err;
    if (outcome.code != 0) {
        EXPECT_NE(outcome.err.find("  hint:  "), std::string::npos) << name << "\n" << outcome.err;
    }
}

std::string sum_of_fractions() {
    return repeated(1, 60, " + ", [](int k) {
        const std::string n = std::to_string(k);
        return "1/(" + n + " + " + std::to_string(k * k + 1) + "*a*tau^2 + b^" + std::to_string(k % 5 + 1) +
               " + " + n + "*c)";
    });
}

std::string nested(int depth, const std::string& innermost,
                   const std::function<std::string(const std::string&, int)>& around) {
    std::string text = innermost;
    for (int k = 1; k <= depth; ++k) text = around(text, k);
    return text;
}

std::string nested_roots(int depth) {
    return nested(depth, "tau^2 + a", [](const std::string& inside, int k) {
        return "sqrt(" + inside + " + " + std::to_string(k) + ")";
    });
}

// v_k' = eps f(v_{k-1}'), f nested `depth` deep: put into each other they are `count` times as deep.
std::string chain(int count, int depth) {
    const auto name = [](int k) { return "v" + std::to_string(k); };
    std::string variables, equations = "x = \"x'' + x + eps*v" + std::to_string(count) + "'*x = 0\"\n";
    for (int k = 0; k <= count; ++k) variables += name(k) + " = { role = \"drift\" }\n";
    equations += "v0 = \"v0' = eps*sqrt(1 + a)\"\n";
    for (int k = 1; k <= count; ++k)
        equations += name(k) + " = \"" + name(k) + "' = eps*" +
                     nested(depth, name(k - 1) + "'",
                            [](const std::string& inside, int) { return "sqrt(1 + " + inside + ")"; }) +
                     "\"\n";
    return system_of(variables, equations);
}

const std::string stubborn = with_equation("x'' + x*(" + sum_of_fractions() + ") = 0");

} // namespace

TEST(SlowLimits, HostileAlgebraEnds) {
    for (const std::string order : {"3", "99"}) {
        expect_an_end("sum of fractions", stubborn, order);
        expect_an_end("fractions", with_equation("x'' + x + eps*x*(" + sum_of_fractions() + ") = 0"), order);
        expect_an_end("roots", with_equation("x'' + x*" + nested_roots(40) + " = 0"), order);
        expect_an_end("deep roots", with_equation("x'' + x*" + nested_roots(190) + " = 0"), order);
        expect_an_end("power", with_equation("x'' + x*(1 + a + b)^400 = 0"), order);
        expect_an_end("root of powers", with_equation("x'' + x*((1 + a + b)^60 + (a + c)^60)^(1/2) = 0"),
                      order);
        expect_an_end(
            "sines",
            with_equation(
                "x'' + x + eps*" +
                nested(180, "x", [](const std::string& inside, int) { return "sin(" + inside + " + x)"; }) +
                " = 0"),
            order);
        expect_an_end(
            "long sum",
            with_equation("x'' + x + " +
                          repeated(1, 3000, " + ", [](int k) { return "sin(" + std::to_string(k) + "*x)"; }) +
                          " = 0"),
            order);
        expect_an_end("chain", chain(5, 30), order);
    }
}

TEST(Limits, SubstitutedRatesNestToALimit) {
    const Outcome outcome = derive(chain(40, 190), "");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("at most 1000 levels deep"), std::string::npos) << outcome.err;
}

TEST(Limits, TheMessageNamesTheStepOrTheWeight) {
    const Outcome early = derive(stubborn, "--time-limit 0.3");
    EXPECT_EQ(early.code, 3);
    EXPECT_EQ(early.err, "resonform: --time-limit: a derivation takes at most 0.3 s\n  found: the expansion\n"
                         "  hint:  simplify the system, ask for a lower order, or give --time-limit 3\n");
    // A limit that is over before the program looks at the clock: ten times that would be, too.
    const Outcome at_once = derive(with_equation("x'' + x = 0"), "--time-limit 1e-9");
    EXPECT_EQ(at_once.code, 3);
    const std::string hint = "or give --time-limit ";
    const std::size_t at = at_once.err.find(hint);
    ASSERT_NE(at, std::string::npos) << at_once.err;
    EXPECT_GE(std::stod(at_once.err.substr(at + hint.size())), 1) << at_once.err;
    const std::string pendulum = "x'' + a^2*sin(x) + eps*b*x^2 = 0";
    const Outcome late = derive(with_equation(pendulum), "--order 99 --time-limit 1");
    EXPECT_EQ(late.code, 3);
    EXPECT_NE(late.err.find(" under way\n  hint:  "), std::string::npos) << late.err;
    const Outcome terms = derive(with_equation(pendulum), "--order 30 --term-limit 20");
    EXPECT_EQ(terms.code, 3);
    EXPECT_NE(terms.err.find("resonform: --term-limit: normal form and map have at most 20 terms\n"
                             "  found: weight 5 reached with 22 terms\n"),
              std::string::npos)
        << terms.err;
    EXPECT_EQ(terms.out, "");
    const Outcome memory = derive(with_equation(pendulum), "--order 99 --memory-limit 1");
    EXPECT_EQ(memory.code, 3);
    EXPECT_NE(memory.err.find("--memory-limit: a derivation takes at most 1 MB"), std::string::npos)
        << memory.err;
}

// Actions that drive two frequencies: the inverse map divides by ten combinations of them. Written over one
// denominator, its coefficients would take minutes and more than a gigabyte.
TEST(SlowLimits, TheEvaluatorOfASlowFlowIsAStepOfItsOwn) {
    const Scratch scratch;
    write(scratch.path() / "systems/actions/system.toml",
          "[system]\nname = \"actions\"\n[variables]\nJ = { role = \"slow\", positive = true }\n"
          "K = { role = \"slow\" }\nf = { role = \"angle\" }\ng = { role = \"angle\" }\n[equations]\n"
          "J = \"J' = eps*cos(f)*(1+K) + eps*sin(f-g)\"\nK = \"K' = eps*J*cos(g) + eps*sin(f)^2*J\"\n"
          "f = \"f' = J^2 + eps*sin(g)\"\ng = \"g' = 3 + K + eps*cos(f)*J\"\n");
    write(scratch.path() / "systems/actions/scenes/s.toml",
          "order = 1\noutputs = [\"J\"]\n[start]\nJ = 1\nK = \"1/5\"\nf = \"1/3\"\ng = 1\n");
    const auto evaluated = [&](double limit) {
        return run("resonform evaluate systems/actions/scenes/s.toml --eps 0.01 --t 20 --memory-limit 1000 "
                   "--time-limit " +
                       std::to_string(limit),
                   scratch.path());
    };
    const Outcome done = evaluated(60);
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_NEAR(std::stod(done.out.substr(done.out.find("\n20,") + 4)), 1.0028991538, 1e-3) << done.out;
    const std::string step =
        "found: weight 3 reached and certified, the evaluator, from the start values on, "
        "under way\n";
    std::string said;
    for (double limit = 0.1; limit < 60 && said.find(step) == std::string::npos; limit *= 1.4)
        said = evaluated(limit).err;
    EXPECT_NE(said.find(step), std::string::npos) << said;
}

// However quick it is: the memory is looked at when all is derived.
TEST(Limits, OfMemoryDoNotDependOnTheClock) {
    for (int n = 0; n < 5; ++n)
        EXPECT_EQ(derive(with_equation("x'' + x + x^3 = 0"), "--memory-limit 1").code, 3);
}

TEST(Limits, AreNumbersOrNone) {
    for (const char* option : {"--time-limit", "--memory-limit", "--term-limit"})
        for (const char* value : {"0", "-1", "nan", "inf", "1x", "nome"}) {
            const Outcome outcome = derive(with_equation("x'' + x = 0"), std::string(option) + " " + value);
            EXPECT_EQ(outcome.code, 2) << option << " " << value;
            const std::string rule = option == std::string("--term-limit")
                                         ? "whole number >= 1"
                                         : "decimal number or a fraction > 0";
            EXPECT_NE(outcome.err.find("must be a " + rule + ", or none"), std::string::npos) << outcome.err;
        }
    EXPECT_EQ(
        derive(with_equation("x'' + x = 0"), "--time-limit none --memory-limit none --term-limit none").code,
        0);
}

// The default action of a signal ends the program, in the middle of a derivation too.
TEST(Limits, AnInterruptLeavesNothingBehind) {
    const Scratch scratch;
    write(scratch.path() / "systems/hostile/system.toml", stubborn);
    const Outcome outcome =
        run("timeout --preserve-status -s INT 0.5 resonform derive hostile >out", scratch.path());
    EXPECT_EQ(outcome.code, 128 + SIGINT) << outcome.err;
    EXPECT_EQ(read(scratch.path() / "out"), "");
}

} // namespace resonform::test
