// SPDX-License-Identifier: GPL-3.0-or-later
// A system that is defined for 0 < tau < 2 only, and scenes that leave it.
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

namespace {

const std::string system_file = "[system]\n"
                                "name = \"bounded\"\n"
                                "[parameters]\n"
                                "k = {}\n"
                                "[variables]\n"
                                "x = { role = \"fast\" }\n"
                                "tau = { role = \"slow\" }\n"
                                "[domain]\n"
                                "positive = [\"tau\", \"2 - tau\", \"k - 1\"]\n"
                                "[equations]\n"
                                "x = \"x'' + tau*(2 - tau)*x + k*x^3/tau = 0\"\n"
                                "tau = \"tau' = eps\"\n";

std::string scene_of(const std::string& tau, const std::string& interval, const std::string& k = "2") {
    return "order = 2\n[fix]\nk = " + k + "\n[start]\ntau = " + tau +
           "\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = \"" + interval + "\"\n";
}

// On a slow machine a line says how long the evaluator took.
std::string message(const Outcome& outcome) {
    const std::size_t at = outcome.err.find("resonform: ");
    return at == std::string::npos ? outcome.err : outcome.err.substr(at);
}

class DomainOfASystem : public testing::Test {
protected:
    DomainOfASystem() { write(scratch_.path() / "systems/bounded/system.toml", system_file); }

    Outcome said(const std::string& command, const std::string& scene_text, const std::string& options = "") {
        write(scratch_.path() / "systems/bounded/scenes/s.toml", scene_text);
        return run("resonform " + command + " systems/bounded/scenes/s.toml " + options, scratch_.path());
    }
    Scratch scratch_;
};

} // namespace

TEST_F(DomainOfASystem, EvaluateAnswersPointByPoint) {
    const Outcome outcome = said("evaluate", scene_of("1", "3/eps"), "--eps 0.1 --t 0,5,8,9.9,10.1,25,31");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(message(outcome), "resonform: outside_domain: 2*sqrt(tau)*sqrt(-tau + 2)\n"
                                "resonform: outside_interval: t\n");
    std::string statuses;
    for (std::size_t at = 0, end; (end = outcome.out.find('\n', at)) != std::string::npos; at = end + 1)
        statuses += outcome.out.substr(0, end).substr(outcome.out.rfind(',', end) + 1) + " ";
    // At t = 9.9 the frequency, sqrt(0.0199), changes too fast already.
    EXPECT_EQ(statuses, "status ok ok ok outside_domain outside_domain outside_domain outside_interval ")
        << outcome.out;
    EXPECT_NE(outcome.out.find("\n25,,outside_domain\n"), std::string::npos) << outcome.out;
}

// Not where that of the smallest eps of the ladder does.
TEST_F(DomainOfASystem, EvaluateEndsWithTheIntervalOfItsEps) {
    for (const auto& [interval, times] :
         {std::pair("2", "1.875,2.125"), std::pair("0.01/eps^2", "0.875,1.125")}) {
        const Outcome outcome =
            said("evaluate", scene_of("0.5", interval), std::string("--eps 0.1 --t ") + times);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const std::string inside = std::string(times).substr(0, 5), beyond = std::string(times).substr(6);
        EXPECT_NE(outcome.out.find(",ok\n" + beyond + ",,outside_interval\n"), std::string::npos)
            << outcome.out;
        EXPECT_NE(outcome.out.find("\n" + inside + ","), std::string::npos) << outcome.out;
    }
}

TEST_F(DomainOfASystem, VerifySaysWhereTheMotionLeaves) {
    for (const char* command : {"verify", "compare"}) {
        const Outcome outcome = said(command, scene_of("0.5", "3/eps"));
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(
            outcome.err,
            "resonform: systems/bounded/scenes/s.toml:9:13: verify.interval: the motion stays in the "
            "declared domain over the whole interval of verification\n"
            "    interval = \"3/eps\"\n"
            "                ^\n"
            "  found: interval = 3/eps, but at t = 7.5 (eps = 1/5) tau = 2 leaves 2 - tau > 0, declared in "
            "systems/bounded/system.toml:9\n"
            "  hint:  end the interval before eps*t = 1.5, or start elsewhere\n")
            << command;
    }
}

TEST_F(DomainOfASystem, AMotionStartsWithin) {
    const auto expect = [&](const std::string& text, const std::string& place, const std::string& condition,
                            const std::string& found) {
        const Outcome outcome = said("evaluate", text, "--eps 0.1 --t 0");
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(
            outcome.err.compare(0, 61 + place.size(),
                                "resonform: systems/bounded/scenes/s.toml:" + place + ": a motion starts in"),
            0)
            << outcome.err;
        EXPECT_NE(outcome.err.find("the declared domain, where " + condition + " > 0\n"), std::string::npos)
            << outcome.err;
        EXPECT_NE(outcome.err.find("\n  found: " + found +
                                   "\n  hint:  give a value inside, or correct [domain] in "
                                   "systems/bounded/system.toml:9\n"),
                  std::string::npos)
            << outcome.err;
    };
    expect(scene_of("2.5", "0.1/eps"), "5:7: start.tau", "2 - tau", "tau = 2.5");
    expect(scene_of("1", "0.1/eps", "1"), "3:5: fix.k", "k - 1", "k = 1");
}

// At a resonance the map that was divided by zero leads nowhere: what is named is the divisor.
TEST_F(DomainOfASystem, AVanishingDivisorIsNamed) {
    const auto outcome = [&](const std::string& declared, const std::string& rates, const std::string& at) {
        write(scratch_.path() / "systems/resonant/system.toml",
              "[system]\nname = \"resonant\"\n" + declared +
                  "[equations]\nx = \"x'' + x + x*y = 0\"\ny = " + "\"y'' + (2*s)^2*y + x^2 = 0\"\n" + rates);
        write(scratch_.path() / "systems/resonant/scenes/s.toml",
              "order = 2\n" + at + "x = \"eps\"\n\"x'\" = 0\ny = \"eps/2\"\n\"y'\" = 0\n");
        return message(
            run("resonform evaluate systems/resonant/scenes/s.toml --eps 0.1 --t 0,1", scratch_.path()));
    };
    const std::string fast = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n";
    const std::string slow = fast + "s = { role = \"slow\", positive = true }\n";
    EXPECT_EQ(outcome(slow, "s = \"s' = eps\"\n", "[start]\ns = 1\n"),
              "resonform: outside_domain: -(s - 1)\n");
    EXPECT_EQ(outcome("[parameters]\ns = { positive = true }\n" + fast, "",
                      "[fix]\ns = \"1 + 1/10000000\"\n[start]\n"),
              "resonform: outside_domain: -2*(s - 1)\n");
    // Away from it, a start that is too large is named by its variable.
    EXPECT_EQ(outcome(slow, "s = \"s' = eps\"\n", "[start]\ns = 1.001\n"), "resonform: outside_domain: x\n");
}

} // namespace resonform::test
