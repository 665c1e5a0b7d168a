// SPDX-License-Identifier: GPL-3.0-or-later
// Quasi-velocities: the equations of Gibbs and Appell in them, the same system with and without, and what is
// no quasi-velocity.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

std::string knife_edge() { return read_text(source_dir() / "systems/steered_knife_edge/system.toml"); }

const std::string along_the_edge = "[quasi_velocities]\n"
                                   "u = \"x'*cos(eps*theta) + y'*sin(eps*theta)\"\n"
                                   "w = \"theta'\"\n";

std::string with_table(const std::string& file, const std::string& table) {
    return edited(file, "[energy]\n", table + "[energy]\n");
}

std::vector<std::string> lines(const std::string& file, const std::string& heading) {
    return section(read_system_text(file, "system.toml").derivation->accelerations, heading).equations;
}

using Lines = std::vector<std::string>;

// The velocity along the edge feels the spring's force along the edge and nothing else; the heading nothing
// of the sledge.
TEST(QuasiVelocities, OfAKnifeEdge) {
    const std::string file = with_table(knife_edge(), along_the_edge);
    EXPECT_EQ(lines(file, "velocities in these"),
              (Lines{"x' = cos(eps*theta)*u", "y' = sin(eps*theta)*u", "theta' = w"}));
    EXPECT_EQ(lines(file, "energy of accelerations in these"),
              Lines{"S = m*u'^2/2 + J*w'^2/2 + eps^2*m*u^2*w^2/2"});
    EXPECT_EQ(lines(file, "equations of Gibbs and Appell"),
              (Lines{"m*u' + c*x*cos(eps*theta) = 0", "J*w' + k*theta = 0"}));
    EXPECT_EQ(lines(file, "accelerations"), (Lines{"u' = -c*x*cos(eps*theta)/m", "w' = -k*theta/J"}));
}

// They change what is printed, not the system.
TEST(QuasiVelocities, LeaveTheEquationsAsTheyAre) {
    const System with = read_system_text(with_table(knife_edge(), along_the_edge), "system.toml");
    const System without = read_system_text(knife_edge(), "system.toml");
    ASSERT_EQ(with.equations.size(), without.equations.size());
    for (std::size_t k = 0; k < with.equations.size(); ++k)
        EXPECT_EQ(with.equations[k].text, without.equations[k].text);
}

TEST(QuasiVelocities, StandWhereVelocitiesDo) {
    const std::string plain = with_table(knife_edge(), along_the_edge);
    const std::string damped = edited(edited(plain, "[parameters]", "[parameters]\nb = { unit = \"kg/s\" }"),
                                      "k*theta^2/2\"", "k*theta^2/2\"\ndissipation = \"b*u^2/2\"");
    EXPECT_EQ(lines(damped, "equations of Gibbs and Appell").at(0), "m*u' + b*u + c*x*cos(eps*theta) = 0");
    const std::string dragged = edited(edited(plain, "[parameters]", "[parameters]\nb = { unit = \"kg/s\" }"),
                                       "[constraints]", "[forces]\nu = \"-b*u\"\n[constraints]");
    EXPECT_EQ(lines(dragged, "accelerations"), lines(damped, "accelerations"));
    const std::string by_constraint = edited(plain, "y' = tan(eps*theta)*x'", "y' = u*sin(eps*theta)");
    EXPECT_EQ(lines(by_constraint, "accelerations"), lines(plain, "accelerations"));
    const std::string force = edited(plain, "[constraints]", "[forces]\ntheta = \"-J*w/1\"\n[constraints]");
    EXPECT_NE(system_message(force).find("units fit together"), std::string::npos); // J*w is no torque
}

// With both as variables, x' and theta' are given by them.
TEST(QuasiVelocities, AreVariablesIfTheyAreDeclared) {
    const std::string file = edited(with_table(knife_edge(), along_the_edge), "y = { unit = \"m\" }",
                                    "y = { unit = \"m\" }\nu = { role = \"fast\", weight = 0 }\n"
                                    "w = { role = \"fast\", weight = 0 }");
    const System system = read_system_text(file, "system.toml");
    Lines texts;
    for (const Equation& equation : system.equations) texts.push_back(equation.text);
    EXPECT_EQ(texts, (Lines{"x' = cos(eps*theta)*u", "theta' = w", "y' = sin(eps*theta)*u",
                            "u' = -c*x*cos(eps*theta)/m", "w' = -k*theta/J"}));
    EXPECT_EQ(system_message(edited(file, "w = { role = \"fast\", weight = 0 }\n", "")),
              "2 system.toml:28:1: quasi_velocities.w: all quasi-velocities are variables, or none\n"
              "    w = \"theta'\"\n"
              "    ^\n"
              "  found: 'w' is none\n"
              "  hint:  declare it under [variables], too");
}

// (14) after w = phi': psi' = w - (atan(xi/r))'
TEST(QuasiVelocities, GoWithAChangeOfVariables) {
    const std::string file =
        edited(with_table(read_text(source_dir() / "systems/pendulum_mechanism/system.toml"),
                          "[quasi_velocities]\nw = \"phi'\"\n"),
               "[coordinates]", "w = { role = \"fast\" }\n[coordinates]");
    const System system = read_system_text(file, "system.toml");
    EXPECT_EQ(system.equations.front().text, "psi' - w + r*xi'/(xi^2 + r^2) = 0");
    EXPECT_EQ(system.equations.back().text, "w' = -xi*xi'*w/(xi^2 + r^2) - g*sin(psi)/sqrt(xi^2 + r^2)");
}

// A coordinate that runs on is an angle where its velocity is slow.
TEST(QuasiVelocities, MakeARotationSlow) {
    const System system = read_system_text(
        "[system]\nname = \"bead\"\n[parameters]\nm = { positive = true }\nl = { positive = true }\nb = {}\n"
        "[variables]\nphi = { role = \"angle\" }\nw = { role = \"slow\", positive = true }\n"
        "[coordinates]\nphi = {}\n[quasi_velocities]\nw = \"phi'\"\n[particles]\n"
        "bead = { mass = \"m\", position = [\"l*sin(phi)\", \"-l*cos(phi)\"] }\n[energy]\n"
        "potential = \"-eps*m*l*cos(phi)\"\ndissipation = \"eps*b*m*w^2/2\"\n",
        "system.toml");
    EXPECT_EQ(system.equations[0].text, "phi' = w");
    EXPECT_EQ(system.equations[1].text, "w' = -eps*b*w/l^2 - eps*sin(phi)/l");
    EXPECT_EQ(system.variable("w")->role, Role::slow);
}

TEST(QuasiVelocities, ThatAreNone) {
    const auto message = [](const std::string& table) {
        return system_message(with_table(knife_edge(), "[quasi_velocities]\n" + table));
    };
    EXPECT_EQ(message("u = \"x'*theta'\"\nw = \"theta'\"\n"),
              "2 system.toml:26:6: quasi_velocities.u: the quasi-velocity is neither linear nor affine in "
              "the velocities\n"
              "    u = \"x'*theta'\"\n"
              "         ^\n"
              "  found: x'*theta'\n"
              "  hint:  write it as a*x' + b*y' with a, b free of velocities");
    EXPECT_EQ(message("u = \"x'\"\n"), "2 system.toml:26:6: quasi_velocities.u: the mechanism has neither as "
                                       "many quasi-velocities as degrees of freedom nor none\n"
                                       "    u = \"x'\"\n"
                                       "         ^\n"
                                       "  found: 1 quasi-velocities, 2 degrees of freedom\n"
                                       "  hint:  name velocities of coordinates, too, as in w = \"theta'\"");
    // By the constraint both are multiples of x'.
    EXPECT_EQ(
        message("u = \"x'\"\nw = \"y'\"\n"),
        "2 system.toml:26:6: quasi_velocities.u: quasi-velocities are independent of each other and of the "
        "constraints\n"
        "    u = \"x'\"\n"
        "         ^\n"
        "  found: the determinant of their coefficients is zero\n"
        "  hint:  replace one of them");
    EXPECT_EQ(message("m = \"x'\"\nw = \"theta'\"\n"),
              "2 system.toml:26:1: quasi_velocities.m: the name is used twice\n"
              "    m = \"x'\"\n"
              "    ^\n"
              "  found: 'm' is a parameter already\n"
              "  hint:  rename one of the two");
    EXPECT_EQ(message("x = \"x'\"\nw = \"theta'\"\n"),
              "2 system.toml:26:1: quasi_velocities.x: the name of the quasi-velocity is taken\n"
              "    x = \"x'\"\n"
              "    ^\n"
              "  found: 'x' is a coordinate or prescribed\n"
              "  hint:  choose another name");
    EXPECT_NE(message("u = \"x\"\nw = \"theta'\"\n").find("determinant"), std::string::npos);
}

// Quasi-velocities make no sleigh weakly nonholonomic.
TEST(QuasiVelocities, LeaveTheSleighOfChaplyginRefused) {
    EXPECT_EQ(system_message("[system]\nname = \"sleigh\"\n[parameters]\nm = { positive = true }\n"
                             "J = { positive = true }\n[variables]\nx = {}\ny = {}\ntheta = {}\n"
                             "[coordinates]\nx = {}\ny = {}\ntheta = {}\n[quasi_velocities]\n"
                             "u = \"x'*cos(theta) + y'*sin(theta)\"\nw = \"theta'\"\n[energy]\n"
                             "lagrangian = \"m/2*(x'^2 + y'^2) + J/2*theta'^2\"\n[constraints]\n"
                             "edge = \"x'*sin(theta) = y'*cos(theta)\"\n")
                  .find("3 system.toml:20:9: constraints.edge: the constraints are integrable at eps = 0"),
              0U);
}

} // namespace
} // namespace resonform
