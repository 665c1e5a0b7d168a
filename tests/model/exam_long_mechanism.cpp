// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms of a few lines whose equations are long when they are multiplied out.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"
#include "model/text/enclosure.hpp"

namespace resonform {
namespace {

// A particle on z = x^2 + R at eps = 0; `fast` is the variable beside y.
System particle(const std::string& fast, const std::string& change) {
    return read_system_text("[system]\nname = \"m\"\n[parameters]\nm = { positive = true }\nc = { positive = "
                            "true }\n[variables]\n" +
                                fast +
                                " = { role = \"fast\" }\ny = { role = \"fast\" }\n[coordinates]\nx = {}\ny = "
                                "{}\nz = {}\n[particles]\np = { mass = \"m\", position = [\"x + x^2/2\", \"y "
                                "+ sin(x)\", \"z + sin(y)\"] }\n[energy]\npotential = \"c*(3*x^2 + y^2)\"\n"
                                "[constraints]\nk = \"z' = 2*x*x' + eps*(sinh(z)*x' + (x + z)*y')\"\n" +
                                change,
                            "system.toml");
}

// The value of an equation where x = 2*q + y^2 moves with q and y.
double value(const System& system, const std::string& variable, int point) {
    const GiNaC::numeric q(point, 7), q1(2, 5), q2(1, 3), y(3, 11), y1(-1, 2), y2(point, 9);
    GiNaC::exmap values{{system.eps, GiNaC::numeric(1, 8)}};
    for (const Parameter& p : system.parameters) values[p.symbol] = 2;
    const auto put_jet = [&](const std::string& name, const std::vector<GiNaC::ex>& jet) {
        const Variable* v = system.variable(name);
        for (std::size_t k = 0; v != nullptr && k < jet.size(); ++k) values[v->jet[k]] = jet[k];
    };
    put_jet("q", {q, q1, q2});
    put_jet("x", {2 * q + y * y, 2 * q1 + 2 * y * y1, 2 * q2 + 2 * y1 * y1 + 2 * y * y2});
    put_jet("y", {y, y1, y2});
    put_jet("R_z", {GiNaC::numeric(1, 4)});
    for (const Equation& e : system.equations)
        if (e.variable == variable) return nearest_double(enclose(e.residual, values).value());
    throw std::logic_error("no equation of " + variable);
}

TEST(LongEquations, StandAsAChangeOfVariablesLeavesThem) {
    const System changed = particle("q", "[change]\nx = \"2*q + y^2\"\n"), plain = particle("x", "");
    EXPECT_NE(equation(changed, "q").find("sinh((2*q + y^2)^2 + R_z)"), std::string::npos);
    for (const auto& [left, right] : {std::pair("q", "x"), std::pair("y", "y")}) {
        const double ratio = value(changed, left, 1) / value(plain, right, 1);
        EXPECT_NEAR(value(changed, left, 2), ratio * value(plain, right, 2), 1e-9);
    }
}

TEST(LongEquations, AreNotSolvedForTheAccelerations) {
    const System system = read_system_text(
        "[system]\nname = \"m\"\n[parameters]\nm = { positive = true }\nc = { positive = true }\n"
        "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[coordinates]\nx = {}\ny = {}\nz = "
        "{}\nw = {}\n[particles]\np0 = { mass = \"m\", position = [\"x + y^2/2\", \"y\", \"z + x*y/2\"] "
        "}\np1 "
        "= { mass = \"m\", position = [\"x\", \"y + x^2/2\", \"z\"] }\nq = { mass = \"m\", position = "
        "[\"w\", \"0\"] }\n[energy]\npotential = \"c*(x^2 + y^2)\"\n[constraints]\nkz = \"z' = (2 - y)*x' - "
        "x*y' + eps*(z + y)*x' + eps*w*x*y'\"\nkw = \"w' = eps*((y - x)*x' + y*y' + x)\"\n",
        "system.toml");
    EXPECT_NE(equation(system, "x").find("y''"), std::string::npos);
    EXPECT_EQ(system.derivation->accelerations.back().heading, "equations of Gibbs and Appell");
    EXPECT_EQ(system.derivation->agreement,
              (std::vector<std::string>{
                  "the accelerations are not written: solved, the equations are longer than a text may be",
                  "the equations of d'Alembert and Lagrange with multipliers agree, identically"}));
}

} // namespace
} // namespace resonform
