// SPDX-License-Identifier: GPL-3.0-or-later
// The order that the weights guarantee, and what a short ladder, a layer or a short interval cannot hide.
#include "own_system.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

std::vector<Rational> inverses(const std::vector<int>& list) {
    std::vector<Rational> eps;
    for (const int inverse : list) eps.push_back(Rational(1) / Rational(inverse));
    return eps;
}

// A scene with its own system.
class OwnSystem : public test::OwnSystem {
protected:
    Scene scene(const std::string& system, const std::string& scene) { return written(system, scene); }
};

Guarantee guarantee(const Scene& scene, const std::string& output, int claim) {
    return guarantees(scene, test::solution_of(scene), {{output, claim}}, test::derive).at(output);
}

Guarantee guarantee(const std::string& scene, const std::string& output, int claim) {
    return guarantee(test::pendulum_scene(scene), output, claim);
}

TEST(Guarantee, IsThatOfTheCountWhereNoMoreIsClaimed) {
    for (const auto& [scene, order] : {std::pair{"as_published", 3}, std::pair{"third_order", 4}})
        for (const char* output : {"psi", "x", "y"}) {
            const Guarantee found = guarantee(scene, output, order);
            EXPECT_EQ(found.order, order) << scene << ", " << output;
            EXPECT_FALSE(found.refuted);
            EXPECT_EQ(found.reason, "");
        }
    EXPECT_EQ(guarantee("mean_motion", "x", 2).order, 2) << "what it leaves out";
}

TEST(Guarantee, TheNextWeightTellsPsiFromXAndY) {
    const Guarantee psi = guarantee("as_published", "psi", 4);
    EXPECT_EQ(psi.order, 3);
    EXPECT_TRUE(psi.refuted);
    EXPECT_EQ(psi.reason,
              "what the formula leaves out (normal form and map derived through weight 4) does not "
              "vanish at eps^3");
    for (const char* output : {"x", "y"}) {
        const Guarantee found = guarantee("as_published", output, 4);
        EXPECT_EQ(found.order, 4) << output;
        EXPECT_FALSE(found.refuted) << output;
        const Guarantee more = guarantee("as_published", output, 6);
        EXPECT_EQ(more.order, 4) << output;
        EXPECT_TRUE(more.refuted) << output << ": eps^4 is cut off";
    }
    EXPECT_TRUE(guarantee("mean_motion", "x", 3).refuted);
}

// "For all starts": without an amplitude nothing moves psi at eps^3, and the formula is no better for it.
TEST(Guarantee, DoesNotLookAtTheStart) {
    Scene still = test::pendulum_scene("as_published");
    for (StartValue& start : still.start)
        if (start.name == "C_delta") start.value = 0;
    EXPECT_TRUE(guarantee(still, "psi", 4).refuted);
}

// "With [fix] put in": the spring that stiffens by b = 0 is linear, and no weight adds anything.
TEST_F(OwnSystem, WhatIsFixedMayVanish) {
    const std::string duffing = "[parameters]\nb = {}\n[variables]\nx = { role = \"fast\" }\n[equations]\n"
                                "x = \"x'' + x + b*x^3 = 0\"\n";
    const auto with = [&](const std::string& b) {
        return scene(duffing, "order = 3\ntruncation = 3\n[fix]\nb = " + b +
                                  "\n[start]\namplitude.x = 1\n"
                                  "phase.x = 0\n");
    };
    EXPECT_EQ(guarantee(with("0"), "x", 9).order, 9);
    const Guarantee bent = guarantee(with("\"1/7\""), "x", 9);
    EXPECT_EQ(bent.order, 4) << "the rate has odd weights only: 5 is the next, over 1/eps";
    EXPECT_TRUE(bent.refuted);
}

// Order and truncation 1: a linear oscillator leaves nothing out, a cubic one turns by eps within t = 1/eps.
TEST_F(OwnSystem, TheFirstOrderOfASeriesLeavesOutWhatItDoes) {
    const auto with = [&](const std::string& force) {
        return scene("[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x" + force + " = 0\"\n",
                     "order = 1\ntruncation = 1\n[start]\nx = \"eps\"\n\"x'\" = \"0.3*eps\"\n");
    };
    EXPECT_EQ(guarantee(with(""), "x", 5).order, 5);
    const Guarantee bent = guarantee(with(" + x^3"), "x", 3);
    EXPECT_EQ(bent.order, 2);
    EXPECT_TRUE(bent.refuted);
}

// Damped as eps: what truncation 1 does not have is the envelope.
TEST_F(OwnSystem, AnEnvelopeThatIsLeftOutIsMissed) {
    const Guarantee found =
        guarantee(scene("[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + eps*x' + x = 0\"\n",
                        "order = 1\ntruncation = 1\n[start]\nx = \"eps\"\n\"x'\" = 0\n"),
                  "x", 2);
    EXPECT_EQ(found.order, 1);
    EXPECT_EQ(found.reason, "it is not decided whether what the formula leaves out vanishes at eps^1")
        << "exp(-xi/2) - 1 is not proved to be something";
}

TEST(Guarantee, WhatCannotBeDerivedIsOpen) {
    const Scene scene = test::pendulum_scene("as_published");
    const auto refusing = [](const auto&, int, int) -> Solution { refuse({"a rule", "a value", "", {}}); };
    const Guarantee found = guarantees(scene, test::solution_of(scene), {{"psi", 4}}, refusing).at("psi");
    EXPECT_EQ(found.order, 3);
    EXPECT_FALSE(found.refuted);
    EXPECT_EQ(found.reason, "what comes next cannot be derived: a rule (a value)");
    OutputVerdict shown;
    shown.claimed_order = 4;
    shown.found_order = 4;
    shown.verdict = Verdict::pass;
    OutputVerdict wrong = shown;
    wrong.verdict = Verdict::fail;
    weigh(shown, found);
    EXPECT_EQ(shown.verdict, Verdict::undecided);
    EXPECT_EQ(shown.reason, found.reason);
    weigh(wrong, found);
    EXPECT_EQ(wrong.verdict, Verdict::fail) << "a ladder may refute";
}

TEST(Guarantee, NoCountOnALongerInterval) {
    Scene scene = test::pendulum_scene("third_order");
    scene.verify.interval = GiNaC::pow(scene.system->eps, -2);
    const Guarantee found = guarantee(scene, "psi", 1);
    EXPECT_FALSE(found.order);
    EXPECT_EQ(found.reason,
              "no order is guaranteed on this interval: on a time scale beyond 1/eps the slow "
              "variables stay in a compact set (time_scale = 2, xi' = O(eps) of constant sign)");
}

// A time scale more than the scene was made for: through its frequency the amplitude costs one more.
TEST_F(OwnSystem, ALongerIntervalGuaranteesLess) {
    const auto duffing = [&](const std::string& interval) {
        return scene("[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x^3 = 0\"\n",
                     "order = 3\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = \"" + interval +
                         "\"\n");
    };
    EXPECT_EQ(guarantee(duffing("5/eps"), "x", 4).order, 4);
    const Guarantee longer = guarantee(duffing("1/eps^2"), "x", 4);
    EXPECT_EQ(longer.order, 3) << "the rate of weight 5 over eps^-2";
    EXPECT_TRUE(longer.refuted);
}

// exp(1e-3/eps) is 1.0 at every eps of a ladder, and beyond every power at smaller ones.
TEST_F(OwnSystem, NoCountWhereTheIntervalOutgrowsEveryPower) {
    const auto of = [&](const std::string& interval) {
        return guarantee(
            scene("[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x^3 = 0\"\n",
                  "order = 3\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\neps = [0.2, 0.1]\n"
                  "interval = \"" +
                      interval + "\"\n"),
            "x", 4);
    };
    for (const char* interval : {"exp(1e-3/eps)/eps", "exp(1e-30/eps)", "exp(1/eps)", "exp(1/eps^2)",
                                 "exp(exp(1e-2/eps))", "exp(log(1/eps)^2)", "1/eps + 1e-99*exp(1e-9/eps)"}) {
        const Guarantee found = of(interval);
        EXPECT_FALSE(found.order) << interval;
        EXPECT_EQ(found.reason,
                  std::string("no order is guaranteed on this interval: the interval stays below a "
                              "power of 1/eps (interval = ") +
                      interval + ")");
    }
    EXPECT_EQ(of("1/eps^40").reason,
              "no order is guaranteed on this interval: order 0 asks for no more weights "
              "than were derived (truncation = 4, over eps^-40 order 0 asks for 78)");
    EXPECT_FALSE(of("1/eps^200").order);
    for (const char* interval : {"5/eps", "1/eps + 1e9", "1e-9/eps", "exp(-1/eps)", "1/(eps*log(1/eps))",
                                 "1/sin(eps)", "1/eps^(1/2)", "7"})
        EXPECT_EQ(of(interval).order, 4) << interval;
    EXPECT_EQ(of("log(1/eps)/eps").order, 3) << "as 1/eps^2";
}

// What is found out weight by weight never says less than the count: of every scene, a claim one above.
TEST(Guarantee, TheCountOfEveryShippedSceneHolds) {
    for (const char* name :
         {"anharmonic_particle/second_order", "disc_on_a_track/second_order",
          "driven_duffing/forced_oscillation", "henon_heiles/third_order", "lengthening_pendulum/third_order",
          "nonholonomic_particle/uniform_rise", "rotating_pendulum/fast_rotation",
          "slowly_stiffening_oscillator/third_order", "spring_pendulum/exchange",
          "steered_knife_edge/second_order", "van_der_pol/to_the_cycle"}) {
        const std::string text = name;
        const Scene scene = test::scene_of(text.substr(0, text.find('/')), text.substr(text.find('/') + 1));
        const Solution solution = test::solution_of(scene);
        Claims claims;
        for (const std::string& output : scene.outputs) claims[output] = scene.order + 2;
        for (const auto& [output, found] : guarantees(scene, solution, claims, test::derive)) {
            ASSERT_TRUE(found.order) << name << ", " << output << ": " << found.reason;
            EXPECT_GE(*found.order, scene.order + 1) << name << ", " << output;
            EXPECT_EQ(found.refuted, *found.order < scene.order + 2)
                << name << ", " << output << ": " << found.reason;
        }
    }
}

TEST(Ladder, AShortLadderDoesNotPassWhatIsFalse) {
    test::SceneLine line = test::pendulum("as_published");
    line.scene.verify.eps = inverses({5, 10, 20, 50, 100});
    line.scene.verify.eps_given = true;
    const Verification v = test::verified(line);
    ASSERT_EQ(v.outputs.size(), 3U);
    EXPECT_EQ(v.outputs[0].found_order, 4) << "so it looks";
    EXPECT_EQ(v.outputs[0].guaranteed_order, 3);
    EXPECT_EQ(v.outputs[0].verdict, Verdict::fail);
    EXPECT_NE(to_text(v).find("does not vanish at eps^3"), std::string::npos) << to_text(v);
    EXPECT_EQ(to_json(v)["outputs"][0]["guaranteed_order"], 3);
    for (std::size_t k : {1U, 2U}) {
        EXPECT_EQ(v.outputs[k].guaranteed_order, 4);
        EXPECT_EQ(v.outputs[k].verdict, Verdict::pass) << v.outputs[k].reason;
    }
}

// y is exact, but for a planted eps^3 in a layer of 1e-8 of the interval that even times step over.
TEST_F(OwnSystem, AnErrorInAnInitialLayerIsSeen) {
    test::SceneLine line =
        test::line_of(scene("[variables]\ntau = { role = \"slow\" }\ny = { role = \"drift\" }\n[domain]\n"
                            "positive = [\"1 + 10^8*tau\"]\n[equations]\ntau = \"tau' = eps\"\n"
                            "y = \"y' = eps*10^8/(1 + 10^8*tau)^2\"\n",
                            "order = 3\noutputs = [\"y\"]\n[start]\ntau = 0\nconstant.y = 1\n"));
    test::shorten_ladder(line.scene);
    EXPECT_EQ(test::verified(line).outputs.front().verdict, Verdict::pass);
    const Ring& ring = *line.solution.ring;
    const Polynomial tau = ring.gen(line.solution.slow.front().generator);
    Polynomial layer; // 1/(1 + 10^8 tau)
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (ring.generator(id).kind == GeneratorKind::root) layer = ring.gen(id, -ring.generator(id).index);
    ASSERT_FALSE(layer.empty());
    Series& y = line.solution.outputs.front().value;
    y.set(3, y.part(3) + ring.multiply(ring.gen(line.solution.eps, 3),
                                       ring.multiply(Rational(100'000'000) * tau, ring.power(layer, 8))));
    const OutputVerdict planted = test::verified(line).outputs.front();
    EXPECT_EQ(planted.verdict, Verdict::fail);
    EXPECT_EQ(planted.found_order, 3);
}

TEST(Ladder, AnIntervalThatIsShorterThanPromisedIsSaid) {
    test::SceneLine line = test::pendulum("xy_only");
    test::shorten_ladder(line.scene);
    const auto told = [&](const GiNaC::ex& interval, const std::string& text) {
        line.scene.verify.interval = interval;
        line.scene.verify.interval_text = text;
        return test::verified(line);
    };
    const GiNaC::symbol& eps = line.scene.system->eps;
    const Verification tiny = told(eps, "eps");
    EXPECT_TRUE(tiny.conditions.shorter_than_promised);
    EXPECT_NE(to_text(tiny).find(", on t <= eps ONLY, shorter than 1/eps as promised"), std::string::npos);
    const auto json = to_json(tiny);
    EXPECT_EQ(json["interval"], "eps");
    EXPECT_EQ(json["promised"], "1/eps");
    EXPECT_EQ(json["shorter_than_promised"], true);
    EXPECT_EQ(json["start"]["xi"], "0");
    EXPECT_EQ(json["ladder_end"], nullptr);
    for (const char* key : {"count", "first", "per_fast_period"})
        EXPECT_TRUE(json["times"][key].is_number()) << key;
    const Verification whole = told(1 / eps, "1/eps");
    EXPECT_FALSE(whole.conditions.shorter_than_promised);
    EXPECT_EQ(to_text(whole).find("ONLY"), std::string::npos);
    EXPECT_NE(to_text(whole).find("on 0 <= t <= 1/eps, eps = 0.02 ... 0.001;"), std::string::npos)
        << to_text(whole);
    EXPECT_NE(to_text(whole).find("start: xi = 0, C_delta = 1"), std::string::npos) << to_text(whole);
}

// On 1/eps^2 the default ladder asks for 10^8 steps; what was integrated before is judged.
TEST_F(OwnSystem, TheLadderEndsWhereIntegrationTakesTooManySteps) {
    const auto duffing = [&](const std::string& ladder) {
        return test::verified(test::line_of(scene(
            "[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x^3 = 0\"\n",
            "order = 2\ntime_scale = 2\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\neps = " + ladder +
                "\n")));
    };
    const Verification v = duffing("[0.1, 0.05, 0.02, 0.01, 1e-4, 1e-5]");
    ASSERT_TRUE(v.conditions.ladder_end);
    EXPECT_EQ(v.conditions.ladder_end->eps, Rational(1) / Rational(10'000));
    EXPECT_EQ(v.conditions.ladder_end->reason,
              "direct integration through t = 1e+08 takes more than 2000000 steps");
    EXPECT_EQ(v.outputs.front().ladder.size(), 4U);
    EXPECT_EQ(v.outputs.front().verdict, Verdict::pass) << v.outputs.front().reason;
    EXPECT_EQ(to_json(v)["ladder_end"]["eps"], 1e-4);
    EXPECT_NE(to_text(v).find("the ladder ends above eps = 0.0001: "), std::string::npos) << to_text(v);

    const Verification brief = duffing("[0.1, 0.05, 1e-4]");
    EXPECT_EQ(brief.outputs.front().verdict, Verdict::undecided);
    EXPECT_EQ(brief.outputs.front().reason, "the ladder has 2 rungs, 3 are needed");
}

} // namespace
} // namespace resonform
