// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted code against the exact solution: honest code passes, and liars of every kind are caught.
#include "verify/evaluate/interpreter.hpp"
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/emitted_points.hpp"
#include "verify/report/json.hpp"
#include "verify/run/cache.hpp"

#include "emit/cpp/plan.hpp"
#include "emit/program/build_program.hpp"
#include "own_system.hpp"
#include "support/compiler.hpp"
#include "support/program.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace resonform {
namespace {

namespace fs = std::filesystem;

fs::path cache() { return fs::path(RESONFORM_BINARY_DIR) / "test_cache"; }

struct Made {
    Scene scene;
    Solution solution;
    Program program;
};

Made made(Scene scene, int longest_formula = ProgramOptions().longest_formula) {
    Made m{std::move(scene), {}, {}};
    m.solution = test::solution_of(m.scene);
    m.program = build_program(m.solution, m.scene, {true, false, true, {}, longest_formula});
    return m;
}

Made stiffening() { return made(test::scene_of("slowly_stiffening_oscillator", "third_order")); }

EmittedCheck checked(const Made& m, const std::shared_ptr<const EvaluatorLibrary>& library,
                     const fs::path& folder) {
    EmittedCheckOptions options;
    options.cache = folder;
    options.starts = 10;
    return check_emitted(m.program, library, m.solution, m.scene, options);
}

EmittedCheck checked(const Made& m, const fs::path& folder = cache()) {
    return checked(m, EvaluatorLibrary::build(m.program, folder, {}, "dl"), folder);
}

std::shared_ptr<const EvaluatorLibrary> interpreted(const Made& m) {
    return EvaluatorLibrary::interpreted(std::make_shared<const Program>(m.program));
}

// Where the lie is in the graph, which compiled code and the interpreter have in common.
EmittedCheck checked_interpreted(const Made& m) { return checked(m, interpreted(m), cache()); }

// A system, behind its name, and its scene, from thirty starts.
void expect_four_ulp(const std::string& system, const std::string& scene) {
    struct : test::WrittenSystem {
        using WrittenSystem::written;
    } own;
    const Made m = made(own.written(system, scene));
    const EmittedCheck check =
        check_emitted(m.program, interpreted(m), m.solution, m.scene, {cache(), {}, 30});
    EXPECT_EQ(check.verdict, Verdict::pass) << to_text(check);
    EXPECT_LT(check.worst(), 4) << to_text(check);
}

// Compiled by another compiler, in a folder of its own.
EmittedCheck checked_with(const std::string& compiler, const std::string& folder) {
    const fs::path path = fs::path(RESONFORM_BINARY_DIR) / folder;
    fs::remove_all(path);
    const test::OtherCompiler chosen(compiler);
    return checked(stiffening(), path);
}

fs::path script(const std::string& name) { return fs::path(RESONFORM_BINARY_DIR) / (name + ".sh"); }

EmittedCheck checked_with_edit(const std::string& from, const std::string& to, const std::string& name) {
    return checked_with(test::editing_compiler(script(name), from, to), name);
}

// Ten times as many in double, for the tables.
std::size_t points_of(const EmittedInType& type) { return type.type == "double" ? 2000 : 200; }

void expect_caught(const EmittedCheck& check) {
    EXPECT_EQ(check.verdict, Verdict::fail);
    for (const EmittedInType& type : check.types) {
        EXPECT_FALSE(type.at.empty());
        EXPECT_EQ(type.points, points_of(type));
    }
    EXPECT_GT(check.worst(), 2 * check.threshold);
}

// A quadrature, a slow flow, exponentials, an output that begins with 0, nothing that turns.
TEST(SlowEmittedEqualsSymbolic, WhereManyPointsAreMadeOfAtoms) {
    for (const auto& [system, name] :
         {std::pair("almost_holonomic_pendulum", "third_order"), std::pair("henon_heiles", "third_order"),
          std::pair("stiff_spring", "stiff"), std::pair("nonholonomic_particle", "uniform_rise"),
          std::pair("almost_holonomic_pendulum", "mean_motion")}) {
        Scene scene = test::scene_of(system, name);
        scene.form = EmitForm::atoms;
        const Made m = made(std::move(scene));
        ASSERT_STREQ(m.program.form(), "atoms");
        const EmittedCheck check = checked(m);
        EXPECT_EQ(check.verdict, Verdict::pass) << system << '\n' << to_text(check);
    }
}

// Three modes at order 5: thousands of statements, if they were statements, whose points are formulas or sums
// of rows.
TEST(SlowEmittedEqualsSymbolic, WhereALoopWalksTheConstants) {
    for (const int longest_formula : {2000, 0}) {
        Scene scene = test::scene_of("three_oscillators_chain", "third_order");
        scene.order = 5;
        const Made m = made(std::move(scene), longest_formula);
        ASSERT_TRUE(CppPlan(m.program).walks_constants());
        ASSERT_EQ(m.program.sums_rows, longest_formula == 0);
        const auto library = EvaluatorLibrary::build(m.program, cache(), {}, "dl");
        const EmittedCheck check =
            check_emitted(m.program, library, m.solution, m.scene, {cache(), {}, 4, 10});
        EXPECT_EQ(check.verdict, Verdict::pass) << to_text(check);
        EXPECT_LT(check.worst(), 4) << to_text(check);
    }
}

// A quadrature, a condition at every time, a slow flow, exponentials, an output without rows that turn;
// points one by one, too.
TEST(SlowEmittedEqualsSymbolic, WhereOnePointIsASumOfRows) {
    for (const auto& [system, name] :
         {std::pair("almost_holonomic_pendulum", "third_order"), std::pair("henon_heiles", "third_order"),
          std::pair("michaelis_menten", "from_no_complex"),
          std::pair("nonholonomic_particle", "uniform_rise")}) {
        Scene scene = test::scene_of(system, name);
        if (std::string(system) == "henon_heiles") scene.form = EmitForm::direct;
        const Made m = made(std::move(scene), 0);
        ASSERT_TRUE(m.program.sums_rows);
        const EmittedCheck check = checked(m);
        EXPECT_EQ(check.verdict, Verdict::pass) << system << '\n' << to_text(check);
        EXPECT_LT(check.worst(), check.threshold) << system << '\n' << to_text(check);
    }
}

TEST(SlowEmittedEqualsSymbolic, HonestCodePassesClosedAndAsAFlow) {
    for (const Made& m : {stiffening(), made(test::scene_of("van_der_pol", "to_the_cycle")),
                          made(test::scene_of("driven_duffing", "forced_oscillation"))}) {
        const EmittedCheck check = checked(m);
        EXPECT_EQ(check.verdict, Verdict::pass) << to_text(check);
        EXPECT_LT(check.worst(), 4) << to_text(check);
        for (const EmittedInType& type : check.types) EXPECT_EQ(type.compared, points_of(type));
    }
}

// 3/8 of the phase, by 10^-12 of itself; 3/16 of the third order, grossly.
TEST(SlowEmittedEqualsSymbolic, AnEditedCoefficientIsCaught) {
    expect_caught(checked_with_edit("Number(3) / Number(8)", "Number(3000000000003) / Number(8000000000000)",
                                    "edit_1"));
    expect_caught(checked_with_edit("Number(3) / Number(16)", "Number(5) / Number(16)", "edit_2"));
}

// Tables are made of rows, which calls do not use.
TEST(SlowEmittedEqualsSymbolic, AnErrorInARowIsCaught) {
    Made lie = stiffening();
    Graph::Node& amplitude = lie.program.rows.front().amplitude;
    amplitude = lie.program.graph.multiply(
        {lie.program.graph.rational(1 + Rational(1) / Integer("1000000000000")), amplitude});
    const EmittedCheck check = checked(lie);
    EXPECT_EQ(check.verdict, Verdict::fail) << to_text(check);
    EXPECT_GT(check.types.at(0).ulp, 2 * check.threshold);
    EXPECT_LT(check.types.at(1).ulp, 4);
    EXPECT_LT(checked_interpreted(lie).worst(), 4);
}

// What the interpreter of the same graph does not see.
TEST(SlowEmittedEqualsSymbolic, AnErrorInTheGraphIsCaught) {
    Made lowered = stiffening();
    ProgramOutput& x = lowered.program.outputs.front();
    x.value = lowered.program.graph.multiply(
        {lowered.program.graph.rational(1 + Rational(1) / Integer("1000000000000")), x.value});
    expect_caught(checked_interpreted(lowered));

    Made pruned = stiffening();
    ProgramPhase& phase = pruned.program.phases.front();
    phase.rate = pruned.program.graph.at(phase.rate).operands.front(); // of a product the first factor
    expect_caught(checked_interpreted(pruned));

    Scene near = test::scene_of("rotating_pendulum", "fast_rotation"); // its resonance surface J = 0
    near.start.front().value = GiNaC::numeric(1, 20);
    Made without_domain = made(std::move(near));
    without_domain.program.layers.clear();
    without_domain.program.positive.clear();
    const EmittedCheck check = checked_interpreted(without_domain);
    EXPECT_EQ(check.verdict, Verdict::fail);
    EXPECT_NE(check.types.front().statuses.find("symbolic outside_domain"), std::string::npos)
        << to_text(check);
    EXPECT_TRUE(
        to_json(Verification{"", "", {}, {}, check})["emitted_equals_symbolic"]["real_types"][0]["ulp"]
            .is_null());
}

// Programs of which one thing is missing that outputs need.
std::vector<std::pair<std::string, Program>> pruned_too_far(const Program& whole) {
    std::vector<std::pair<std::string, Program>> mutants;
    const auto mutant = [&](const std::string& missing) -> Program& {
        return mutants.emplace_back(missing, whole).second;
    };
    for (std::size_t k = 0; k < whole.tables.size(); ++k) {
        Program& p = mutant(whole.tables[k].name);
        p.tables[k].integrand = p.graph.rational(0);
    }
    for (std::size_t k = 0; k < whole.flow.size(); ++k) {
        Program& p = mutant(whole.flow[k].name);
        p.flow[k].rate = p.graph.rational(0);
    }
    for (std::size_t k = 0; k < whole.outputs.size(); ++k) {
        const Graph::Entry sum = whole.graph.at(whole.outputs[k].value);
        for (std::size_t j = 0; sum.op == Graph::Op::add && j < sum.operands.size(); ++j) {
            Program& p = mutant(whole.outputs[k].name + ", term " + std::to_string(j));
            std::vector<Graph::Node> rest = sum.operands;
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(j));
            p.outputs[k].value = p.graph.add(std::move(rest));
        }
    }
    return mutants;
}

TEST(SlowEmittedEqualsSymbolic, WhatIsPrunedThoughItIsNeededIsMissed) {
    std::size_t missed = 0;
    for (Made m :
         {made(test::pendulum_scene("mean_motion")), made(test::scene_of("van_der_pol", "to_the_cycle"))})
        for (const auto& [missing, program] : pruned_too_far(m.program)) {
            SCOPED_TRACE(m.scene.name + " without " + missing);
            m.program = program;
            expect_caught(checked_interpreted(m));
            ++missed;
        }
    EXPECT_EQ(missed, 12U) << "a table, a flow of two variables, and terms of sums";
}

// The divisor 1 - sqrt(1 + s^2) of the forced motion: formed by a subtraction, it had lost 300 ulp at s =
// 0.04.
TEST(EmittedEqualsSymbolic, ADivisorThatIsTheDifferenceOfARootKeepsItsDigits) {
    expect_four_ulp("[variables]\nx = { role = \"fast\" }\n"
                    "s = { role = \"slow\" }\np = { role = \"angle\" }\n[equations]\n"
                    "x = \"x'' + (1 + s^2)*x + x^3 = eps*cos(p)\"\ns = \"s' = eps*(1 - s/2)\"\n"
                    "p = \"p' = 1 + s^2\"\n",
                    "order = 1\n[start]\nx = \"0.3*eps\"\n\"x'\" = \"0.1*eps\"\ns = 0.4\np = 0.5\n"
                    "[verify]\neps = [0.01, 0.002]\ninterval = \"1\"\n");
}

// The divisor 1 - w of a forced motion at w = pi/3: of a pi in double it had lost 20 ulp.
TEST(EmittedEqualsSymbolic, ADivisorOfFixedNumbersKeepsItsDigits) {
    expect_four_ulp(
        "[parameters]\nw = { positive = true }\n[variables]\n"
        "x = { role = \"fast\" }\ns = { role = \"slow\" }\np = { role = \"angle\" }\n[equations]\n"
        "x = \"x'' = -w^2*x + eps^2*(1 + s^2)*cos(p)\"\ns = \"s' = eps\"\np = \"p' = 1\"\n",
        "order = 1\n[fix]\nw = \"pi/3\"\n[start]\nx = \"0.3*eps\"\n\"x'\" = \"0.1*eps\"\ns = 0.4\n"
        "p = 0.5\n[verify]\neps = [0.01, 0.002]\ninterval = \"1\"\n");
}

// The divisor c - sqrt(c^2 - 4) is 10^-4 at c = 20000: of its square, multiplied out, noise was left, and
// statuses were wrong.
TEST(EmittedEqualsSymbolic, ADivisorOfLargeFixedNumbersKeepsItsDigits) {
    expect_four_ulp("[parameters]\nc = { positive = true }\n[variables]\n"
                    "x = { role = \"fast\" }\n[domain]\npositive = [\"c^2 - 4\"]\n[equations]\n"
                    "x = \"x'' + c*x' + sin(x) = 0\"\n",
                    "order = 2\n[fix]\nc = 20000\n[start]\nx = \"eps\"\n\"x'\" = 0\n");
}

// y = e^-t + eps sin(tau), and tau = tau_0 + eps t passes a multiple of pi. There sin(tau) is as small as the
// rounding error of tau; counted in ulp of |sin(tau)| alone, correct code was off by 10^4 of them.
TEST(EmittedEqualsSymbolic, AFunctionThatPassesZeroIsKnownToItsArgument) {
    const std::string functions[][2] = {{"sin(tau)", "5/2"}, {"log(tau)", "0.7"}, {"erf(tau - 1)", "0.7"}};
    for (const auto& [function, start] : functions) {
        expect_four_ulp("[variables]\ny = { role = \"fast\", weight = 0 "
                        "}\ntau = { role = \"slow\", positive = true }\n[equations]\ny = \"y' = -y + eps*" +
                            function + "\"\ntau = \"tau' = eps\"\n",
                        "order = 1\n[start]\ny = 1\ntau = \"" + start + "\"\n[verify]\neps = [0.1, 0.02]\n");
    }
}

// A condition that holds wherever values are compared, and breaks at some of the starts of which only the
// status is.
TEST(EmittedEqualsSymbolic, AConditionThatFewStartsBreakIsCaught) {
    Made m = stiffening();
    constexpr std::size_t starts = 10, times = 20;
    const auto check = [&m] {
        return check_emitted(m.program, interpreted(m), m.solution, m.scene, {cache(), {}, starts, times});
    };
    const EmittedCheck honest = check();
    EXPECT_EQ(honest.verdict, Verdict::pass) << to_text(honest);
    long double most = 0;
    for (const auto& at : emitted_points<double>(m.scene, starts, times, 1))
        most = std::max(most, static_cast<long double>(at.eps));
    for (const auto& at : emitted_points<long double>(m.scene, starts, times, 1))
        most = std::max(most, at.eps);
    Graph& graph = m.program.graph;
    const Rational bound = Rational(Integer(static_cast<long>(most * 1e9L) + 1)) / Integer(1'000'000'000L);
    m.program.positive.push_back({graph.add({graph.rational(bound), graph.negate(m.program.eps)}), "eps"});
    const EmittedCheck check_of_lie = check();
    EXPECT_EQ(check_of_lie.verdict, Verdict::fail);
    const EmittedInType& found = check_of_lie.types.front();
    EXPECT_EQ(found.statuses, "emitted outside_domain, symbolic ok");
    EXPECT_EQ(found.at.back(), (std::pair<std::string, double>("t", 0)));
}

// Minutes may pass: what is under way, and how far it is.
TEST(EmittedEqualsSymbolic, TellsHowFarItIs) {
    const test::Scratch scratch; // nothing is known yet
    const Made m = stiffening();
    std::vector<std::string> said;
    EmittedCheckOptions options;
    options.cache = scratch.path();
    options.progress = [&said](const std::string& line) { said.push_back(line); };
    options.starts = 8;
    options.times = 2;
    const auto check = [&] {
        check_emitted(m.program, interpreted(m), m.solution, m.scene, options);
        if (!said.empty()) said.pop_back(); // the seconds that it took
        return std::exchange(said, {});
    };
    std::vector<std::string> expected, known;
    for (const char* type : {"double", "long double"}) {
        known.push_back("emitted code in " + std::string(type) + " against the exact solution: 8 starts, " +
                        (type == std::string("double") ? "20" : "2") + " times of each");
        expected.push_back(known.back());
        for (const char* done : {"2", "4", "6"})
            expected.push_back("the exact solution in 50 digits: " + std::string(done) + " of 8 starts");
    }
    EXPECT_EQ(check(), expected);
    EXPECT_EQ(check(), known) << "from the cache";
}

TEST(SlowEmittedEqualsSymbolic, TheThresholdIsThatOfTheSceneAndSaysWhy) {
    Made m = stiffening();
    m.scene.verify.ulp = 1;
    const EmittedCheck strict = checked_interpreted(m);
    EXPECT_EQ(strict.verdict, Verdict::fail);
    EXPECT_FALSE((Verification{"", "", {}, {}, strict}.as_expected())) << "exit code 1";
    m.scene.verify.ulp = 64;
    EXPECT_NE(to_text(checked_interpreted(m))
                  .find("threshold 64 ulp of the output's scale, widened without a reason"),
              std::string::npos);
    m.scene.verify.ulp_reason = "because";
    const EmittedCheck check = checked_interpreted(m);
    EXPECT_NE(to_text(check).find("64 ulp of the output's scale, widened: because"), std::string::npos);
    EXPECT_EQ(check.verdict, Verdict::pass);
}

TEST(SlowEmittedEqualsSymbolic, TheCacheAnswersTheSame) {
    const fs::path folder = fs::path(RESONFORM_BINARY_DIR) / "test_symbolic_cache";
    fs::remove_all(folder);
    const Made m = stiffening();
    const std::string first = to_text(checked(m, folder));
    EXPECT_EQ(to_text(checked(m, folder)), first);
}

} // namespace
} // namespace resonform
