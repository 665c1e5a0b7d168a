// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms of the paper: equations (4), (7)-(10) of the particle, (11)-(15) of the pendulum, exactly.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

TEST(ParticleOfThePaper, HasItsEquations) {
    const System system = system_named("nonholonomic_particle");
    Comparison paper(system, {"x", "y", "z"}, {"m", "c"});
    const auto& stages = *system.derivation;
    const auto lines = [&](const std::string& heading) {
        return section(stages.accelerations, heading).equations;
    };
    // (4)
    EXPECT_EQ(
        paper.same(section(stages.constraints, "constraints").equations.at(0), "z' = eps*(x'*y - y'*x)"),
        Zero::yes);
    EXPECT_EQ(section(stages.constraints, "at eps = 0, what is prescribed at rest").equations,
              std::vector<std::string>{"z' = 0"});
    // (7), (8), and S with the constraint
    EXPECT_EQ(paper.same(lines("energy of accelerations").at(0), "S = m/2*(x''^2 + y''^2 + z''^2)"),
              Zero::yes);
    EXPECT_EQ(paper.same(lines("the constraints, differentiated").at(0), "z'' = eps*(x''*y - y''*x)"),
              Zero::yes);
    EXPECT_EQ(paper.same(lines("energy of accelerations with the constraints").at(0),
                         "S = m/2*(x''^2 + y''^2 + eps^2*y^2*x''^2 + eps^2*x^2*y''^2 - 2*eps^2*x*y*x''*y'')"),
              Zero::yes);
    // (9)
    const auto appell = lines("equations of Gibbs and Appell");
    ASSERT_EQ(appell.size(), 2U);
    EXPECT_EQ(paper.same(appell[0], "m*(1 + eps^2*y^2)*x'' - m*eps^2*x*y*y'' + c*x = 0"), Zero::yes);
    EXPECT_EQ(paper.same(appell[1], "m*(1 + eps^2*x^2)*y'' - m*eps^2*x*y*x'' + c*y = 0"), Zero::yes);
    // (10)
    EXPECT_EQ(lines("accelerations"), (std::vector<std::string>{"x'' = -c*x/m", "y'' = -c*y/m"}));
    EXPECT_EQ(system.variable("z")->role, Role::drift);
}

TEST(PendulumOfThePaper, HasItsEquations) {
    const System system = system_named("pendulum_mechanism");
    Comparison paper(system, {"phi", "psi", "x", "y", "xi"}, {"g", "r", "v", "M"});
    const auto& stages = *system.derivation;
    const auto lines = [&](const std::string& heading) {
        return section(stages.accelerations, heading).equations;
    };
    // (11)
    EXPECT_EQ(section(stages.constraints, "constraints").equations,
              (std::vector<std::string>{"x' = xi'*cos(phi)", "y' = xi'*sin(phi)"}));
    EXPECT_EQ(paper.same(lines("energy of accelerations with the constraints").at(0),
                         "S = M/2*((xi^2 + r^2)*(phi''^2 + phi'^4) + xi'^2*phi'^2 + 2*xi*xi'*phi'*phi'' - "
                         "2*r*xi'*phi'^3)"),
              Zero::yes);
    // (13)
    EXPECT_EQ(lines("equations of Gibbs and Appell").at(0),
              "(xi^2 + r^2)*phi'' + xi*xi'*phi' + g*r*sin(phi) - g*xi*cos(phi) = 0");
    // (15)
    const System typed = read_system_text(pendulum_system(), "system.toml");
    ASSERT_EQ(system.equations.size(), typed.equations.size());
    for (std::size_t k = 0; k < typed.equations.size(); ++k) {
        EXPECT_EQ(system.equations[k].variable, typed.equations[k].variable);
        EXPECT_EQ(paper.same(system.equations[k].text, typed.equations[k].text), Zero::yes)
            << system.equations[k].text;
    }
    EXPECT_EQ(system.equations[0].text,
              "(xi^2 + r^2)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - r*xi*xi'^2/(xi^2 + r^2) = 0");
    EXPECT_EQ(system.variable("x")->role, Role::drift);
    ASSERT_EQ(system.cancelled.size(), 1U);
    EXPECT_EQ(system.cancelled[0].name, "M");
}

} // namespace
} // namespace resonform
