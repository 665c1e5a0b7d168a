// SPDX-License-Identifier: GPL-3.0-or-later
// Near resonance surfaces evaluators, interpreted and emitted, end with a status: D^2 > |dD/dt| up to there.
#include "model/files/read_scene.hpp"
#include "scene_line.hpp"
#include "support/shell.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

class LayerOf : public testing::Test {
protected:
    // A scene of order 2 with this system, that starts at tau.
    std::shared_ptr<const Program> program(const std::string& domain, const std::string& equations,
                                           const std::string& start) {
        test::write(
            systems_ / "s/system.toml",
            "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\n" +
                std::string(equations.find("y = ") == std::string::npos ? "" : "y = { role = \"fast\" }\n") +
                "tau = { role = \"slow\", positive = true }\n" + domain + "[equations]\n" + equations +
                "tau = \"tau' = eps\"\n");
        test::write(systems_ / "s/scenes/s.toml", "order = 2\n[start]\n" + start);
        return test::program_of(read_scene(systems_ / "s/scenes/s.toml", systems_));
    }

    // ok before `end`, a slow time, and outside_domain after it, by the interpreter and by emitted code.
    static void expect_end(const std::shared_ptr<const Program>& program, double eps, double end) {
        const auto library = EvaluatorLibrary::build(
            *program, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache", [](const std::string&) {});
        const double whole = 2 * end;
        const std::vector<double> start = default_start<double>(*program, eps, {});
        const Interpreter<double> interpreter(program, eps, {}, {}, whole);
        const Evaluator<double> emitted(library, eps, {}, start, whole);
        for (const double factor : {0.0, 0.5, 1 - 1e-9, 1 + 1e-9, 1.1, 1.5}) {
            const Status expected = factor < 1 ? Status::ok : Status::outside_domain;
            const double t = end * factor / eps;
            std::vector<double> values;
            std::vector<double> of_emitted(program->outputs.size());
            EXPECT_EQ(interpreter.call(t, values), expected) << t;
            EXPECT_EQ(emitted.call(t, of_emitted.data()), expected) << t;
        }
    }

    [[nodiscard]] const std::filesystem::path& systems() const { return systems_; }

private:
    test::Scratch scratch_;
    std::filesystem::path systems_ = scratch_.path() / "systems";
};

// omega = sqrt(2 - tau), and what is divided by is 2 omega: 4 omega^2 = |2 omega'| where omega^3 = eps/4.
TEST_F(LayerOf, ATurningPoint) {
    const auto turning =
        program("[domain]\npositive = [\"2 - tau\"]\n", "x = \"x'' + (2 - tau)*x + x^3 = 0\"\n",
                "tau = 1\namplitude.x = 1\nphase.x = 0\n");
    for (const double eps : {0.01, 1e-4, 1e-7}) expect_end(turning, eps, 1 - std::pow(eps / 4, 2.0 / 3));
}

// omega_2 = tau passes 2 omega_1 = 2 as tau grows: (tau - 2)^2 = eps.
TEST_F(LayerOf, APassageThroughResonance) {
    const auto passage = program("", "x = \"x'' + x + x*y = 0\"\ny = \"y'' + tau^2*y + x^2 = 0\"\n",
                                 "tau = 1.5\namplitude.x = 1\nphase.x = 0\namplitude.y = 1\nphase.y = 0\n");
    ASSERT_FALSE(passage->layers.empty());
    for (const double eps : {0.01, 1e-4, 1e-6}) expect_end(passage, eps, 0.5 - std::sqrt(eps));
}

// omega^2 = 1 + tau never comes near zero, and a constant frequency does not move: then only the map has a
// layer.
TEST_F(LayerOf, NothingThatIsFarAway) {
    const std::string start = "tau = 1\namplitude.x = 1\nphase.x = 0\n";
    for (const char* equation :
         {"x = \"x'' + (1 + tau)*x + x^3 = 0\"\n", "x = \"x'' + x + tau*x^3 = 0\"\n"}) {
        const auto far = program("", equation, start);
        const Interpreter<double> interpreter(far, 0.1, {}, {}, 1);
        std::vector<double> values;
        for (const double t : {0.0, 1.0, 5.0, 10.0}) EXPECT_EQ(interpreter.call(t, values), Status::ok) << t;
    }
    const auto growing = program("", "x = \"x'' + x + tau*x^3 = 0\"\n", start);
    for (const ProgramCondition& layer : growing->layers) EXPECT_EQ(layer.quantity, "x");
    EXPECT_TRUE(program("", "x = \"x'' + x + x^3 = 0\"\n", start)->layers.empty());
}

// The ladder goes on where the evaluator answers, and says where it does not.
TEST_F(LayerOf, ALadderThatBeginsInTheLayer) {
    test::write(systems() / "s/system.toml",
                "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
                "[domain]\npositive = [\"1 - tau\"]\n[equations]\nx = \"x'' + (1 - tau)*x + x^3 = 0\"\n"
                "tau = \"tau' = eps\"\n");
    test::write(systems() / "s/scenes/s.toml",
                "order = 2\n[start]\ntau = 0\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = "
                "\"0.83/eps\"\neps = [0.3, 0.005, 0.002, 0.001, 0.0005, 0.0002]\n");
    const Verification v =
        test::verified(test::line_of(read_scene(systems() / "s/scenes/s.toml", systems())));
    EXPECT_EQ(v.outputs.front().verdict, Verdict::pass) << v.outputs.front().reason;
    EXPECT_NE(
        to_text(v).find("\n  inf: the evaluator does not answer over the whole interval at eps = 0.3; "),
        std::string::npos)
        << to_text(v);
}

} // namespace
} // namespace resonform
