// SPDX-License-Identifier: GPL-3.0-or-later
// Ladders of scenes with modes that are damped at eps = 0, the first moments included, and liars among them.
#include "solve/flow/slow_flow.hpp"
#include "support/error_when.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/own_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

test::SceneLine kinetics(int order, std::vector<int> inverses) {
    Scene scene = test::scene_of("michaelis_menten", "from_no_complex");
    scene.order = order;
    scene.verify.eps.clear();
    for (const int inverse : inverses) scene.verify.eps.push_back(Rational(1) / Rational(inverse));
    scene.verify.eps_given = true;
    return test::line_of(std::move(scene));
}

class DampedModes : public test::OwnSystem {
protected:
    Scene scene(const std::string& system, const std::string& text) {
        return written(system, text + "[verify]\neps = [0.05, 0.02, 0.01, 0.005]\n");
    }
    void expect_pass(const std::string& system, const std::string& text) {
        OwnSystem::expect_pass(scene(system, text));
    }
};

const std::string spiral = "[variables]\nx = { role = \"fast\", weight = 0 }\n"
                           "y = { role = \"fast\", weight = 0 }\n[equations]\n"
                           "x = \"x'' + x = eps*(x*y - x^3)\"\ny = \"y'' + 2*y' + 3*y = eps*(x^2 + y^2)\"\n";
const std::string let_go = "outputs = [\"x\", \"y\"]\n[start]\nx = 1\n\"x'\" = 0\ny = 1\n\"y'\" = 0\n";

// The errors that the theory page quotes: N = 1 and 2, eps = 1/10, 1/20, 1/40 (docs/theory.md).
TEST(DampedLadder, OfMichaelisAndMentenHasTheErrorsOfTheTheory) {
    const std::vector<std::vector<double>> expected{{6.9e-4, 1.7e-4, 4.4e-5}, {1.2e-5, 1.5e-6, 1.9e-7}};
    for (const int order : {1, 2}) {
        const Verification v = test::verified(kinetics(order, {10, 20, 40, 80}));
        for (const OutputVerdict& o : v.outputs) {
            EXPECT_EQ(o.verdict, Verdict::pass) << o.name << ": " << o.reason;
            EXPECT_EQ(o.found_order, order + 1) << o.name;
        }
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT(v.outputs[0].ladder[k].max_error,
                      1.1 * expected[static_cast<std::size_t>(order - 1)][k]);
    }
}

// With M = N the slow variable loses its order on 1/eps.
TEST(DampedLadder, ThePlainTruncationLosesAnOrder) {
    test::SceneLine line = kinetics(2, {10, 20, 40, 80});
    line.scene.time_scale.reset();
    line.scene.truncation = 2;
    const Verification v = test::verified(test::line_of(line.scene));
    for (const OutputVerdict& o : v.outputs) EXPECT_EQ(o.found_order, 2) << o.name;
}

// A part of the exponent that is left out or wrong shows within the layer, at its weight.
TEST(DampedLadder, AWrongExponentIsFound) {
    for (const int weight : {1, 2}) {
        test::SceneLine line = kinetics(2, {10, 20, 40, 80});
        SlowFlow wrong = *line.solution.flow;
        const Ring& ring = *line.solution.normalization->normal_form.field->ring;
        const Polynomial part = ring.by_weight(wrong.decays[0], weight)[static_cast<std::size_t>(weight)];
        ASSERT_FALSE(part.empty());
        wrong.decays[0] = wrong.decays[0] - Rational(2) * part;
        line.solution.flow = std::make_shared<const SlowFlow>(wrong);
        const Verification v = test::verified(line);
        EXPECT_EQ(v.outputs[1].verdict, Verdict::fail) << weight; // c
    }
}

TEST_F(DampedModes, SpiralsBesideAnOscillator) { expect_pass(spiral, "order = 2\n" + let_go); }

TEST_F(DampedModes, OfEqualFrequencyMoveWithinTheFrame) {
    expect_pass("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                "x = \"x'' + x = 0\"\ny = \"y'' + 2*y' + 2*y + x^2*y = 0\"\n",
                "order = 2\noutputs = [\"y\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\ny = \"eps\"\n\"y'\" = 0\n");
}

// y = (b + a^2 t) e^{-2t}
TEST_F(DampedModes, InExactResonanceDriveEachOther) {
    const Scene read = scene("[variables]\nu = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                             "u = \"u' = -u + u*y\"\ny = \"y' = -2*y + u^2\"\n",
                             "order = 3\noutputs = [\"u\", \"y\"]\n[start]\nu = \"eps\"\ny = \"eps\"\n");
    const Verification v = test::verified(test::line_of(read));
    for (const auto& output : v.outputs) EXPECT_EQ(output.verdict, Verdict::pass) << output.reason;
}

TEST_F(DampedModes, BesideAnAngleAndADrift) {
    expect_pass("[parameters]\nK = { positive = true }\n[variables]\nphi = { role = \"angle\" }\n"
                "s = { role = \"slow\", positive = true }\ny = { role = \"fast\", weight = 0 }\n"
                "X = { role = \"drift\" }\n[equations]\nphi = \"phi' = s\"\n"
                "s = \"s' = eps*(y^2 - s*cos(phi))\"\ny = \"y' = -K*s*y + eps*sin(phi)\"\n"
                "X = \"X' = eps*(s + y)\"\n",
                "order = 1\noutputs = [\"s\", \"y\", \"X\"]\n[fix]\nK = 3\n[start]\nphi = 0.3\ns = 1\ny = 1\n"
                "X = 0\n");
}

// A start whose map is too long to be inverted, and in which y^2 is as heavy as u: substitutions go from
// light to heavy, or each gains half a power of eps only.
TEST_F(DampedModes, OfThreeWeightsStartWhereTheyAreTold) {
    const Scene read = scene("[variables]\nu = { role = \"fast\", weight = 2 }\ny = { role = \"fast\" }\n"
                             "q = { role = \"fast\", weight = 0 }\ns = { role = \"slow\" }\n[equations]\n"
                             "u = \"u' = -(4 + s - s^3/6)*u + y^2 + eps*y*q\"\n"
                             "y = \"y' = -y + eps*q + u - eps\"\nq = \"q' = -2*q + (1 + s)*y + eps*q^2\"\n"
                             "s = \"s' = eps*(q + 1)\"\n",
                             "order = 3\noutputs = [\"q\"]\n[start]\nu = \"eps^2\"\ny = \"eps\"\nq = -0.6\n"
                             "s = 0.3\n");
    const auto program = test::program_of(read);
    const auto miss = [&](double eps) {
        const Interpreter<double> evaluator(program, eps, {}, {}, 1);
        std::vector<double> value;
        EXPECT_EQ(evaluator.call(0, value), Status::ok);
        return std::abs(value.at(0) + 0.6);
    };
    EXPECT_NEAR(std::log2(miss(1.0 / 160) / miss(1.0 / 320)), 4, 0.2);
}

// A map whose real form is so long that it is summed by harmonics: x e^{i phi} and x e^{-i phi} are
// conjugate, though the real mode x has the same power in both.
TEST_F(DampedModes, BesideAnAngleStartWhereTheyAreToldByALongMap) {
    const Scene read = scene("[variables]\nx = { role = \"fast\", weight = 0 }\ns = { role = \"slow\" }\n"
                             "phi = { role = \"angle\" }\n[equations]\nx = \"x' = -x\"\n"
                             "s = \"s' = eps*(x - s)*sin(phi)\"\nphi = \"phi' = 1 + s^2\"\n",
                             "order = 2\noutputs = [\"s\"]\n[start]\nx = 1\ns = 1\nphi = 0.5\n");
    const Interpreter<double> evaluator(test::program_of(read), 0.01, {}, {}, 1);
    std::vector<double> s;
    EXPECT_EQ(evaluator.call(0, s), Status::ok);
    EXPECT_NEAR(s.at(0), 1, 20 * std::pow(0.01, 3));
}

// The damping 1 - s ends where s does: so does the domain.
TEST_F(DampedModes, EndWhereTheirDampingDoes) {
    const Scene read = scene("[variables]\ns = { role = \"slow\" }\ny = { role = \"fast\", weight = 0 }\n"
                             "[equations]\ns = \"s' = eps\"\ny = \"y' = -(1 - s)*y + eps*s*y^2\"\n",
                             "order = 1\noutputs = [\"y\"]\n[start]\ns = 0\ny = 1\n");
    const Interpreter<double> evaluator(test::program_of(read), 0.01, {}, {}, 2);
    std::vector<double> value;
    EXPECT_EQ(evaluator.call(60, value), Status::ok);
    EXPECT_EQ(evaluator.call(110, value), Status::outside_domain);
    EXPECT_STREQ(evaluator.why(Status::outside_domain), "-s + 1");
}

// On the slow manifold every output is as accurate behind the layer, and no exponential is left.
TEST_F(DampedModes, LeaveTheManifoldBehindThem) {
    Scene read = scene(spiral, "order = 2\ntransients = false\n" + let_go);
    read.verify.eps.insert(read.verify.eps.begin(), Rational(1) / Rational(2));
    const Verification v = test::verified(test::line_of(read));
    for (const auto& output : v.outputs) EXPECT_EQ(output.verdict, Verdict::pass) << output.reason;
    EXPECT_TRUE(v.as_expected()) << to_text(v.emitted);
    const std::vector<Rational> short_ones{Rational(1) / Rational(2), Rational(1) / Rational(20)};
    EXPECT_EQ(v.conditions.within_layer, short_ones);
    EXPECT_GT(v.conditions.layer_end, 10);
    EXPECT_EQ(v.outputs[0].ladder.size(), 3U);
    const auto program = test::program_of(read);
    for (const ProgramPhase& phase : program->phases) EXPECT_FALSE(phase.decays());
}

// The base point is that of the start off the manifold, which moves it along the fibre.
TEST_F(DampedModes, MatterForTheBasePoint) {
    const std::string system = "[variables]\ns = { role = \"slow\", positive = true }\n"
                               "c = { role = \"fast\", weight = 0 }\n[equations]\n"
                               "s = \"s' = eps*(-s + (s + 1/2)*c)\"\nc = \"c' = s - (s + 1)*c\"\n"
                               "[equilibrium]\nc = \"solve\"\n";
    const std::string start = "order = 1\noutputs = [\"s\"]\ntransients = false\n[start]\ns = 1\nc = ";
    const Verification right = test::verified(test::line_of(scene(system, start + "0\n")));
    EXPECT_EQ(right.outputs[0].verdict, Verdict::pass) << right.outputs[0].reason;
    const auto value = [&](const std::string& c) {
        const Interpreter<double> evaluator(test::program_of(scene(system, start + c + "\n")), 0.01, {}, {},
                                            1);
        std::vector<double> s;
        EXPECT_EQ(evaluator.call(50, s), Status::ok);
        return s.at(0);
    };
    EXPECT_GT(std::abs(value("0") - value("0.5")), 1e-3); // eps c(0) times the fibre
}

TEST_F(DampedModes, OfOtherVariablesMayBeAllOfThem) {
    const std::string system = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                               "x = \"x'' + x = y^2\"\ny = \"y' = -y + x*y\"\n";
    const std::string start = "order = 2\noutputs = [\"x\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\ny = \"eps\"\n";
    EXPECT_EQ(test::program_of(scene(system, "transients = false\n" + start))->outputs.size(), 1U);
    EXPECT_EQ(test::program_of(scene(system, "oscillating = false\n" + start))->outputs.size(), 1U);
}

TEST_F(DampedModes, ThatAreAllOfAnOutputAreWantedThere) {
    const Error e = test::error_when([&] {
        test::program_of(scene("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                               "x = \"x'' + x = 0\"\ny = \"y' = -y + x*y\"\n",
                               "order = 2\noutputs = [\"x\", \"y\"]\ntransients = false\n[start]\n"
                               "x = \"eps\"\n\"x'\" = 0\ny = \"eps\"\n"));
    });
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    EXPECT_EQ(e.diagnostic().value, "y = O(eps^3) on the slow manifold");
    EXPECT_EQ(e.diagnostic().place.key, "transients");
}

TEST_F(DampedModes, ThatAreRealHaveNoPhaseToStartFrom) {
    const Scene read = scene("[variables]\ny = { role = \"fast\" }\n[equations]\ny = \"y' = -y + y^2\"\n",
                             "order = 1\noutputs = [\"y\"]\n[start]\namplitude.y = 1\nphase.y = 0\n");
    const Error e = test::error_when([&] { test::program_of(read); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().value, "z1, a mode of y, has no phase");
}

} // namespace
} // namespace resonform
