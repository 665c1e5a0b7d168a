// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints with prescribed motions that do not rest at eps = 0: integrability with the time direction.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

// x slides as `constraint` says, s turns uniformly.
std::string turning(const std::string& constraint, const std::string& more = "") {
    return "[system]\nname = \"turning\"\n[parameters]\nm = { positive = true }\n"
           "V = { positive = true }\n[variables]\ny = { role = \"fast\" }\ns = { role = \"angle\" }\n"
           "tau = { role = \"slow\" }\n"
           "[coordinates]\nx = {}\ny = {}\n[prescribed]\ns = \"s' = V\"\ntau = \"tau' = eps\"\n"
           "[particles]\np = { mass = \"m\", position = [\"x\", \"y\"] }\n"
           "[energy]\npotential = \"m*y^2/2\"\n[constraints]\nc = \"" +
           constraint + "\"\n" + more;
}

std::vector<std::string> constants_of(const std::string& constraint, const std::string& more = "") {
    const System system = read_system_text(turning(constraint, more), "system.toml");
    std::vector<std::string> lines = section(system.derivation->constraints, "constants of these").equations;
    lines.push_back(system.equations.back().text);
    return lines;
}

// d(x - sin(s)*y) = -V*cos(s)*y dt
TEST(MovingConstraints, AreNotIntegrableWhereTheySlideWithTime) {
    EXPECT_EQ(
        system_message(turning("x' = sin(s)*y'")),
        "3 system.toml:21:6: constraints.c: the constraints are integrable at eps = 0\n"
        "    c = \"x' = sin(s)*y'\"\n"
        "         ^\n"
        "  found: the Frobenius term of x' for (y, time) is -V*cos(s)\n"
        "  hint:  scale what cannot be integrated by eps: the method is for weakly nonholonomic systems");
    // At rest it is integrable.
    EXPECT_EQ(system_message(turning("x' = sin(tau)*y'")), "");
}

TEST(MovingConstraints, AreNotIntegrableWhereTheyDriveByPosition) {
    EXPECT_NE(system_message(turning("x' = V*y + eps*y'")).find("of x' for (y, time) is V\n"),
              std::string::npos);
}

TEST(MovingConstraints, HaveConstantsThatHoldWhatMoves) {
    EXPECT_EQ(constants_of("x' = s'*cos(s) + eps*y*y'"),
              (std::vector<std::string>{"R_x = -sin(s) + x", "R_x' = eps*y*y'"}));
    EXPECT_EQ(constants_of("x' = V*cos(s) + eps*y*y'"),
              (std::vector<std::string>{"R_x = -sin(s) + x", "R_x' = eps*y*y'"}));
    EXPECT_EQ(constants_of("x' = sin(s)*y' + s'*y*cos(s) + eps*tau*y'"),
              (std::vector<std::string>{"R_x = -y*sin(s) + x", "R_x' = eps*tau*y'"}));
}

TEST(MovingConstraints, TakeAnIntegralThatIsConstantAlongTime) {
    const std::string constraint = "x' = s'*cos(s) + eps*y*y'";
    EXPECT_EQ(constants_of(constraint, "[integrals]\nR = \"x - sin(s)\"\n").back(), "R' = eps*y*y'");
    EXPECT_NE(system_message(turning(constraint, "[integrals]\nR = \"x\"\n"))
                  .find("its derivative holds (V*cos(s))\n"),
              std::string::npos);
}

} // namespace
} // namespace resonform
