// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of variables that hold constants of the constraints, whose rates are of order eps.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

std::string changed(const std::string& constraint, const std::string& integrals, const std::string& change) {
    return "[system]\nname = \"changed\"\n[parameters]\nm = { positive = true }\nk = { positive = true }\n"
           "[variables]\npsi = { role = \"fast\" }\n[coordinates]\nx = {}\ny = {}\n"
           "[particles]\np = { mass = \"m\", position = [\"x\", \"y\"] }\n"
           "[energy]\npotential = \"k*x^2/2\"\n[constraints]\nc = \"" +
           constraint + "\"\n" + integrals + "[change]\n" + change;
}

// y' = B*x*x' and x = psi + R with R' = eps*x*x': x' = psi'/(1 - eps*x), psi'' = x'' - eps*(x'^2 + x*x''),
// x'' = -(k*x/m + B^2*x*x'^2)/(1 + B^2*x^2).
void expect_equations(const System& system, const std::string& r, const std::string& slope) {
    Comparison by_hand(system, {"psi", r}, {"m", "k"});
    const std::string x = "(psi + " + r + ")", velocity = "(psi'/(1 - eps*" + x + "))",
                      acceleration = "(-(k*" + x + "/m + " + slope + "^2*" + x + "*" + velocity +
                                     "^2)/(1 + " + slope + "^2*" + x + "^2))";
    EXPECT_EQ(by_hand.multiple(equation(system, "psi"),
                               "psi'' = " + acceleration + " - eps*(" + velocity + "^2 + " + x + "*" +
                                   acceleration + ")",
                               "psi''"),
              Zero::yes)
        << equation(system, "psi");
    EXPECT_EQ(by_hand.same(equation(system, r), r + "' = eps*" + x + "*" + velocity), Zero::yes)
        << equation(system, r);
}

TEST(ChangesWithConstants, HaveTheirRates) {
    expect_equations(read_system_text(changed("y' = eps*x*x'", "", "x = \"psi + y\"\n"), "system.toml"), "y",
                     "eps");
    const std::string bowl = "y' = (2 + eps)*x*x'", integral = "[integrals]\nR = \"y - x^2\"\n";
    expect_equations(read_system_text(changed(bowl, integral, "x = \"psi + R\"\n"), "system.toml"), "R",
                     "(2 + eps)");
    expect_equations(read_system_text(changed(bowl, integral, "x = \"psi + R\"\ny = \"R + (psi + R)^2\"\n"),
                                      "system.toml"),
                     "R", "(2 + eps)");
}

TEST(ChangesWithConstants, AreNoCircles) {
    EXPECT_EQ(system_message(
                  changed("y' = 2*x*x' + eps*x'", "[integrals]\nR = \"y - x^2\"\n", "x = \"psi + y\"\n")),
              "2 system.toml:20:6: change.x: what a change of variables replaces a coordinate by does not "
              "depend on "
              "this coordinate\n"
              "    x = \"psi + y\"\n"
              "         ^\n"
              "  found: x = psi + y, y = x^2 + R\n"
              "  hint:  write it in new variables, constants of the constraints and coordinates that stay");
}

TEST(ChangesWithConstants, InvertAnIntegral) {
    EXPECT_EQ(
        system_message(changed("y' = eps*x*x'", "", "y = \"psi + x\"\n")),
        "2 system.toml:18:6: change.y: what [change] says of a dependent coordinate inverts an integral "
        "of the file\n"
        "    y = \"psi + x\"\n"
        "         ^\n"
        "  found: 'y' is dependent, and has no integral\n"
        "  hint:  give it under [integrals], or leave the change out");
}

} // namespace
} // namespace resonform
