// SPDX-License-Identifier: GPL-3.0-or-later
// Systems about an equilibrium that is not the origin: the same as when they are shifted by hand, and printed
// in the user's variables.
#include "printed.hpp"
#include "solve/solve.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

using nlohmann::ordered_json;

ordered_json document(const std::string& toml, int order) {
    return ordered_json::parse(
        print_normal_form(*certified(field_from(toml), order), order, Format::json, nullptr));
}

// What a shift by hand and [equilibrium] must agree in.
void expect_same(const std::string& shifted, const std::string& declared, int order) {
    const ordered_json by_hand = document(shifted, order), about = document(declared, order);
    for (const char* key : {"normal_form", "map", "divisors"}) EXPECT_EQ(by_hand[key], about[key]) << key;
    EXPECT_TRUE(about["certificate"]["holds"].get<bool>());
    EXPECT_FALSE(by_hand.contains("equilibrium"));
}

const std::string constants = "[parameters]\nkappa = { positive = true }\nnu = {}\n";

std::string enzyme(const std::string& value) {
    return system_text(
        "enzyme",
        {{"s", "slow", "s' = eps*(-s + (s + kappa - nu)*c)"}, {"c", "fast", "c' = s - (s + kappa)*c"}},
        constants + "[domain]\npositive = [\"s\"]\n[equilibrium]\nc = \"" + value + "\"\n");
}

TEST(PrintedEquilibrium, TheEnzymeAsShiftedByHand) {
    const std::string by_hand =
        system_text("enzyme",
                    {{"s", "slow", "s' = eps*(-s + (s + kappa - nu)*(s/(s + kappa) + c))"},
                     {"c", "fast", "c' + kappa/(s + kappa)^2*s' = -(s + kappa)*c"}},
                    constants + "[domain]\npositive = [\"s\"]\n");
    expect_same(by_hand, enzyme("s/(s + kappa)"), 3);
    expect_same(by_hand, enzyme("solve"), 3);
    EXPECT_EQ(document(enzyme("solve"), 1)["equilibrium"], ordered_json({{"c", "s/(kappa + s)"}}));
    EXPECT_EQ(document(enzyme("solve"), 1)["fast"][0]["definition"], "(c - (s/(kappa + s)))");
}

TEST(PrintedEquilibrium, TheEnzymeInTheUsersVariables) {
    const std::string text =
        print_normal_form(*certified(field_from(enzyme("solve")), 1), 1, Format::text, nullptr);
    expect_part(text, "equilibrium at eps = 0:\n  c = s/(kappa + s)\n");
    expect_part(text, "  z1 = c - s/(kappa + s) + O(eps)\n");
    expect_part(text, "  c - s/(kappa + s) = z1");
    const System system = read_system_text(enzyme("solve"), "test/system.toml");
    const std::string equations = print_equations(system, Format::text);
    expect_part(equations, "about the equilibrium at eps = 0:\n  c = s/(kappa + s) + delta_c\n");
    expect_part(equations, "\n  delta_c' = ");
    EXPECT_EQ(ordered_json::parse(print_equations(system, Format::json))["equilibrium"],
              ordered_json({{"c", "s/(kappa + s)"}}));
    expect_part(print_expansion(*field_from(enzyme("solve")), 1, Format::text, nullptr),
                "c = s/(kappa + s) + delta_c\n");
}

// s - (s + kappa)*s/(s + kappa) vanishes, and is no term of the equation.
TEST(PrintedEquilibrium, WhatItSolvesIsNoTermOfTheExpansion) {
    const auto field = field_from(enzyme("solve"));
    const std::string text = print_expansion(*field, 1, Format::text, nullptr);
    expect_part(text, "\n-kappa*nu*s/(kappa + s)^3*eps + delta_c' + (kappa + s)*delta_c + O(eps^2) = 0\n");
    const auto fast = ordered_json::parse(print_expansion(*field, 1, Format::json, nullptr))["equations"][1];
    EXPECT_EQ(fast["variable"], "c");
    EXPECT_EQ(fast["terms"].size(), 3);
    for (const auto& term : fast["terms"]) EXPECT_NE(term["coefficient"], "0");
}

TEST(PrintedEquilibrium, AWellOfDuffing) {
    const auto well = [](const std::string& force, const std::string& tables) {
        return system_text("duffing", {{"x", "fast", "x'' = " + force}}, tables);
    };
    for (const std::string at : {"1", "-1"})
        expect_same(well("(x + (" + at + ")) - (x + (" + at + "))^3", ""),
                    well("x - x^3", "[equilibrium]\nx = \"" + at + "\"\n"), 5);
    const std::string declared = well("x - x^3", "[equilibrium]\nx = 1\n");
    const Solution solution = solve(certified(field_from(declared), 4), {3, 4});
    expect_part(print_solution(solution, Format::text), "  x = 1\n      + eps*amplitude_x*cos(theta)\n");
}

TEST(PrintedEquilibrium, APendulumAboutAMovingOne) {
    const std::string parameters = "[parameters]\ng = { positive = true }\n";
    const auto pendulum = [&](const std::string& equation, const std::string& tables) {
        return system_text("pendulum", {{"a", "slow", "a' = eps*a"}, {"x", "fast", equation}},
                           parameters + tables);
    };
    expect_same(pendulum("x'' + eps^2*a + g*sin(x) = 0", ""),
                pendulum("x'' + g*sin(x - a) = 0", "[equilibrium]\nx = \"a\"\n"), 4);
}

// H = p^2/2 - cos(x - k)*w^2: canonical about its minimum, too.
TEST(PrintedEquilibrium, OfAHamiltonianSystem) {
    const auto energy = [](const std::string& angle, const std::string& tables) {
        return "[system]\nname = \"h\"\n[parameters]\nw = { positive = true }\nk = {}\n[variables]\n"
               "x = { role = \"fast\" }\np = { role = \"fast\" }\n[hamiltonian]\nenergy = \"p^2/2 + w^2*(1 - "
               "cos(" +
               angle + "))\"\nmomenta = { x = \"p\" }\n" + tables;
    };
    expect_same(energy("x", ""), energy("x - k", "[equilibrium]\nx = \"k\"\n"), 4);
}

TEST(PrintedEquilibrium, TheSameEveryTime) {
    const auto once = [] {
        return print_normal_form(*certified(field_from(enzyme("solve")), 2), 2, Format::text, nullptr) +
               print_equations(read_system_text(enzyme("solve"), "test/system.toml"), Format::text);
    };
    const std::string first = once();
    for (int n = 0; n < 3; ++n) EXPECT_EQ(once(), first);
}

} // namespace
} // namespace resonform::test
