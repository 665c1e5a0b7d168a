// SPDX-License-Identifier: GPL-3.0-or-later
// The stability sweep: which points it draws, and what makes its verdict.
#include "verify/stability/stability.hpp"

#include "emit/program/build_program.hpp"
#include "support/documented.hpp"
#include "verify/report/json.hpp"
#include "verify/scene_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {
namespace {

Stability swept(const test::SceneLine& line, std::size_t points) {
    StabilityOptions options;
    static_cast<VerifyOptions&>(options) = test::options();
    options.points = points;
    return stability(line.scene, line.solution, options);
}

TEST(Stability, EmittedCodeIsGoodToAFewUlpEverywhere) {
    test::SceneLine line = test::pendulum("third_order");
    const Stability s = swept(line, 120);
    EXPECT_EQ(s.verdict, Verdict::pass) << s.rule;
    EXPECT_EQ(s.cases, 120U);
    EXPECT_GT(s.compared, 30U);
    EXPECT_EQ(s.compared + s.refused + s.beyond_reference + s.not_judged, s.cases);
    EXPECT_GT(s.not_judged, 0U);
    EXPECT_LT(s.unexplained, 3U); // a row of a phase is low_precision as a whole
    EXPECT_LT(s.beyond_reference, 10U);
    ASSERT_EQ(s.median.size(), 3U);
    EXPECT_EQ(s.worst.size(), 15U);
    for (const auto& [name, ulp] : s.median) EXPECT_LT(ulp, 1) << name;
    for (const WorstPoint& w : s.worst) {
        EXPECT_LT(w.ulp, 8) << w.output << " at t = " << w.at.back().second;
        EXPECT_EQ(w.at.front().first, "eps");
        EXPECT_EQ(w.at.back().first, "t");
    }
    const auto json = to_json(s);
    EXPECT_EQ(json["schema"], "resonform.stability/1");
    EXPECT_EQ(test::undocumented(json, test::file_formats()), std::set<std::string>());
    for (const char* key : {"seed", "verdict", "threshold_ulp", "ranges", "cases", "refused", "worst"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["ranges"]["g"], nlohmann::ordered_json({1e-12, 1e12}));
    const std::vector<UlpBin>& bins = s.histogram.front().second;
    EXPECT_EQ(bins.front().up_to, 0.5);
    std::size_t counted = 0;
    for (const UlpBin& bin : bins) counted += bin.count;
    EXPECT_EQ(counted, s.compared);
    ASSERT_EQ(s.by_decade.size(), s.inputs.size() + 1);
    for (const InputByDecade& own : s.by_decade) {
        std::size_t there = 0, answered = 0;
        double largest = 0;
        for (const Decade& d : own.decades) {
            if (&d != &own.decades.front()) {
                EXPECT_GT(d.from(), (&d - 1)->from()) << own.input.name;
            }
            there += d.compared;
            for (const auto& [status, count] : d.refused_by) answered += count;
            if (!d.ulp.empty()) largest = std::max(largest, d.ulp.front());
        }
        EXPECT_EQ(there, s.compared) << own.input.name;
        EXPECT_EQ(answered, s.refused) << own.input.name;
        EXPECT_EQ(largest, s.worst.front().ulp) << own.input.name;
    }
    EXPECT_EQ(s.by_decade.back().input.name, "t");
    EXPECT_EQ(json["by_decade"]["theta_0"][0]["from"], 0);
    std::size_t refused = 0;
    for (const StabilityRefusals& r : s.refusals) {
        refused += r.count;
        EXPECT_LE(r.count, s.refused_by.at(r.status));
        EXPECT_NE(r.why, "") << r.status;
        EXPECT_EQ(r.where.front().name, "eps");
        EXPECT_LE(r.first_t, r.last_t);
    }
    EXPECT_EQ(refused, s.refused);
    for (const char* key : {"output", "ulp", "unavoidable_ulp", "slow_time_ulp", "at"})
        EXPECT_TRUE(json["worst"][0].contains(key)) << key;

    EXPECT_EQ(to_text(swept(line, 120)), to_text(s)) << "no times, nothing that varies";

    line.scene.verify.ulp = 1e-3;
    EXPECT_EQ(swept(line, 6).verdict, Verdict::fail) << "one threshold for all that is emitted";
}

// Inputs excuse an error from a condition number of 10^8 on, the slow time at any.
TEST(Stability, AnErrorIsExcusedByTheSlowTimeOrABadCondition) {
    const auto is_wrong = [](double ulp, double condition, double by_slow_time) {
        return WorstPoint{"x", ulp, condition, by_slow_time, "eps", {}}.is_wrong(16);
    };
    EXPECT_FALSE(is_wrong(16, 0, 0));
    EXPECT_TRUE(is_wrong(17, 0, 0));
    EXPECT_TRUE(is_wrong(17, 0.99e8, 0));
    EXPECT_FALSE(is_wrong(17, 1e8, 0));
    EXPECT_FALSE(is_wrong(16 * (1 + 600), 600, 600));
    EXPECT_TRUE(is_wrong(16 * (1 + 601), 600, 600));
    EXPECT_TRUE(is_wrong(1e10, 1e8, 1)) << "not even then without bounds";
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_wrong(1e10, infinite, 0)) << "another status for a start that close";
}

TEST(Stability, StartsFollowTheGrading) {
    const test::SceneLine line = test::pendulum("third_order");
    const Program program = build_program(line.solution, line.scene, {false, false});
    const System& system = *line.scene.system;
    std::vector<std::string> names;
    for (const SweptInput& input : swept_inputs(program, system)) {
        names.push_back(input.name);
        const bool is_parameter = names.size() > 1 && names.size() <= 4;
        if (is_parameter) {
            EXPECT_EQ(input.high, 1e12) << input.name;
        } else if (names.size() > 4) {
            EXPECT_EQ(input.low, 1e-12) << input.name;
            EXPECT_EQ(input.high, input.name == "theta_0" ? 1e12 : 1e3) << input.name;
            EXPECT_EQ(input.extreme, input.name == "xi_0"      ? 1e150
                                     : input.name == "theta_0" ? 1e14
                                                               : 0)
                << input.name;
        }
        EXPECT_EQ(input.negative, names.size() > 3) << input.name << ": g, r are positive";
        EXPECT_EQ(input.zero, names.size() > 4) << input.name;
        EXPECT_EQ(input.weight, 0) << "amplitudes are divided by eps already";
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"eps", "g", "r", "v", "xi_0", "C_delta", "theta_0", "C_X", "C_Y"}));
}

TEST(Stability, PhysicalStartsAreAsSmallAsTheirVariables) {
    const test::SceneLine line = test::line_of(test::scene_of("henon_heiles", "third_order"));
    const Program program = build_program(line.solution, line.scene, {false, false});
    const auto points = sweep_points(program, line.scene, 40, 5, [](const SweepPoint&) { return true; });
    ASSERT_EQ(points.size(), 40U);
    bool small = false, large = false, none = false;
    for (std::size_t k = 1; k < points.size(); ++k)
        for (const double start : points[k].start) {
            const double size = std::abs(start) / points[k].eps;
            none = none || size == 0;
            if (size == 0) continue;
            EXPECT_GE(size, 0.999e-12);
            EXPECT_LE(size, 1.001e3);
            small = small || size < 0.01;
            large = large || size > 100;
        }
    EXPECT_TRUE(small && large && none);
}

// Davis and Skodje's y rests at x/(1 + x), Michaelis and Menten's complex at s/(s + kappa).
TEST(Stability, StartsAreDrawnAroundTheEquilibrium) {
    for (const auto& [system, name] :
         {std::pair("davis_skodje", "onto_the_manifold"), std::pair("michaelis_menten", "from_no_complex")}) {
        const test::SceneLine line = test::line_of(test::scene_of(system, name));
        const Program program = build_program(line.solution, line.scene, {false, false});
        std::vector<SweptInput> swept = nothing_swept(swept_inputs(program, *line.scene.system));
        for (const SweepPoint& p :
             sweep_points(program, line.scene, 60, 5, [](const SweepPoint&) { return true; })) {
            ASSERT_EQ(p.start.size(), 2U);
            const double kappa = p.parameters.empty() ? 1 : p.parameters.front();
            const double rest = p.start[0] / (kappa + p.start[0]);
            EXPECT_NEAR(p.start[1], rest + p.distance[1], 1e-14 * (1 + std::abs(p.distance[1]))) << system;
            EXPECT_EQ(p.start[0], p.distance[0]);
            add(p, swept);
        }
        EXPECT_LE(swept.back().low, 1.001e-12);
        EXPECT_GE(swept.back().high, 0.999e3);
        EXPECT_LE(swept.back().high, 1.001e3);
    }
}

TEST(Stability, SamePointsForTheSameSeedInsideTheDomain) {
    const test::SceneLine line = test::pendulum("third_order");
    const Program program = build_program(line.solution, line.scene, {false, false});
    int asked = 0;
    const auto draw = [&](std::uint64_t seed) {
        std::vector<double> all;
        const auto inside = [&](const SweepPoint& p) { return ++asked, p.parameters.front() > 1e-3; };
        for (const SweepPoint& p : sweep_points(program, line.scene, 30, seed, inside)) {
            EXPECT_GT(p.parameters.front(), 1e-3);
            all.push_back(p.eps);
            all.insert(all.end(), p.parameters.begin(), p.parameters.end());
            all.insert(all.end(), p.start.begin(), p.start.end());
        }
        return all;
    };
    const std::vector<double> first = draw(2);
    EXPECT_GT(asked, 29) << "some were drawn again";
    EXPECT_EQ(draw(2), first);
    EXPECT_NE(draw(3), first);
    const auto nowhere = [&](const SweepPoint&) { return ++asked, false; };
    asked = 0;
    EXPECT_EQ(sweep_points(program, line.scene, 3, 2, nowhere).size(), 3U);
    EXPECT_EQ(asked, 180)
        << "sixty times each, but for the scene's own; before what is moved to the edge, too";
}

} // namespace
} // namespace resonform
