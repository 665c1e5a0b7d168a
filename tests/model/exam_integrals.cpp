// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals of a file, solved together and by inverse functions for dependent coordinates.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

struct GivenIntegrals {
    std::string constraints, integrals, declared, more;
};

std::string space(const GivenIntegrals& given) {
    return "[system]\nname = \"space\"\n[parameters]\nm = { positive = true }\nk = { positive = true }\n"
           "[variables]\nx = { role = \"fast\" }\n" +
           given.declared +
           "[coordinates]\nx = {}\ny = {}\nz = {}\n"
           "[particles]\np = { mass = \"m\", position = [\"x\", \"y\", \"z\"] }\n"
           "[energy]\npotential = \"k*x^2/2\"\n[constraints]\n" +
           given.constraints + "[integrals]\n" + given.integrals + given.more;
}

std::string in_space(const GivenIntegrals& given, const std::string& variable) {
    return equation(read_system_text(space(given), "system.toml"), variable);
}

const std::string two_lines = "a = \"y' = x' + eps*x*x'\"\nb = \"z' = 2*x'\"\n";

TEST(JointIntegrals, AreSolvedTogether) {
    const System system = read_system_text(
        space({two_lines, "R = \"y + z - 3*x\"\nQ = \"y - z + x\"\n", "", ""}), "system.toml");
    EXPECT_EQ(equation(system, "x"),
              "eps^2*m*x^2*x'' + 2*eps*m*x*x'' + 6*m*x'' + eps^2*m*x*x'^2 + eps*m*x'^2 + k*x = 0");
    EXPECT_EQ(equation(system, "R"), "R' = eps*x*x'");
    EXPECT_EQ(equation(system, "Q"), "Q' = eps*x*x'");
}

TEST(JointIntegrals, AreSolvedOneInTheOther) {
    const GivenIntegrals given{"a = \"y' = -y*x' + eps*x'\"\nb = \"z' = y*x'\"\n",
                               "Q = \"z + y\"\nR = \"log(y) + x\"\n", "", ""};
    EXPECT_EQ(in_space(given, "R"), "R' = eps*exp(x)*x'/exp(R)"); // y = exp(R - x)
    EXPECT_EQ(in_space(given, "Q"), "Q' = eps*x'");
}

TEST(JointIntegrals, TakeWhatAChangeSays) {
    const std::string both = "R = \"y + z - 3*x\"\nQ = \"y - z + x\"\n";
    EXPECT_EQ(in_space({two_lines, both, "", "[change]\ny = \"(R + Q)/2 + x\"\n"}, "x"),
              in_space({two_lines, both, "", ""}, "x"));
    EXPECT_NE(system_message(space({two_lines, both, "", "[change]\ny = \"(R + Q)/2 + 2*x\"\n"}))
                  .find("change.y: a change of variables inverts the integral"),
              std::string::npos);
}

TEST(JointIntegrals, AreIndependent) {
    EXPECT_EQ(system_message(space({two_lines, "R = \"y + z - 3*x\"\nQ = \"2*y + 2*z - 6*x\"\n", "", ""})),
              "2 system.toml:21:6: integrals.Q: a constraint has two integrals\n"
              "    Q = \"2*y + 2*z - 6*x\"\n"
              "         ^\n"
              "  found: 'Q' is one more\n"
              "  hint:  leave it out");
}

// y' = slope(y)*x' + eps*x*x' with the integral f(y) - x.
GivenIntegrals curve(const std::string& slope, const std::string& f, const std::string& declared,
                     const std::string& more = "") {
    return {"a = \"y' = " + slope + "*x' + eps*x*x'\"\nb = \"z' = eps*x'\"\n", "R = \"" + f + " - x\"\n",
            declared, more};
}

TEST(InverseFunctions, AreUsedWhereTheirDomainIsProved) {
    const std::string positive = "R = { positive = true }\n", slow = "R = { role = \"slow\" }\n";
    const std::string right = "[domain]\npositive = [\"pi/2 - R\", \"pi/2 + R\"]\n";
    // R' = f'(y)*eps*x*x', in y = g(R + x)
    const auto rate = [](const GivenIntegrals& given) { return in_space(given, "R"); };
    EXPECT_EQ(rate(curve("exp(-y)", "exp(y)", positive)), "R' = eps*x^2*x' + eps*x*R*x'");
    EXPECT_EQ(rate(curve("(1 + y)^2", "y/(1 + y)", slow)),
              "R' = eps*x^3*x' + (2*eps*R - 2*eps)*x^2*x' + (eps*R^2 - 2*eps*R + eps)*x*x'");
    EXPECT_EQ(rate(curve("y^(-2)/3", "y^3", positive)), "R' = 3*eps*x*((x + R)^(1/3))^2*x'");
    EXPECT_NE(rate(curve("(1 + y^2)", "atan(y)", slow, right)), "none");
    EXPECT_NE(rate(curve("sqrt(1 - y^2)", "asin(y)", slow, right)), "none");
    EXPECT_NE(rate(curve("1/cosh(y)", "sinh(y)", slow)), "none");
    EXPECT_NE(rate(curve("2*sqrt(y)", "sqrt(y)", positive)), "none");
}

std::string found_in(const GivenIntegrals& given) {
    const std::string message = system_message(space(given));
    const std::size_t at = message.find("found: ");
    EXPECT_EQ(message.front(), '3') << message;
    return message.substr(at, message.find('\n', at) - at);
}

TEST(InverseFunctions, AreRefusedWhereItIsNot) {
    EXPECT_EQ(system_message(space(curve("exp(-y)", "exp(y)", "R = {}\n"))),
              "3 system.toml:21:6: integrals.R: an integral can be solved for a coordinate that it replaces\n"
              "    R = \"exp(y) - x\"\n"
              "         ^\n"
              "  found: for y where x + R > 0, which is not proved\n"
              "  hint:  solve it: write the coordinate as \"...\" in R under [change]");
    EXPECT_EQ(found_in(curve("(1 + y^2)", "atan(y)", "")),
              "found: for y where x + R + pi/2 > 0, which is not proved");
    EXPECT_EQ(found_in(curve("1/cos(y)", "sin(y)", "")),
              "found: for y where y + pi/2 > 0, which is not proved");
    EXPECT_EQ(found_in(curve("1/(2*y)", "y^2", "R = { positive = true }\n")),
              "found: for y where y > 0, which is not proved");
    EXPECT_EQ(found_in(curve("1/(1 + exp(y))", "y + exp(y)", "")), "found: not for y");
}

} // namespace
} // namespace resonform
