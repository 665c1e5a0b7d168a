// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad mechanism and its whole message.
#include "mechanisms.hpp"

#include <sstream>

namespace resonform {
namespace {

const std::string rolling_mechanism = "[system]\n"
                                      "name = \"mechanism\"\n"
                                      "[parameters]\n"
                                      "m = { positive = true }\n"
                                      "r = { positive = true }\n"
                                      "[variables]\n"
                                      "psi = { role = \"fast\" }\n"
                                      "xi = { role = \"slow\" }\n"
                                      "y = {}\n"
                                      "[coordinates]\n"
                                      "x = {}\n"
                                      "y = {}\n"
                                      "[prescribed]\n"
                                      "xi = \"xi' = eps\"\n"
                                      "[particles]\n"
                                      "p = { mass = \"m\", position = [\"x\", \"y\"] }\n"
                                      "[energy]\n"
                                      "potential = \"m*(x - xi)^2\"\n"
                                      "[constraints]\n"
                                      "a = \"y' = eps*x*x'\"\n"
                                      "[change]\n"
                                      "x = \"psi + xi\"\n";

TEST(BadMechanism, TheGoodOneIsGood) {
    EXPECT_EQ(system_message(rolling_mechanism), "");
    // What is constant at eps = 0 need not be declared.
    EXPECT_EQ(system_message(edited(rolling_mechanism, "y = {}\n[coordinates]", "[coordinates]")), "");
}

// Mechanisms that are nonholonomic at eps = 0.
std::string free_mechanism(const std::string& coordinates, const std::string& lagrangian,
                           const std::string& constraints) {
    std::string text = "[system]\nname = \"mechanism\"\n[parameters]\nm = { positive = true }\n"
                       "r = { positive = true }\nJ = { positive = true }\n[variables]\n";
    std::istringstream names(coordinates);
    std::string list;
    for (std::string name; names >> name;) list += name + " = {}\n";
    return text + list + "[coordinates]\n" + list + "[energy]\nlagrangian = \"" + lagrangian +
           "\"\n[constraints]\n" + constraints;
}

TEST(NonholonomicAtEpsZero, TheSleighOfChaplygin) {
    EXPECT_EQ(
        system_message(free_mechanism("x y theta", "m/2*(x'^2 + y'^2) + J/2*theta'^2",
                                      "edge = \"x'*sin(theta) = y'*cos(theta)\"\n")),

        "3 system.toml:18:9: constraints.edge: the constraints are integrable at eps = 0\n"
        "    edge = \"x'*sin(theta) = y'*cos(theta)\"\n"
        "            ^\n"
        "  found: the Frobenius term of x' for (y, theta) is -1/(cos(theta)^2 - 1)\n"
        "  hint:  scale what cannot be integrated by eps: the method is for weakly nonholonomic systems");
}

TEST(NonholonomicAtEpsZero, TheRollingDisc) {
    EXPECT_EQ(
        system_message(free_mechanism("x y theta phi", "m/2*(x'^2 + y'^2) + J/2*theta'^2 + m*r^2/4*phi'^2",
                                      "along = \"x' = r*phi'*cos(theta)\"\n"
                                      "across = \"y' = r*phi'*sin(theta)\"\n")),

        "3 system.toml:20:10: constraints.along: the constraints are integrable at eps = 0\n"
        "    along = \"x' = r*phi'*cos(theta)\"\n"
        "             ^\n"
        "  found: the Frobenius term of x' for (theta, phi) is -r*sin(theta)\n"
        "  hint:  scale what cannot be integrated by eps: the method is for weakly nonholonomic systems");
}

// Angular velocity by Euler's angles.
TEST(NonholonomicAtEpsZero, TheRollingBall) {
    EXPECT_EQ(
        system_message(
            free_mechanism("x y psi theta phi",
                           "m/2*(x'^2 + y'^2) + J/2*(psi'^2 + theta'^2 + phi'^2 + 2*psi'*phi'*cos(theta))",
                           "along = \"x' = r*(theta'*sin(psi) - phi'*sin(theta)*cos(psi))\"\n"
                           "across = \"y' = -r*(theta'*cos(psi) + phi'*sin(theta)*sin(psi))\"\n")),

        "3 system.toml:22:10: constraints.along: the constraints are integrable at eps = 0\n"
        "    along = \"x' = r*(theta'*sin(psi) - phi'*sin(theta)*cos(psi))\"\n"
        "             ^\n"
        "  found: the Frobenius term of x' for (psi, theta) is r*cos(psi)\n"
        "  hint:  scale what cannot be integrated by eps: the method is for weakly nonholonomic systems");
}

class BadMechanisms : public testing::TestWithParam<BadInput> {};

TEST_P(BadMechanisms, IsRefusedInOneMessage) {
    const BadInput& bad = GetParam();
    EXPECT_EQ(system_message(edited(rolling_mechanism, bad.from, bad.to)), bad.message);
}

const BadInput bad_mechanisms[] = {
    {"DependentConstraints",
     "y = {}\n[prescribed]\nxi = \"xi' = eps\"\n[particles]\np = { mass = \"m\", position = [\"x\", \"y\"] "
     "}\n[energy]\npotential = \"m*(x - xi)^2\"\n[constraints]\n",
     "y = {}\nw = {}\n[prescribed]\nxi = \"xi' = eps\"\n[particles]\np = { mass = \"m\", position = [\"x\", "
     "\"y\", \"w\"] }\n[energy]\npotential = \"m*(x - xi)^2\"\n[constraints]\nb = \"2*y' = 2*eps*x*x'\"\n",

     "2 system.toml:22:6: constraints.a: constraints are independent of each other\n"
     "    a = \"y' = eps*x*x'\"\n"
     "         ^\n"
     "  found: 'a' follows from those before it\n"
     "  hint:  leave it out, or correct it"},
    {"Positional", "y' = eps*x*x'", "y = eps*x^2/2",
     "2 system.toml:20:6: constraints.a: the constraint holds no velocity\n"
     "    a = \"y = eps*x^2/2\"\n"
     "         ^\n"
     "  found: 'a' holds none\n"
     "  hint:  differentiate it: x = f(y) is x' = f'(y)*y', with the integral x - f(y)"},
    {"Contradictory",
     "y = {}\n[prescribed]\nxi = \"xi' = eps\"\n[particles]\np = { mass = \"m\", position = [\"x\", \"y\"] "
     "}\n[energy]\npotential = \"m*(x - xi)^2\"\n[constraints]\n",
     "y = {}\nw = {}\n[prescribed]\nxi = \"xi' = eps\"\n[particles]\np = { mass = \"m\", position = [\"x\", "
     "\"y\", \"w\"] }\n[energy]\npotential = \"m*(x - xi)^2\"\n[constraints]\nb = \"2*y' = 2*eps*x*x' + "
     "1\"\n",

     "2 system.toml:22:6: constraints.a: constraints do not contradict each other\n"
     "    a = \"y' = eps*x*x'\"\n"
     "         ^\n"
     "  found: 'a' contradicts those before it\n"
     "  hint:  correct it"},
    {"Quadratic", "eps*x*x'\"", "eps*x*x'^2\"",
     "3 system.toml:20:6: constraints.a: the constraint is neither linear nor affine in the velocities\n"
     "    a = \"y' = eps*x*x'^2\"\n"
     "         ^\n"
     "  found: -eps*x*x'^2\n"
     "  hint:  write constraints a*x' + b*y' + c = 0, with a, b, c free of velocities"},
    {"AsManyAsCoordinates", "a = \"y' = eps*x*x'\"", "a = \"y' = eps*x*x'\"\nb = \"x' = eps\"",
     "2 system.toml:21:6: constraints.b: the mechanism has as many constraints as coordinates, or more\n"
     "    b = \"x' = eps\"\n"
     "         ^\n"
     "  found: 2 constraints, 2 coordinates\n"
     "  hint:  leave out constraints, or prescribe coordinates"},
    {"RankFalls", "y' = eps*x*x'", "eps*y' = eps^2*x*x'",
     "3 system.toml:20:6: constraints.a: constraints are independent at eps = 0\n"
     "    a = \"eps*y' = eps^2*x*x'\"\n"
     "         ^\n"
     "  found: 'a' holds no velocity there\n"
     "  hint:  divide it by a power of eps"},
    {"NoMass", "[\"x\", \"y\"]", "[\"0\", \"0\"]",
     "2 system.toml:10:1: coordinates: the matrix of the accelerations is singular\n"
     "    [coordinates]\n"
     "    ^\n"
     "  found: its determinant is zero\n"
     "  hint:  give every coordinate a mass, or leave it out"},
    {"NoMassAtTheOrigin", "[\"x\", \"y\"]", "[\"(x - xi)^2\", \"0\"]",
     "2 system.toml:10:1: coordinates: the matrix of the accelerations is singular where the equations are "
     "expanded\n"
     "    [coordinates]\n"
     "    ^\n"
     "  found: its determinant is zero there\n"
     "  hint:  choose other coordinates, or another point by [change]"},
    {"PoleAtTheOrigin", "position = [\"x\", \"y\"] }\n[energy]\npotential = \"m*(x - xi)^2\"",
     "position = [\"log(x - xi)\", \"y\"] }\n[energy]\npotential = \"m*x^2\"",
     "2 system.toml:10:1: coordinates: nothing is divided by an expression that is zero at the origin\n"
     "    [coordinates]\n"
     "    ^\n"
     "  found: (eps^2*m*psi^4 + 2*eps^2*m*xi*psi^3 + eps^2*m*xi^2*psi^2 + m...\n"
     "  hint:  choose other coordinates, or another origin by [change]"},
    {"NotInvertible", "psi + xi", "psi^2 + xi",
     "2 system.toml:22:6: change.x: a change of variables is invertible where the equations are expanded\n"
     "    x = \"psi^2 + xi\"\n"
     "         ^\n"
     "  found: the determinant of its derivatives is zero at the origin of the new variables\n"
     "  hint:  correct it, or choose another origin"},
    {"NoChange", "[change]\nx = \"psi + xi\"\n", "",
     "2 system.toml:7:1: variables.psi: each variable of a mechanism is a coordinate, prescribed, an "
     "integral, a quasi-velocity, or new in [change], which has one new variable for each coordinate that it "
     "replaces\n"
     "    psi = { role = \"fast\" }\n"
     "    ^\n"
     "  found: new: psi; coordinates replaced: 0\n"
     "  hint:  correct the names, or write [change]"},
    {"UnknownCoordinate", "(x - xi)^2", "(z - xi)^2",
     "2 system.toml:18:17: energy.potential: unknown symbol\n"
     "    potential = \"m*(z - xi)^2\"\n"
     "                    ^\n"
     "  found: z\n"
     "  hint:  did you mean 'm'? Known are: eps, m, r, x, xi, y"},
    {"WrongRole", "y = {}\n[coordinates]", "y = { role = \"fast\" }\n[coordinates]",
     "2 system.toml:9:1: variables.y: what is constant at eps = 0 is slow where something depends on it, "
     "else a drift\n"
     "    y = { role = \"fast\" }\n"
     "    ^\n"
     "  found: 'y' is fast\n"
     "  hint:  write role = \"drift\", or leave the role out"},
    {"MissingRole", "psi = { role = \"fast\" }", "psi = {}",
     "2 system.toml:7:1: variables.psi: a variable that is not constant at eps = 0 has no role\n"
     "    psi = {}\n"
     "    ^\n"
     "  found: 'psi'\n"
     "  hint:  write role = \"fast\", \"angle\" or \"slow\""},
    {"PrescribedByItsSquare", "xi' = eps", "xi'^2 = eps",
     "2 system.toml:14:7: prescribed.xi: what is prescribed is given by its velocity\n"
     "    xi = \"xi'^2 = eps\"\n"
     "          ^\n"
     "  found: 'xi'^2 = eps'\n"
     "  hint:  write xi' = ... in prescribed coordinates, parameters and eps"},
    {"EquationsAsWell", "[change]", "[equations]\ny = \"y' = 0\"\n[change]",
     "2 system.toml:21:1: equations: the equations of a mechanism are derived\n"
     "    [equations]\n"
     "    ^\n"
     "  found: [equations]\n"
     "  hint:  remove this table, or [coordinates]"},
    {"ForceOnNothing", "[constraints]", "[forces]\nq = \"1\"\n[constraints]",
     "2 system.toml:20:1: forces.q: a generalised force belongs to a coordinate\n"
     "    q = \"1\"\n"
     "    ^\n"
     "  found: 'q'\n"
     "  hint:  did you mean 'x'? Known are: x, y"},
    {"LagrangianAsWell", "[constraints]", "lagrangian = \"x'^2\"\n[constraints]",
     "2 system.toml:19:15: energy.lagrangian: a mechanism has a Lagrangian, or particles, bodies and a "
     "potential\n"
     "    lagrangian = \"x'^2\"\n"
     "                  ^\n"
     "  found: \"x'^2\"\n"
     "  hint:  leave out one of the two"},
    {"NoPosition", ", position = [\"x\", \"y\"]", "",
     "2 system.toml:16:1: particles.p: a position is an array of 2 or 3 expressions, in an inertial frame\n"
     "    p = { mass = \"m\" }\n"
     "    ^\n"
     "  found: 'p'\n"
     "  hint:  write position = [\"x\", \"y\", \"z\"]"},
    {"OnePosition", "[\"x\", \"y\"]", "[\"x\"]",
     "2 system.toml:16:30: particles.p.position: a position is an array of 2 or 3 expressions, in an "
     "inertial frame\n"
     "    p = { mass = \"m\", position = [\"x\"] }\n"
     "                                 ^\n"
     "  found: 'p'\n"
     "  hint:  write position = [\"x\", \"y\", \"z\"]"},
    {"TwoMoments", "[energy]",
     "[bodies]\nb = { mass = \"m\", position = [\"x\", \"y\", \"0\"], inertia = [\"m\", \"m\"], attitude = "
     "[\"x\", \"y\", \"0\"] }\n[energy]",
     "2 system.toml:18:57: bodies.b.inertia: a body in space needs three principal moments of inertia and "
     "three Euler angles\n"
     "    b = { mass = \"m\", position = [\"x\", \"y\", \"0\"], inertia = [\"m\", \"m\"], attitude = [\"x\", "
     "\"y\", \"0\"] }\n"
     "                                                            ^\n"
     "  found: 'b'\n"
     "  hint:  write inertia = [\"A\", \"B\", \"C\"], attitude = [\"psi\", \"theta\", \"phi\"]"},
    {"NoCoordinates", "[coordinates]\nx = {}\ny = {}\n", "",
     "2 system.toml:10:1: prescribed: the mechanism has no table [coordinates]\n"
     "    [prescribed]\n"
     "    ^\n"
     "  found: [prescribed] without it\n"
     "  hint:  declare coordinates, as x = { unit = \"m\" }"},
    {"NegativeMass", "mass = \"m\"", "mass = \"-m*r\"",
     "2 system.toml:16:15: particles.p.mass: a mass is not negative\n"
     "    p = { mass = \"-m*r\", position = [\"x\", \"y\"] }\n"
     "                  ^\n"
     "  found: \"-m*r\"\n"
     "  hint:  correct its sign"},
    {"NegativeMoment", "[energy]",
     "[bodies]\nb = { mass = \"m\", position = [\"x\", \"y\"], inertia = \"-1\", angle = \"x\" }\n[energy]",
     "2 system.toml:18:53: bodies.b.inertia: a moment of inertia is not negative\n"
     "    b = { mass = \"m\", position = [\"x\", \"y\"], inertia = \"-1\", angle = \"x\" }\n"
     "                                                        ^\n"
     "  found: \"-1\"\n"
     "  hint:  correct its sign"},
    {"RootOfAQuotient", "m*(x - xi)^2", "m*sqrt(r + x^2/(r - xi))",
     "3 system.toml:18:14: energy.potential: the denominator under a root is proved positive\n"
     "    potential = \"m*sqrt(r + x^2/(r - xi))\"\n"
     "                 ^\n"
     "  found: -xi + r\n"
     "  hint:  declare what it is made of positive"},
    {"NoIntegral", "[change]", "[integrals]\nR = \"y + x\"\n[change]",
     "2 system.toml:22:6: integrals.R: an integral is constant at eps = 0\n"
     "    R = \"y + x\"\n"
     "         ^\n"
     "  found: its derivative holds (1)*x'\n"
     "  hint:  correct it"},
};

TEST(BadMechanism, WithConstraintsWhoseRankFallsAtTheOrigin) {
    EXPECT_EQ(system_message("[system]\nname = \"m\"\n[variables]\nx = { role = \"fast\" }\ny = { role = "
                             "\"fast\" }\n[coordinates]\nx = {}\ny = {}\nz = {}\n[particles]\np = { mass = "
                             "\"1\", position = [\"x\", \"y\", \"z\"] }\n[energy]\npotential = \"x^2 + "
                             "y^2\"\n[constraints]\nc = \"x*z' = eps*y*y'\"\n"),
              "3 system.toml:15:6: constraints.c: the rank of the constraints falls at the origin, where the "
              "equations are expanded\n"
              "    c = \"x*z' = eps*y*y'\"\n"
              "         ^\n"
              "  found: z' = eps*y*y'/x\n"
              "  hint:  choose another origin by [change], or another constraint");
}

INSTANTIATE_TEST_SUITE_P(All, BadMechanisms, testing::ValuesIn(bad_mechanisms), name_of);

} // namespace
} // namespace resonform
