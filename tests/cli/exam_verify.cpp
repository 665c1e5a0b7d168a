// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of the command: what a claim beyond the count costs, and what limits leave open.
#include "support/compiler.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace resonform::test {

namespace {

// M = N = 3 guarantees eps^3. For x, what comes next is eps^4; y is exact, as no weight shows before it is
// derived.
class VerifyCommand : public testing::Test {
protected:
    VerifyCommand() {
        write(scratch_.path() / "systems/springs/system.toml",
              "[system]\nname = \"springs\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
              "[equations]\nx = \"x'' + x + x^3 = 0\"\ny = \"y'' + 2*y = 0\"\n");
    }
    // The exit code, and what is said of the output; an empty object if nothing is.
    [[nodiscard]] std::pair<int, nlohmann::json> claiming(const std::string& output, int order,
                                                          const std::string& options = "") {
        write(scratch_.path() / "systems/springs/scenes/s.toml",
              "order = 3\ntruncation = 3\noutputs = [\"" + output +
                  "\"]\n[start]\namplitude.x = 1\nphase.x = 0\namplitude.y = 1\nphase.y = 0\n[verify]\n"
                  "eps = [0.02, 0.01, 0.005]\nclaim = { " +
                  output + " = " + std::to_string(order) + " }\n");
        const Outcome outcome =
            run("resonform verify systems/springs/scenes/s.toml --format json " + options, scratch_.path());
        EXPECT_FALSE(outcome.out.empty()) << outcome.err;
        if (outcome.out.empty()) return {outcome.code, nlohmann::json::object()};
        document_ = nlohmann::json::parse(outcome.out);
        return {outcome.code, document_["outputs"][0]};
    }
    Scratch scratch_;
    nlohmann::json document_; // of the last command
};
using SlowVerifyCommand = VerifyCommand; // a derivation to a higher order

} // namespace

TEST_F(SlowVerifyCommand, AClaimBeyondTheCountIsDerived) {
    const auto [code, met] = claiming("x", 4);
    EXPECT_EQ(code, 0);
    EXPECT_EQ(met["guaranteed_order"], 4);
    EXPECT_EQ(met["verdict"], "pass");
    const auto [code_of_refuted, refuted] = claiming("x", 5);
    EXPECT_EQ(code_of_refuted, 1);
    EXPECT_EQ(refuted["guaranteed_order"], 4);
    EXPECT_EQ(refuted["verdict"], "fail");
    const auto [code_of_exact, exact] = claiming("y", 7);
    EXPECT_EQ(code_of_exact, 0);
    EXPECT_EQ(exact["guaranteed_order"], 7);
    EXPECT_EQ(exact["verdict"], "pass");
}

// The fifth weight has more terms than the third: what the ladder found is not lost with it.
TEST_F(VerifyCommand, WhatLimitsEndIsOpen) {
    const auto [code, open] = claiming("y", 7, "--term-limit 6");
    EXPECT_EQ(code, 1);
    EXPECT_EQ(open["guaranteed_order"], 4) << "the fourth adds nothing";
    EXPECT_EQ(open["verdict"], "undecided");
    EXPECT_EQ(open["found_order"], nullptr);
    EXPECT_EQ(open["ladder"].size(), 3U);
    EXPECT_EQ(
        open["reason"].get<std::string>().substr(0, 93),
        "what comes next cannot be derived: normal form and map have at most 6 terms (weight 5 reached");
}

TEST_F(SlowVerifyCommand, LiesAreCaught) {
    const auto [code, x] = claiming("x", 4, "--liars");
    EXPECT_EQ(code, 0);
    std::map<std::string, int> caught;
    for (const nlohmann::json& lie : document_["liars"]) {
        EXPECT_EQ(lie.size(), 5U);
        if (!lie["caught_by"].is_null()) ++caught[lie["caught_by"].get<std::string>()];
    }
    EXPECT_EQ(caught.size(), 2U) << document_["liars"]; // in a slow flow by its certificate
    EXPECT_GT(caught["certificate"], 0);
    EXPECT_GT(caught["emitted = exact"], 0);
}

TEST_F(SlowVerifyCommand, ErrorsAreEstimatedWithinLimits) {
    const auto [code, x] = claiming("x", 4);
    EXPECT_EQ(code, 0);
    EXPECT_NEAR(x["error_estimate"]["ratio"].get<double>(), 1, 0.1);
    EXPECT_EQ(x["error_estimate"]["next_order"], 4);
    ASSERT_EQ(x["best_order"].size(), 3U);
    EXPECT_EQ(x["best_order"][2]["eps"], 0.005);
    EXPECT_EQ(x["best_order"][2]["order"], 4);
    EXPECT_LT(x["best_order"][2]["accuracy"], x["ladder"][2]["max_error"]);
    const auto [code_of_limited, limited] = claiming("x", 4, "--term-limit 6");
    EXPECT_EQ(code_of_limited, 0);
    EXPECT_EQ(limited["verdict"], "pass");
    EXPECT_EQ(limited["error_estimate"]["ratio"], nullptr);
    EXPECT_EQ(limited["best_order"].size(), 0U);
    EXPECT_EQ(limited["error_estimate"]["reason"].get<std::string>().substr(0, 79),
              "the next weight cannot be derived: normal form and map have at most 6 terms (we");
    const auto [code_of_exact, exact] = claiming("y", 4);
    EXPECT_EQ(code_of_exact, 0);
    EXPECT_EQ(exact["error_estimate"]["next_order"], nullptr);
    EXPECT_EQ(exact["error_estimate"]["ladder"].size(), 0U);
}

// One coefficient of the phase is edited by 10^-12 of itself: no ladder sees it.
TEST_F(SlowVerifyCommand, AnEditedCoefficientHasExitCodeOne) {
    const std::string from = "Number(3) / Number(8)";
    const auto [honest, met] = claiming("x", 4);
    EXPECT_EQ(honest, 0);
    const OtherCompiler liar(
        editing_compiler(scratch_.path() / "liar.sh", from, "Number(3000000000003) / Number(8000000000000)"));
    const auto [code, edited] = claiming("x", 4);
    EXPECT_EQ(code, 1);
    EXPECT_EQ(edited["verdict"], "pass");
    EXPECT_EQ(document_["emitted_equals_symbolic"]["verdict"], "fail");
}

} // namespace resonform::test
