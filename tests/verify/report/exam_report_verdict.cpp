// SPDX-License-Identifier: GPL-3.0-or-later
// The first screen of a report: what is claimed, whether it holds, who is faster, where it breaks.
#include "model/files/read_scene.hpp"
#include "verify/report/sections.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace resonform::report {

namespace {

class ReportVerdict : public testing::Test {
protected:
    ReportVerdict()
        : scene_(read_scene(systems() / "almost_holonomic_pendulum/scenes/as_published.toml", systems())) {
        findings_.scene = &scene_;
        findings_.verification.conditions.interval = "1/eps";
        findings_.comparison.by_eps = {{Rational(1) / 1000, {}}};
        findings_.stability.verdict = Verdict::pass;
    }

    static std::filesystem::path systems() { return std::filesystem::path(RESONFORM_SOURCE_DIR) / "systems"; }

    // psi as published: the slope is 3.
    static OutputVerdict third_order() {
        OutputVerdict o;
        o.name = "psi";
        o.claimed_order = 4;
        o.found_order = 3;
        o.slope = 2.9996;
        o.constant = 2.5328e-3;
        o.verdict = o.expected = Verdict::fail;
        o.reason = "told already";
        return o;
    }

    std::vector<Statement> said() {
        return std::get<Statements>(verdict_section(findings_).blocks.front()).all;
    }
    Statement first(OutputVerdict o) {
        findings_.verification.outputs = {std::move(o)};
        return said().front();
    }
    // Of a run at the end, with one rival.
    Statement task(double ratio) {
        BreakEven even;
        even.order = 3;
        even.emitted_seconds = 1;
        even.rivals = {{"Taylor", ratio, ratio}, {"slow", 100.0, 100.0}, {"never"}};
        findings_.comparison.by_eps.front().tasks = {even};
        return said().front();
    }

    Scene scene_;
    Findings findings_;
};

} // namespace

TEST_F(ReportVerdict, SaysWhatARefereeCanQuote) {
    const Statement fails = first(third_order());
    EXPECT_EQ(fails.word, "fail");
    EXPECT_EQ(fails.text,
              "ψ is third order, not fourth as claimed on 0 ≤ t ≤ 1/ε: slope 3.000, constant 2.533·10⁻³ "
              "(max |Δψ| → 2.533·10⁻³ ε³); as expected");
    OutputVerdict surprise = third_order();
    surprise.expected = Verdict::pass;
    EXPECT_NE(first(surprise).text.find("; NOT as expected, which is: pass"), std::string::npos);
    OutputVerdict holds = third_order();
    holds.claimed_order = 3;
    holds.verdict = holds.expected = Verdict::pass;
    holds.reason.clear();
    EXPECT_EQ(first(holds).text.rfind("ψ is third order as claimed on 0 ≤ t ≤ 1/ε: slope 3.000", 0), 0U);
    holds.claimed_order = 2;
    EXPECT_EQ(first(holds).text.rfind("ψ is third order, more than the claimed second on", 0), 0U);
    OutputVerdict open = third_order();
    open.found_order.reset();
    open.verdict = Verdict::undecided;
    open.reason = "fewer than 3 usable rungs of eps";
    EXPECT_EQ(first(open).text,
              "ψ is claimed to be fourth order on 0 ≤ t ≤ 1/ε: fewer than 3 usable rungs of ε; "
              "NOT as expected, which is: fail");
}

TEST_F(ReportVerdict, SaysWhoIsFaster) {
    const Statement wins = task(35);
    EXPECT_EQ(wins.word, "wins");
    EXPECT_EQ(
        wins.text,
        "One point at the end of the run, ε = 0.001: 1 s; the best rival, Taylor, takes 35 times as long "
        "for the same accuracy");
    const Statement loses = task(0.25);
    EXPECT_EQ(loses.word, "loses");
    EXPECT_NE(loses.text.find("Taylor reaches the same accuracy in 0.25 of the time"), std::string::npos)
        << loses.text;
}

TEST_F(ReportVerdict, SaysWhereItBreaks) {
    findings_.stability.verdict = Verdict::fail;
    findings_.stability.rule = "no error is above 16 ulp";
    findings_.stability.worst = {{"x", 2, 0, 0, "", {}}, {"psi", 99, 1e7, 1, "eps", {}}};
    findings_.stability.cases = 300;
    findings_.stability.refused = 66;
    bool told = false;
    for (const Statement& s : said())
        told = told || (s.word == "fail" &&
                        s.text.find("ψ is off by 99 ulp at worst, where 1 are unavoidable; 66 of 300") !=
                            std::string::npos);
    EXPECT_TRUE(told);
}

TEST_F(ReportVerdict, WhatIsLeftOutHasItsReason) {
    OutputVerdict o = third_order();
    LadderRung rung;
    rung.eps = Rational(1) / 5;
    rung.refusal = "outside_domain: 1 - tau at t = 3";
    o.ladder = {rung};
    findings_.verification.outputs = {o};
    findings_.verification.conditions.ladder_end = LadderEnd{Rational(1) / 100000, "2e+06 steps"};
    findings_.stability.cases = 300;
    findings_.stability.refused_by = {{"outside_domain", 54}};
    const auto table = std::get<Table>(left_out_section(findings_, true).blocks.front());
    const std::vector<std::vector<std::string>> rows{
        {"ε ≤ 10⁻⁵", "2·10⁶ steps"},
        {"ψ, ε = 0.2", "outside_domain: 1 - τ at t = 3"},
        {"54 of 300 points of the stability sweep", "the evaluator answers outside_domain"}};
    EXPECT_EQ(table.rows, rows);
    findings_ = {};
    EXPECT_TRUE(std::holds_alternative<Paragraph>(left_out_section(findings_, true).blocks.front()));
}

} // namespace resonform::report
