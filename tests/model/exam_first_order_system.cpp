// SPDX-License-Identifier: GPL-3.0-or-later
// Implicit equations solved for their highest derivatives.
#include "model/exact/first_order_system.hpp"

#include "messages.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

using GiNaC::ex;

FirstOrderSystem solved(const std::string& toml) {
    return solve_for_highest(std::make_shared<System>(read_system_text(toml, "system.toml")));
}

TEST(FirstOrderSystem, ThePendulumIsExplicit) {
    const FirstOrderSystem f = solved(pendulum_system());
    std::vector<std::string> names;
    for (const State& s : f.states) names.push_back(s.name);
    EXPECT_EQ(names, (std::vector<std::string>{"psi", "psi'", "xi", "x", "y"}));
    EXPECT_EQ(f.index(2, 0), 3U);
    EXPECT_EQ(f.index(0, 1), 1U);

    const System& s = *f.system;
    const ex g = s.parameter("g")->symbol, r = s.parameter("r")->symbol, v = s.parameter("v")->symbol;
    const ex psi = f.state("psi").symbol, psi1 = f.state("psi'").symbol, xi = f.state("xi").symbol;
    const ex q = xi * xi + r * r, drive = s.eps * v;
    EXPECT_EQ(f.state("psi").rate, psi1);
    EXPECT_EQ(f.state("xi").rate, drive);
    const ex acceleration =
        -(xi * drive * psi1 + g * sqrt(q) * sin(psi) - r * xi * drive * drive / q) / q; // (15)
    EXPECT_TRUE((f.state("psi'").rate - acceleration).expand().is_zero()) << f.state("psi'").rate;
    EXPECT_TRUE((f.state("x").rate - (r * cos(psi) - xi * sin(psi)) / sqrt(q) * drive).expand().is_zero());
    EXPECT_TRUE((f.state("y").rate - (r * sin(psi) + xi * cos(psi)) / sqrt(q) * drive).expand().is_zero());
}

std::string pair_system(const std::string& a, const std::string& b) {
    return "[system]\nname = \"pair\"\n[variables]\na = { role = \"fast\" }\nb = { role = \"fast\" }\n"
           "[equations]\na = \"" +
           a + "\"\nb = \"" + b + "\"\n";
}

TEST(FirstOrderSystem, SolvesCoupledEquationsTogether) {
    const FirstOrderSystem f =
        solved(pair_system("2*a'' + cos(a-b)*b'' = -a", "cos(a-b)*a'' + b'' = -sin(b)"));
    const ex a = f.state("a").symbol, b = f.state("b").symbol;
    const ex c = cos(a - b), determinant = 2 - c * c;
    EXPECT_TRUE((f.state("a'").rate - (-a + c * sin(b)) / determinant).normal().is_zero());
    EXPECT_TRUE((f.state("b'").rate - (-2 * sin(b) + c * a) / determinant).normal().is_zero());
}

TEST(FirstOrderSystem, AnEquationMayGiveTheOthersDerivative) {
    const FirstOrderSystem f = solved(pair_system("b' = -a", "a' = b"));
    EXPECT_EQ(f.state("a").rate, f.state("b").symbol);
    EXPECT_EQ(f.state("b").rate, -f.state("a").symbol);
}

TEST(FirstOrderSystem, LinearOnceExpanded) {
    const FirstOrderSystem f = solved(pair_system("(a'+1)*(a'-1) - a'^2 + 3*a' = a", "b' = a'^2"));
    const ex a = f.state("a").symbol;
    EXPECT_EQ(f.state("a").rate, (a + 1) / 3);
    EXPECT_TRUE((f.state("b").rate - (a + 1) * (a + 1) / 9).expand().is_zero());
}

TEST(FirstOrderSystem, RefusesWhatIsNotLinear) {
    EXPECT_EQ(
        system_message(pair_system("a'' + a'*b''^2 = 0", "b'' = a''*b + sin(a'')")),
        "2 system.toml:7:15: equations.a: an equation is linear in the highest derivatives, once the known "
        "rates are put in\n"
        "    a = \"a'' + a'*b''^2 = 0\"\n"
        "                  ^\n"
        "  found: b''\n"
        "  hint:  solve it for b'' by hand, or introduce a variable for its lower derivative");
}

TEST(FirstOrderSystem, RefusesASingularMatrix) {
    EXPECT_EQ(system_message(pair_system("a'' + b'' = a", "2*a'' + 2*b'' = b")),
              "2 system.toml:7:6: equations.a: the equations cannot be solved for the highest derivatives\n"
              "    a = \"a'' + b'' = a\"\n"
              "         ^\n"
              "  found: the determinant of their coefficients is not known to differ from zero\n"
              "  hint:  correct or simplify the equations");
}

// Each equation is harmless; put into one another they make 2^(1000^6).
TEST(FirstOrderSystem, RefusesTowersOfPowers) {
    std::string variables, equations = "a0 = \"a0' = 2\"\n";
    for (int k = 1; k <= 6; ++k) {
        const std::string before = "a" + std::to_string(k - 1), name = "a" + std::to_string(k);
        equations += name + " = \"" + name + "' = " + before + "'^1000\"\n";
    }
    for (int k = 0; k <= 6; ++k) variables += "a" + std::to_string(k) + " = { role = \"drift\" }\n";
    const std::string message =
        system_message("[system]\nname = \"s\"\n[variables]\n" + variables + "[equations]\n" + equations);
    EXPECT_NE(message.find("an equation stays moderate when the other rates are put in"), std::string::npos)
        << message;
}

} // namespace
} // namespace resonform
