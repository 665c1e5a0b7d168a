// SPDX-License-Identifier: GPL-3.0-or-later
// LaTeX and Maxima scripts are read back (read_latex.py, read_back.py, read_equations.py, read_solution.py):
// every equation has the values that the JSON gives it, at a random point.
#include "support/command.hpp"
#include "support/exact.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace resonform::test {
namespace {

std::string path_of(const std::string& system) {
    return "'" + (source_dir() / "systems" / system / "system.toml").string() + "'";
}

class ReadBack : public Command {
protected:
    // `what`: a system and options of derive. The documents are left in the folder of the test.
    void derive(const std::string& what,
                const std::vector<std::string>& formats = {"latex", "json", "maxima"}) const {
        const std::string command = "derive " + what + " --format ";
        for (const std::string& format : formats)
            write(scratch_.path() / ("out." + format), printed(command + format));
    }
    void derive_solution(const std::string& path, int order) const {
        derive(path + " --stage solution --order " + std::to_string(order), {"latex", "json"});
        write(scratch_.path() / "out.normal_form", printed("derive " + path + " --order 3 --format json"));
    }
    // The equations as the file has them, and expanded.
    void derive_equations(const std::string& path) const {
        for (const char* stage : {"equations", "expand"})
            for (const char* format : {"latex", "json"})
                write(scratch_.path() / (std::string(stage) + "." + format),
                      printed("derive " + path + " --stage " + stage + " --format " + format));
    }
    [[nodiscard]] std::string judged(const std::string& option = "",
                                     const std::string& by = "read_back.py") const {
        const auto script = source_dir() / "tests" / "emit" / by;
        const Outcome outcome = run("python3 -B '" + script.string() + "' " + option, scratch_.path());
        return outcome.out + outcome.err;
    }
};

class ReadBackOf : public ReadBack, public testing::WithParamInterface<std::string> {};

TEST_P(ReadBackOf, HasTheValuesOfTheJson) {
    derive(path_of(GetParam()));
    EXPECT_EQ(judged(), "equal\n");
}

TEST_P(ReadBackOf, EquationsToo) {
    derive_equations(path_of(GetParam()));
    EXPECT_EQ(judged("", "read_equations.py"), "equal\n");
}

TEST_P(ReadBackOf, ASolutionToo) {
    const Outcome outcome = said("derive " + path_of(GetParam()) + " --stage solution --order 2");
    if (outcome.code == 3) return; // functions without values, a linear part that is not semisimple
    derive_solution(path_of(GetParam()), 2);
    EXPECT_EQ(judged("", "read_solution.py"), "equal\n");
}

std::vector<std::string> systems() {
    std::vector<std::string> names;
    for (const auto& system : std::filesystem::directory_iterator(source_dir() / "systems"))
        if (exists(system.path() / "system.toml")) names.push_back(system.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string same(const testing::TestParamInfo<std::string>& name) { return name.param; }

INSTANTIATE_TEST_SUITE_P(Systems, ReadBackOf, testing::ValuesIn(systems()), same);

TEST_F(ReadBack, FunctionsKnownByTheirNameAndFractionsOfWeights) {
    write(scratch_.path() / "named/system.toml", R"toml([system]
name = "named"
[parameters]
lambda1 = { positive = true }
x_2 = { nonzero = true }
[functions]
omega = { of = ["tau"], positive = true }
[variables]
q = { role = "fast", weight = "1/2" }
sum = { role = "drift" }
tau = { role = "slow" }
[equations]
q = "q'' + omega(tau)^2*q + sqrt(eps)*x_2*q' + eps*omega''(2*tau)*q^2 + lambda1*q^3 = 0"
sum = "sum' = eps*x_2*omega(tau) + eps*q^2/lambda1"
tau = "tau' = eps/3"
)toml");
    derive("named/system.toml");
    EXPECT_EQ(judged(), "equal\n");
}

TEST_F(ReadBack, FunctionsAndNamesThatMaximaOwns) {
    write(scratch_.path() / "elementary/system.toml",
          system_text("elementary",
                      {{"q", "fast",
                        "q'' + (k + C_delta^2)*q + asinh(C_delta)*q^3 + eps*n_2*acos(1/(1 + k))*q' + "
                        "atan(n_2*C_delta)*q^2 = 0"},
                       {"rate", "drift",
                        "rate' = eps*n_2*q^2*cosh(C_delta/3) + eps*exp(-C_delta)/(1 + C_delta^4) + "
                        "eps*q*pi*erf(n_2)"},
                       {"C_delta", "slow", "C_delta' = eps/3"}},
                      "[parameters]\nk = { positive = true }\nn_2 = {}\n"));
    derive("elementary/system.toml");
    EXPECT_EQ(judged(), "equal\n");
}

// Of names that LaTeX would print alike.
TEST_F(ReadBack, NamesThatAreSetApart) {
    write(scratch_.path() / "apart/system.toml",
          system_text("apart",
                      {{"q", "fast", "q'' + x2^2*q + x_2*q^3 + eps*k_a_1*q' + k_a1*q^2 = 0"},
                       {"rate", "drift", "rate' = eps*x_2/x2*q + eps*k_a1*q"}},
                      "[parameters]\nx2 = { positive = true }\nx_2 = {}\nk_a1 = {}\n"
                      "k_a_1 = {}\n"));
    derive_equations("apart/system.toml");
    EXPECT_NE(read(scratch_.path() / "equations.latex").find("x_{2}^{2} q + x_{(2)} q^{3}"),
              std::string::npos);
    EXPECT_EQ(judged("", "read_equations.py"), "equal\n");
    derive("apart/system.toml", {"latex", "json"});
    EXPECT_EQ(judged(), "equal\n");
}

// Damping, drift and phase are integrals of sums over the slow time of a variable that relaxes.
TEST_F(ReadBack, IntegralsOverSlowTime) {
    write(scratch_.path() / "relaxing/system.toml",
          system_text("relaxing",
                      {{"u", "slow", "u' = eps*(p - q*u)"},
                       {"x", "fast", "x'' + 2*eps*sqrt(1 + u^2)*x' + (1 + u)^2*x = 0"},
                       {"d", "drift", "d' = eps*sqrt(1 + u^2)"}},
                      "[parameters]\np = { positive = true }\nq = { positive = true }\n"
                      "[domain]\npositive = [\"u\"]\n"));
    derive_solution("relaxing/system.toml", 1);
    const std::string latex = read(scratch_.path() / "out.latex");
    EXPECT_NE(latex.find("  T &= \\varepsilon t\n"), std::string::npos) << latex;
    EXPECT_NE(latex.find("\\int\\limits_{0}^{t} \\left(u + 1\\right) \\, dt"), std::string::npos) << latex;
    EXPECT_EQ(judged("", "read_solution.py"), "equal\n");
}

// u relaxes within a slow flow.
TEST_F(ReadBack, PathsOfSlowVariables) {
    write(scratch_.path() / "forced/system.toml",
          system_text("forced",
                      {{"u", "slow", "u' = eps*(p - q*u)"},
                       {"x", "fast", "x'' + (1 + u)^2*x = eps*cos(phi)"},
                       {"phi", "angle", "phi' = 3"}},
                      "[parameters]\np = {}\nq = { positive = true }\n[domain]\npositive = [\"u\"]\n"));
    derive_solution("forced/system.toml", 1);
    const std::string latex = read(scratch_.path() / "out.latex");
    EXPECT_NE(latex.find("  u &= u_{0} \\exp \\left(-\\varepsilon q t\\right) + \\frac{p}{q} \\left(1 - "),
              std::string::npos)
        << latex;
    EXPECT_EQ(judged("", "read_solution.py"), "equal\n");
}

TEST_F(ReadBack, DecimalNumbers) {
    derive(path_of("transition_state") + " --digits 20 --set k=7000000 b=1/3", {"latex", "json"});
    EXPECT_NE(read(scratch_.path() / "out.latex").find("\\cdot 10^{-"), std::string::npos);
    EXPECT_EQ(judged(), "equal\n");
}

TEST_F(ReadBack, FindsEverySignThatIsChanged) {
    derive(path_of("almost_holonomic_pendulum") + " --order 2");
    EXPECT_EQ(judged("--plant"), "42 found\n");
}

TEST_F(ReadBack, NamesTheEquationThatIsWrong) {
    derive(path_of("crossing_rates"));
    const auto file = scratch_.path() / "out.latex";
    std::string latex = read(file);
    const std::string rate = "\\dot{s} &= -\\varepsilon";
    ASSERT_NE(latex.find(rate), std::string::npos) << latex;
    write(file, latex.replace(latex.find(rate), rate.size(), "\\dot{s} &= \\varepsilon"));
    EXPECT_EQ(judged(), "LaTeX, rates: \\dot{s} = \\varepsilon\n");
}

TEST_F(ReadBack, NamesTheExpandedEquationThatIsWrong) {
    derive_equations(path_of("airy"));
    const auto file = scratch_.path() / "expand.latex";
    std::string latex = read(file);
    const std::size_t sum = latex.find("+ \\tau x");
    ASSERT_NE(sum, std::string::npos) << latex;
    write(file, latex.replace(sum, 1, "-"));
    EXPECT_EQ(judged("", "read_equations.py"), "LaTeX, expanded: \\ddot{x} - \\tau x = 0\n");
}

TEST_F(ReadBack, NamesTheOutputThatIsWrong) {
    derive_solution(path_of("airy"), 1);
    const auto file = scratch_.path() / "out.latex";
    std::string latex = read(file);
    const std::size_t sine = latex.rfind("\\cos \\theta");
    ASSERT_NE(sine, std::string::npos) << latex;
    write(file, latex.replace(sine, 4, "\\sin"));
    const std::string found = judged("", "read_solution.py");
    EXPECT_EQ(found.rfind("LaTeX, outputs through order 1: x = ", 0), 0U) << found;
}

} // namespace
} // namespace resonform::test
