// SPDX-License-Identifier: GPL-3.0-or-later
// [equilibrium]: what is no equilibrium, what cannot be solved for, and what is found.
#include "messages.hpp"
#include "model/exact/equilibrium_shift.hpp"
#include "model/text/canonical.hpp"

namespace resonform {
namespace {

// Michaelis and Menten, with an entry for the fast variable c.
std::string enzyme(const std::string& entry) {
    return "[system]\nname = \"enzyme\"\n[parameters]\nkappa = { positive = true }\nnu = {}\n[variables]\n"
           "s = { role = \"slow\", positive = true }\nc = { role = \"fast\" }\n[equilibrium]\n" +
           entry +
           "\n[equations]\ns = \"s' = eps*(-s + (s + kappa - nu)*c)\"\nc = \"c' = s - (s + kappa)*c\"\n";
}

// One oscillator x with the right-hand side as given, and parameters.
std::string oscillator(const std::string& force, const std::string& entry,
                       const std::string& parameters = "") {
    return "[system]\nname = \"o\"\n[parameters]\n" + parameters +
           "[variables]\nx = { role = \"fast\" }\n[equilibrium]\n" + entry +
           "\n[equations]\nx = \"x'' = " + force + "\"\n";
}

// The equilibrium that is found, as it is spelled.
std::string found(const std::string& toml) {
    return spell(read_system_text(toml, "system.toml").equilibrium.front().value);
}

// The message behind its place: rule, value and hint.
testing::AssertionResult complains(const std::string& toml, const std::string& kind, const std::string& rule,
                                   const std::string& value) {
    const std::string message = system_message(toml);
    for (const std::string& part : {kind + " system.toml:", rule, "found: " + value, std::string("hint: ")})
        if (message.find(part) == std::string::npos)
            return testing::AssertionFailure() << "'" << part << "' is not in\n" << message;
    return testing::AssertionSuccess();
}

TEST(Equilibrium, TheWholeMessageOfAValueThatIsNone) {
    EXPECT_EQ(
        system_message(enzyme("c = \"s/(s + 2*kappa)\"")),
        "2 system.toml:10:6: equilibrium.c: what [equilibrium] gives is no equilibrium of the equations "
        "at eps = 0\n"
        "    c = \"s/(s + 2*kappa)\"\n"
        "         ^\n"
        "  found: c' = (2*kappa + s)^(-1)*kappa*s there\n"
        "  hint:  correct it, or write \"solve\"");
}

TEST(Equilibrium, BadKeysAndValues) {
    EXPECT_TRUE(complains(enzyme("d = \"s\""), "2", "names no variable of the system", "'d'"));
    EXPECT_TRUE(
        complains(enzyme("s = \"1\""), "2", "an equilibrium is one of fast variables", "'s' is slow"));
    EXPECT_TRUE(
        complains(enzyme("c = \"s + c\""), "2", "slow variables and parameters only: 'c' is fast", ""));
    EXPECT_TRUE(complains(enzyme("c = \"s + eps\""), "2", "does not hold eps", ""));
    EXPECT_TRUE(complains(enzyme("c = \"s/k\""), "2", "unknown symbol", "k"));
    EXPECT_TRUE(complains(enzyme("c = true"), "2", "equilibrium.c", ""));
    EXPECT_TRUE(complains(edited(enzyme("c = \"nu*s\""), "nu = {}", "nu = { weight = 1 }"), "2",
                          "'nu', a parameter with a weight, is 0", ""));
}

TEST(Equilibrium, DivisorsAndRootsAreProved) {
    EXPECT_TRUE(
        complains(edited(enzyme("c = \"s/(s + kappa)\""), "kappa = { positive = true }", "kappa = {}"), "3",
                  "is proved to be real and finite", ""));
    EXPECT_TRUE(complains(edited(enzyme("c = \"solve\""), "kappa = { positive = true }", "kappa = {}"), "3",
                          "divided by to solve for an equilibrium is proved to be nonzero", ""));
    const std::string declared =
        edited(enzyme("c = \"solve\""), "kappa = { positive = true }", "kappa = {}") +
        "[domain]\npositive = [\"s + kappa\"]\n";
    EXPECT_EQ(found(declared), found(enzyme("c = \"solve\"")));
    EXPECT_TRUE(complains(oscillator("k - x^2", "x = \"solve\"", "k = {}\n"), "3",
                          "the discriminant of a quadratic equation for 'x'", "4*k"));
}

TEST(Equilibrium, IsSolvedFor) {
    EXPECT_EQ(
        found(enzyme("c = \"solve\"")),
        spell(read_system_text(enzyme("c = \"s/(s + kappa)\""), "system.toml").equilibrium.front().value));
    EXPECT_EQ(found(oscillator("1 - x", "x = \"solve\"")), "1");
    EXPECT_EQ(found(oscillator("(x - 2)^2*(x^2 + 1)", "x = \"solve\"")), "2");
    EXPECT_EQ(found(oscillator("(k + 1)*(k - x)", "x = \"solve\"", "k = { positive = true }\n")), "k");
}

TEST(Equilibrium, SeveralAreListedInOneOrder) {
    EXPECT_EQ(system_message(oscillator("x - x^3", "x = \"solve\"")),
              "3 system.toml:7:6: equilibrium.x: \"solve\" finds one equilibrium at eps = 0\n"
              "    x = \"solve\"\n"
              "         ^\n"
              "  found: 3 of them: x = -1; x = 0; x = 1\n"
              "  hint:  write the one that is meant in place of \"solve\"");
    const std::string text = oscillator("k - x^2", "x = \"solve\"", "k = { positive = true }\n");
    EXPECT_TRUE(complains(text, "3", "finds one equilibrium", "2 of them: x = -k^(1/2); x = k^(1/2)"));
    for (int n = 0; n < 5; ++n) EXPECT_EQ(system_message(text), system_message(text));
}

TEST(Equilibrium, TwoVariablesAtOnce) {
    const std::string toml =
        "[system]\nname = \"two\"\n[parameters]\nk = { positive = true }\n[variables]\nx = { role = \"fast\" "
        "}\n"
        "y = { role = \"fast\" }\n[equilibrium]\nx = \"solve\"\ny = \"solve\"\n[equations]\n"
        "x = \"x' = -k*x + y + 1\"\ny = \"y' = x - 2*(k + 1)*y\"\n";
    // The determinant, 2 k (k + 1) - 1, has no sign.
    EXPECT_TRUE(complains(toml, "3", "proved to be nonzero", ""));
    const System system =
        read_system_text(edited(toml, "x - 2*(k + 1)*y", "-x - 2*(k + 1)*y"), "system.toml");
    const GiNaC::ex k = system.parameters.front().symbol, d = 2 * k * (k + 1) + 1;
    EXPECT_TRUE((system.equilibrium[0].value - 2 * (k + 1) / d).normal().is_zero());
    EXPECT_TRUE((system.equilibrium[1].value + 1 / d).normal().is_zero());
}

TEST(Equilibrium, WhatIsNotSolved) {
    EXPECT_TRUE(complains(oscillator("1 - x - x^3", "x = \"solve\""), "3", "\"solve\" is for equations",
                          "'x': a factor of its equation has degree 3 in it"));
    EXPECT_TRUE(complains(oscillator("1 - sin(x)", "x = \"solve\""), "3", "\"solve\" is for equations",
                          "'x': no equation is linear in it, or a polynomial in it alone"));
    EXPECT_TRUE(complains(oscillator("x^2 + 1", "x = \"solve\""), "2", "have an equilibrium at eps = 0",
                          "none was found"));
}

// z' = c' - d/dt s/(s + kappa)
TEST(Equilibrium, ItsMotionEntersTheRate) {
    const auto read =
        std::make_shared<const System>(read_system_text(enzyme("c = \"solve\""), "system.toml"));
    const auto from = std::make_shared<const FirstOrderSystem>(solve_for_highest(read));
    const auto to = about_equilibrium(from);
    EXPECT_EQ(about_equilibrium(to), to);
    const GiNaC::ex s = from->state("s").symbol, c = from->state("c").symbol, nu = read->parameters[1].symbol,
                    kappa = read->parameters[0].symbol, eps = read->eps, rest = s / (s + kappa);
    const GiNaC::ex slow = eps * (-s + (s + kappa - nu) * (rest + c));
    EXPECT_TRUE((to->state("s").rate - slow).normal().is_zero());
    EXPECT_TRUE(
        (to->state("c").rate + (s + kappa) * c + kappa / GiNaC::pow(s + kappa, 2) * slow).normal().is_zero());
    EXPECT_TRUE((to->state("c").shift - rest).normal().is_zero());
    EXPECT_TRUE(to->state("s").shift.is_zero());
}

// The velocity is measured from that of the equilibrium, which is known in slow variables or refused.
TEST(Equilibrium, VelocitiesOfMovingOnes) {
    const auto about = [](const std::string& rate) {
        return about_equilibrium(std::make_shared<const FirstOrderSystem>(
            solve_for_highest(std::make_shared<const System>(read_system_text(
                "[system]\nname = \"o\"\n[variables]\na = { role = \"slow\" }\nx = { role = \"fast\" }\n"
                "[equilibrium]\nx = \"a^2\"\n[equations]\na = \"a' = " +
                    rate + "\"\nx = \"x'' = a^2 - x\"\n",
                "system.toml")))));
    };
    const auto to = about("eps*a");
    const GiNaC::ex a = to->state("a").symbol, x = to->state("x").symbol, eps = to->system->eps;
    EXPECT_TRUE((to->state("x'").shift - 2 * eps * a * a).expand().is_zero());
    EXPECT_TRUE((to->state("x'").rate + x + 4 * eps * eps * a * a).expand().is_zero());
    EXPECT_THROW(about("eps*x"), Error);
    EXPECT_THROW(about("eps*x'"), Error);
}

} // namespace
} // namespace resonform
