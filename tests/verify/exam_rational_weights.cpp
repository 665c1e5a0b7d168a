// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of systems with rational weights and powers of eps: their ladders have rational orders, their claims
// hold, and one weight less loses one.
#include "algebra/number/error.hpp"
#include "emit/cpp/cpp.hpp"
#include "emit/program/build_program.hpp"
#include "own_system.hpp"
#include "support/error_when.hpp"
#include "verify/report/json.hpp"
#include "verify/stability/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace resonform {
namespace {

class RationalWeights : public test::OwnSystem {
protected:
    static Scene shortened(Scene scene) {
        if (scene.verify.eps_given) return scene;
        scene.verify.eps.clear();
        for (const int inverse : {200, 800, 3200, 12800})
            scene.verify.eps.push_back(Rational(1) / Rational(inverse));
        scene.verify.eps_given = true;
        return scene;
    }
    static Verification judged(const Scene& scene) {
        const test::SceneLine line = test::line_of(shortened(scene));
        VerifyOptions few = test::options();
        few.compiled = false;
        few.emitted_starts = 2;
        return verify(line.system, line.scene, line.solution, few);
    }
    static void expect_order(const Scene& scene, const std::string& order) {
        const Verification v = judged(scene);
        for (const OutputVerdict& o : v.outputs) {
            EXPECT_EQ(o.verdict, Verdict::pass) << o.name << ": " << o.reason;
            ASSERT_TRUE(o.found_order) << o.name << ": " << o.reason;
            EXPECT_EQ(to_string(o.order(*o.found_order)), order) << o.name;
        }
        EXPECT_EQ(v.emitted.verdict, Verdict::pass) << to_text(v.emitted);
        EXPECT_LE(v.emitted.worst(), 4) << to_text(v.emitted);
    }
    std::string refusal_of(const std::string& system, const std::string& scene) {
        return test::message_when([&] { written(system, scene); });
    }
};

const char* const from_one = "[start]\nx = 1\n\"x'\" = 0\n";
const char* const from_two = "[start]\nx = 2\n\"x'\" = 0\n";

std::string finite(const std::string& equation) {
    return "[variables]\nx = { role = \"fast\", weight = 0 }\n[equations]\nx = \"" + equation + "\"\n";
}

TEST_F(RationalWeights, AFinalOrderIsThatOfTheNextFraction) {
    const std::string quadratic = finite("x'' + x = 1/2*sqrt(eps)*x^2");
    expect_order(written(quadratic, std::string("order = 1\n") + from_one), "3/2");
    expect_order(written(quadratic, std::string("order = \"3/2\"\n") + from_one), "2");
}

// An amplitude acts on the phase at sqrt(eps): M = N + 2p - 1/2.
class SlowRationalWeights : public RationalWeights {};
TEST_F(SlowRationalWeights, OneWeightLessLosesOne) {
    const std::string hardening = finite("x'' + 2*eps*x' + x + sqrt(eps)*x^3 = 0");
    const Scene counted = written(hardening, std::string("order = 1\n") + from_two);
    EXPECT_EQ(test::solution_of(counted).truncation, 5);
    expect_order(counted, "3/2");
    const Verification less =
        judged(written(hardening, std::string("order = 1\ntruncation = 2\n") + from_two));
    EXPECT_EQ(less.outputs.front().verdict, Verdict::fail);
    EXPECT_EQ(less.outputs.front().found_order, 2) << "eps^1";
}

TEST_F(RationalWeights, ASlowVariableDrivenAtRootEps) {
    expect_order(written("[variables]\nx = { role = \"fast\", weight = 0 }\n"
                         "s = { role = \"slow\", positive = true }\n"
                         "[equations]\nx = \"x'' + s*x = 0\"\ns = \"s' = sqrt(eps)*x\"\n",
                         std::string("order = 1\noutputs = [\"x\", \"s\"]\n") + from_one + "s = 1\n"),
                 "3/2");
}

// x = eps^(1/3) X, forced at eps^(2/3), beside a drift of weight 1.
TEST_F(RationalWeights, ThirdsAndAForcing) {
    expect_order(
        written("[variables]\nx = { role = \"fast\", weight = \"1/3\" }\nphi = { role = \"angle\" }\n"
                "y = { role = \"drift\" }\n"
                "[equations]\nx = \"x'' + 2*x + x^3 = eps^(2/3)*cos(phi)\"\nphi = \"phi' = 1\"\n"
                "y = \"y' = eps*(1 + x)\"\n",
                "order = \"2/3\"\ntime_scale = \"2/3\"\noutputs = [\"x\"]\n"
                "[verify]\neps = [1e-4, 1e-5, 1e-6, 1e-7]\n[start]\nx = \"eps^(1/3)\"\n\"x'\" = 0\n"
                "phi = 0\ny = 0\n"),
        "1");
}

// x'' + 2 eps x' + (1 + sqrt(eps)) x = 0 has x = e^(-eps t) (cos nt + eps/n sin nt), n^2 = 1 + sqrt(eps) -
// eps^2.
TEST_F(RationalWeights, ALinearOneIsKnownExactly) {
    const Scene scene = written(finite("x'' + 2*eps*x' + x = -sqrt(eps)*x"),
                                std::string("order = 3\n[verify]\nclaim = { x = \"7/2\" }\n") + from_one);
    EXPECT_EQ(scene.order, 6);
    EXPECT_EQ(scene.verify.claim.at("x"), 7);
    const double eps = 1e-4, t = 5000.25;
    const Interpreter<double> evaluator(test::program_of(scene), eps, {}, {}, 1.0);
    std::vector<double> x;
    ASSERT_EQ(evaluator.call(t, x), Status::ok);
    const double n = std::sqrt(1 + std::sqrt(eps) - eps * eps);
    const double exact = std::exp(-eps * t) * (std::cos(n * t) + eps / n * std::sin(n * t));
    EXPECT_NEAR(x.front(), exact, 1e-11);
}

TEST_F(RationalWeights, DocumentsHaveFractions) {
    const Scene scene = written(finite("x'' + 2*eps*x' + x + sqrt(eps)*x^3 = 0"),
                                std::string("order = 1\nerror_estimate = true\n") + from_one);
    const Verification v = judged(scene);
    const auto json = to_json(v);
    EXPECT_EQ(json["outputs"][0]["claimed_order"], "3/2");
    EXPECT_EQ(json["outputs"][0]["guaranteed_order"], "3/2");
    EXPECT_EQ(json["outputs"][0]["found_order"], "3/2");
    EXPECT_NE(to_text(v).find("claimed eps^(3/2), guaranteed eps^(3/2), found eps^(3/2)"), std::string::npos)
        << to_text(v);
    const std::string header = emit_cpp(*test::program_of(scene));
    EXPECT_NE(header.find("order       1, normal form and map through weight 5/2"), std::string::npos);
}

TEST_F(RationalWeights, TheSweepFollowsTheGrading) {
    const test::SceneLine line =
        test::line_of(written("[variables]\nx = { role = \"fast\", weight = \"1/2\" }\n"
                              "[equations]\nx = \"x'' + x + x^2 = (eps - x^2)*x'\"\n",
                              "order = 1\n[start]\nx = \"sqrt(eps)\"\n\"x'\" = 0\n"));
    StabilityOptions options;
    static_cast<VerifyOptions&>(options) = test::options();
    options.points = 60;
    const Stability s = stability(line.scene, line.solution, options);
    EXPECT_EQ(s.verdict, Verdict::pass) << to_text(s);
    EXPECT_GT(s.compared, 20U);
}

TEST_F(RationalWeights, OrdersThatAreNoMultiplesAreRefused) {
    const std::string quadratic = finite("x'' + x = sqrt(eps)*x^2");
    const std::string third = refusal_of(quadratic, std::string("order = \"7/3\"\n") + from_one);
    EXPECT_NE(third.find("'order' is a multiple of 1/2"), std::string::npos) << third;
    EXPECT_NE(third.find("in 1/2 ... 99"), std::string::npos) << third;
    EXPECT_NE(refusal_of(quadratic, std::string("order = 0\n") + from_one), "");
    EXPECT_NE(refusal_of(quadratic, std::string("order = \"5/2\"\ntruncation = 2\n") + from_one), "");
    const std::string whole =
        refusal_of(finite("x'' + x = eps*x^2"), std::string("order = \"5/2\"\n") + from_one);
    EXPECT_NE(whole.find("is an integer in 1 ... 99"), std::string::npos) << whole;
}

// Rates of order sqrt(eps) on 1/eps: the flow would go a long way; on 1/sqrt(eps) it does not.
TEST_F(RationalWeights, ATimeScaleMayBeAFraction) {
    const std::string cycle = finite("x'' + x = sqrt(eps)*(1 - x^2)*x'");
    const Scene scene = written(cycle, std::string("order = 1\ntime_scale = \"1/2\"\n") + from_one);
    EXPECT_EQ(scene.time_scale, 1);
    EXPECT_EQ(scene.verify.interval_text, "1/eps^(1/2)");
    expect_order(scene, "3/2");
}

} // namespace
} // namespace resonform
