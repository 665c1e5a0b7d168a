// SPDX-License-Identifier: GPL-3.0-or-later
// verify.interval at its limits, and what refuses a whole run: every message names what the user wrote.
#include "support/command.hpp"

#include <nlohmann/json.hpp>

namespace resonform::test {

namespace {

class IntervalCommand : public Command {
protected:
    void scene(const std::string& verify, const std::string& start = "amplitude.x = 1\nphase.x = 0\n",
               const std::string& force = "x^3") const {
        write(scratch_.path() / "systems/d/system.toml",
              "[system]\nname = \"d\"\n[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + " +
                  force + " = 0\"\n");
        write(scratch_.path() / "systems/d/scenes/s.toml",
              "order = 1\n[start]\n" + start + "[verify]\n" + verify);
    }
    [[nodiscard]] Outcome of(const std::string& command, const std::string& options = "") const {
        return said(command + " systems/d/scenes/s.toml " + options);
    }
    // A document of verify whose ladder is empty.
    void expect_open(const std::string& interval, const std::string& end) const {
        scene("interval = \"" + interval + "\"\neps = [0.2, 0.1, 0.05]\n");
        const Outcome outcome = of("verify", "--format json");
        ASSERT_EQ(outcome.code, 1) << interval << outcome.err;
        expect_no_ladder(nlohmann::json::parse(outcome.out), end);
    }
    static void expect_no_ladder(const nlohmann::json& found, const std::string& end) {
        EXPECT_EQ(found["ladder_end"]["eps"], 0.2) << found;
        EXPECT_NE(found["ladder_end"]["reason"].get<std::string>().find(end), std::string::npos) << found;
        EXPECT_EQ(found["outputs"][0]["verdict"], "undecided") << found;
    }
    void expect_complaint(const Outcome& outcome, const std::string& rule) const {
        EXPECT_EQ(outcome.code, 2) << outcome.out << outcome.err;
        EXPECT_NE(outcome.err.find("s.toml:6:13: verify.interval: " + rule + "\n"), std::string::npos)
            << outcome.err;
    }
};

} // namespace

using SlowIntervalCommand = IntervalCommand; // three runs of verify
TEST_F(SlowIntervalCommand, OneThatIsTooLongEndsTheLadder) {
    expect_open("1e300", "the interval is longer than 1e+200 there");
    expect_open("exp(1/eps^2)", "takes more than 2000000 steps");
    expect_open("exp(2400*eps)", "the interval is longer than 1e+200 there");
}

// The phase of 10^40 radians is known to nobody, and no fault of the emitted code.
TEST_F(IntervalCommand, WhereNothingIsComparedThatIsSaid) {
    scene("interval = \"1e40\"\neps = [0.2, 0.1, 0.05]\n");
    const Outcome text = of("verify");
    EXPECT_NE(text.out.find("emitted = symbolic: undecided"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("double      nothing compared: 0 of 10000 points answered with numbers\n"),
              std::string::npos)
        << text.out;
    const Outcome outcome = of("verify", "--format json");
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    const nlohmann::json found = nlohmann::json::parse(outcome.out);
    expect_no_ladder(found, "takes more than 2000000 steps");
    EXPECT_EQ(found["emitted_against_symbolic_ulp"], nullptr);
    const nlohmann::json type = found["emitted_equals_symbolic"]["real_types"][0];
    EXPECT_EQ(type["compared"], 0);
    for (const char* key : {"ulp", "output", "phase_share", "at"}) EXPECT_EQ(type[key], nullptr) << key;
}

TEST_F(IntervalCommand, OneThatIsNoneIsBadInput) {
    for (const auto& [interval, found, rule] :
         {std::tuple("1e-300", "1e-300 at eps = 1/5: 1e-300", "is 1e-200 or longer"),
          std::tuple("exp(-1000/eps)", "exp(-1000/eps) at eps = 1/5: 0", "is 1e-200 or longer"),
          std::tuple("1/(eps - 1/20)", "1/(eps - 1/20) at eps = 1/20: it is none",
                     "is not a positive number"),
          std::tuple("1 - 8*eps", "1 - 8*eps at eps = 1/5: it is none", "is not a positive number")}) {
        scene(std::string("interval = \"") + interval + "\"\neps = [0.2, 0.1, 0.05]\n");
        for (const char* command : {"verify", "stability", "generate"}) {
            const Outcome outcome = of(command);
            expect_complaint(outcome, std::string("the interval of verification ") + rule);
            EXPECT_NE(outcome.err.find(std::string("\n  found: interval = ") + found + "\n"),
                      std::string::npos)
                << outcome.err;
        }
    }
}

// It had been bad_argument: slow_time_end.
TEST_F(IntervalCommand, AnEvaluatorWantsOneWithinBounds) {
    scene("interval = \"exp(1/eps^2)\"\neps = [0.2, 0.1, 0.02]\n");
    const std::string rule = "an evaluator is made for an interval of at most 1e+200";
    for (const Outcome& outcome :
         {of("evaluate", "--eps 0.01 --t 0"), of("compare", "--eps 0.01"), of("stability")})
        expect_complaint(outcome, rule);
    EXPECT_EQ(of("evaluate", "--eps 0.2 --t 0").code, 0);
    scene("interval = \"exp(-10/eps)\"\neps = [0.2, 0.1]\n");
    expect_complaint(of("evaluate", "--eps 0.01 --t 0"), "the interval of verification is 1e-200 or longer");
}

TEST_F(SlowIntervalCommand, CompareHasNoLadderToLeaveAnEpsOutOf) {
    scene("interval = \"1/eps\"\n");
    const Outcome outcome = of("compare", "--eps 1e-12");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("it takes more than 5000000 steps: the first 10000 lead to t = "),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("\n  hint:  shorten verify.interval or take a larger --eps\n"),
              std::string::npos)
        << outcome.err;
}

// The map leads back from no start; tau leaves the domain where the engine does not follow it beforehand.
TEST_F(SlowIntervalCommand, AnEvaluatorThatRefusesSaysWhy) {
    scene("interval = 1\neps = [0.2, 0.1, 0.05]\n", "amplitude.x = 1\nphase.x = 0\n", "10^18*x^2");
    for (const auto& [command, hint] :
         {std::pair("verify", "change the start values or leave eps = 1/5 out of the ladder"),
          std::pair("compare --eps 1/5", "change the start values or take a larger --eps")}) {
        const Outcome refused = of(command);
        EXPECT_EQ(refused.code, 3);
        EXPECT_NE(refused.err.find(std::string("found: outside_domain: x at eps = 1/5\n  hint:  ") + hint),
                  std::string::npos)
            << refused.err;
    }
    scene("interval = \"1.2/eps\"\neps = [0.2, 0.1, 0.05]\n", "amplitude.x = 1\nphase.x = 0\ntau = 0\n");
    write(
        scratch_.path() / "systems/d/system.toml",
        "[system]\nname = \"d\"\n[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n[domain]\n"
        "positive = [\"2 - tau\"]\n[equations]\nx = \"x'' + (3 - tau)*x = 0\"\ntau = \"tau' = eps*(1 + "
        "tau)\"\n");
    const nlohmann::json open = nlohmann::json::parse(of("verify", "--format json").out);
    const std::string reason =
        open.value("outputs", nlohmann::json::array({nlohmann::json::object()}))[0].value("reason",
                                                                                          open.dump());
    EXPECT_EQ(reason.find("the evaluator refuses points of the interval at eps = 0.2 (outside_domain: -tau + "
                          "3 or 2 - tau at t = "),
              0U)
        << reason;
}

TEST_F(IntervalCommand, AnUnknownNameIsOneWhereverItStands) {
    const std::string good = "amplitude.x = 1\nphase.x = 0\n";
    for (const auto& [verify, start] :
         {std::pair(std::string("claim = { q = 2 }\n"), good),
          std::pair(std::string("expect = { q = \"pass\" }\n"), good),
          std::pair(std::string(), good + "q = 1\n"), std::pair(std::string("q = 1\n"), good)}) {
        scene(verify, start);
        EXPECT_EQ(nlohmann::json::parse(of("evaluate", "--eps 0.1 --t 0 --format json").out)["reason"],
                  "name")
            << verify << start;
    }
}

TEST_F(IntervalCommand, AnEmptyValueIsShownWhereItStands) {
    scene("", "x = \"\"\n\"x'\" = 0\n");
    const nlohmann::json found = nlohmann::json::parse(of("evaluate", "--eps 0.1 --t 0 --format json").out);
    EXPECT_EQ(found["key"], "start.x");
    EXPECT_EQ(found["line"], 3);
    EXPECT_EQ(found["column"], 6);
}

} // namespace resonform::test
