// SPDX-License-Identifier: GPL-3.0-or-later
// Kept results beside new ones: what counts as a difference, and the summary of all.
#include "verify/report/results.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

using Json = nlohmann::ordered_json;

Json kept() {
    return Json::parse(
        R"({"schema": "resonform.results/1", "system": "pendulum", "scene": "s", "title": "T: S",
        "order": 3, "version": "1", "commit": "abc", "date": "2026-01-01", "command": "resonform results r s",
        "verification": {"outputs": [
            {"name": "psi", "claimed_order": 4, "guaranteed_order": 3, "found_order": 3, "verdict": "fail",
             "expected": "fail", "slope": 3.0, "constant": 2.533e-3, "error_estimate": {"ratio": 0.988}},
            {"name": "x", "claimed_order": 4, "guaranteed_order": 4, "found_order": null, "verdict": "pass",
             "expected": "pass", "slope": null, "constant": null}],
            "emitted_against_symbolic_ulp": 4.4, "emitted_equals_symbolic": {"verdict": "pass"}},
        "stability": {"verdict": "pass", "worst": [{"output": "psi", "ulp": 2.3}, {"output": "psi", "ulp": 1.0}]},
        "comparison": {"break_even": {
            "final": {"emitted_seconds": 1e-6, "rivals": [{"method": "Taylor", "ratio": 272.0},
                      {"method": "CVODE Adams", "ratio": 900.0}, {"method": "slow", "ratio": null}]},
            "dense": {"emitted_seconds": null, "rivals": []}}}})");
}

std::vector<std::string> after(const std::function<void(Json&)>& change) {
    Json anew = kept();
    change(anew);
    return differences(kept(), anew);
}

Json& psi(Json& json) { return json["verification"]["outputs"][0]; }

using Lines = std::vector<std::string>;

} // namespace

TEST(Results, OfTheSameProgramDoNotDiffer) {
    EXPECT_EQ(differences(kept(), kept()), Lines{});
    EXPECT_EQ(after([](Json& j) {
                  j["date"] = "2027-01-01";
                  j["commit"] = "def";
                  j.erase("comparison"); // times are not compared
                  psi(j)["slope"] = 3.005;
                  psi(j)["constant"] = 2.54e-3;
                  j["verification"]["emitted_against_symbolic_ulp"] = 5.5;
                  j["stability"]["worst"][0]["ulp"] = 4.0;
              }),
              Lines{});
}

TEST(Results, DifferInWhatAVerdictHangsOn) {
    EXPECT_EQ(after([](Json& j) { psi(j)["verdict"] = "pass"; }),
              Lines{"verdict of psi: kept \"fail\", now \"pass\""});
    EXPECT_EQ(after([](Json& j) { psi(j)["found_order"] = 4; }), Lines{"found_order of psi: kept 3, now 4"});
    EXPECT_EQ(after([](Json& j) { psi(j)["slope"] = 3.02; }), Lines{"slope of psi: kept 3, now 3.02"});
    EXPECT_EQ(after([](Json& j) { psi(j)["constant"] = 2.6e-3; }),
              Lines{"constant of psi: kept 0.002533, now 0.0026"});
    EXPECT_EQ(after([](Json& j) { psi(j)["constant"] = nullptr; }),
              Lines{"constant of psi: kept 0.002533, now there is none"});
    EXPECT_EQ(after([](Json& j) { j["verification"]["emitted_against_symbolic_ulp"] = 12.0; }),
              Lines{"ulp of emitted = symbolic: kept 4.4, now 12"});
    EXPECT_EQ(after([](Json& j) { j["stability"]["worst"][0]["ulp"] = 9.0; }),
              Lines{"ulp of the stability sweep, psi: kept 2.3, now 9"});
    EXPECT_EQ(after([](Json& j) { j["stability"]["verdict"] = "undecided"; }),
              Lines{"verdict of the stability sweep: kept \"pass\", now \"undecided\""});
    EXPECT_EQ(after([](Json& j) { j["verification"]["outputs"].erase(1); }).size(), 5U)
        << "an output is gone";
}

TEST(Results, AreSummedUpInALineAScene) {
    const std::string page = to_markdown(summary_page({kept()}));
    EXPECT_NE(
        page.find(
            "| [pendulum/s](pendulum/s/report.md) | 3 | ψ fail (3 of 4), as expected; x pass (– of 4) | "
            "Taylor, 272 | not compared | pass, 2.3 | 4.4 | ψ 0.988 |"),
        std::string::npos)
        << page;
    EXPECT_NE(page.find("commit abc"), std::string::npos);
    EXPECT_NE(to_html(summary_page({kept()})).find("<a href=\"pendulum/s/report.md\">pendulum/s</a>"),
              std::string::npos);
}

} // namespace resonform::report
