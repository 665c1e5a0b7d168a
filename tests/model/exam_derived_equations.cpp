// SPDX-License-Identifier: GPL-3.0-or-later
// What is derived from small mechanisms: forces, bodies, Lagrangians, integrals, roles.
#include "mechanisms.hpp"
#include "model/files/read_system.hpp"
#include "model/files/settings.hpp"
#include "model/mechanics/multipliers.hpp"

#include <regex>

namespace resonform {
namespace {

System read(const std::string& variables, const std::string& rest) {
    return read_system_text("[system]\nname = \"mechanism\"\n[parameters]\nm = { positive = true }\n"
                            "r = { positive = true }\nk = {}\n[variables]\n" +
                                variables + rest,
                            "system.toml");
}

const std::string plane =
    "[coordinates]\nx = {}\ny = {}\n[particles]\np = { mass = \"m\", position = [\"x\", \"y\"] }\n"
    "[energy]\npotential = \"m*x^2/2\"\n";

TEST(DerivedEquations, HoldForcesAndDissipation) {
    const System system =
        read("x = { role = \"fast\" }\n",
             "[coordinates]\nx = {}\n[particles]\np = { mass = \"m\", position = [\"x\", \"0\"] }\n"
             "[energy]\npotential = \"k*x^2/2\"\ndissipation = \"r*x'^2/2\"\n[forces]\nx = \"-eps*x^3\"\n");
    EXPECT_EQ(equation(system, "x"), "m*x'' + r*x' + eps*x^3 + k*x = 0");
}

TEST(DerivedEquations, OfABodyHoldItsInertia) {
    const System system = read(
        "phi = { role = \"fast\" }\n",
        "[coordinates]\nphi = {}\n[bodies]\nrod = { mass = \"m\", inertia = \"m*r^2/3\", position = "
        "[\"r*sin(phi)\", \"-r*cos(phi)\"], angle = \"phi\" }\n[energy]\npotential = \"-m*k*r*cos(phi)\"\n");
    EXPECT_EQ(equation(system, "phi"), "4*r*phi'' + 3*k*sin(phi) = 0");
}

// The spherical pendulum with a body on it: Lagrange's top, its pivot at the origin.
TEST(DerivedEquations, OfABodyInSpaceAreThoseOfItsLagrangian) {
    const std::string variables =
        "psi = { role = \"fast\" }\ntheta = { role = \"fast\" }\nphi = { role = \"fast\" }\n";
    const std::string coordinates =
        "[coordinates]\npsi = {}\ntheta = {}\nphi = {}\n[change]\ntheta = \"nu + 1\"\n";
    const std::string shifted = edited(variables, "theta", "nu");
    const System body =
        read(shifted,
             coordinates +
                 "[bodies]\ntop = { mass = \"m\", inertia = [\"m*r^2\", \"m*r^2\", \"3*m*r^2\"], position = "
                 "[\"r*sin(theta)*sin(psi)\", \"-r*sin(theta)*cos(psi)\", \"r*cos(theta)\"], attitude = "
                 "[\"psi\", \"theta\", \"phi\"] }\n[energy]\npotential = \"m*k*r*cos(theta)\"\n");
    const System whole = read(
        shifted, coordinates + "[energy]\nlagrangian = \"m*r^2*(theta'^2 + psi'^2*sin(theta)^2 + 3/2*(phi' + "
                               "psi'*cos(theta))^2) - m*k*r*cos(theta)\"\n");
    for (const char* name : {"psi", "nu", "phi"}) EXPECT_EQ(equation(body, name), equation(whole, name));
}

// Euler's equations of a body of three different moments, where it turns about its axes one by one.
TEST(DerivedEquations, OfABodyInSpaceAreEulers) {
    const System body = read(
        "psi = { role = \"fast\" }\nnu = { role = \"fast\" }\nphi = { role = \"fast\" }\n",
        "[coordinates]\npsi = {}\ntheta = {}\nphi = {}\n[change]\ntheta = \"nu + pi/2\"\n"
        "[bodies]\nbody = { mass = \"m\", inertia = [\"m\", \"2*m\", \"4*m\"], position = [\"0\", \"0\", "
        "\"0\"], attitude = [\"psi\", \"theta\", \"phi\"] }\n");
    // Near phi = 0, theta = pi/2: w = (theta', psi', phi'), B w_2' = (C - A) w_3 w_1 with w_2' = psi'' -
    // theta' phi'.
    Comparison at(body, {"psi", "nu", "phi"}, {"m", "r", "k"});
    const std::string here = std::regex_replace(
        std::regex_replace(
            std::regex_replace(std::regex_replace(equation(body, "psi"), std::regex("sin\\(nu\\)"), "0"),
                               std::regex("cos\\(nu\\)"), "1"),
            std::regex("sin\\(phi\\)"), "0"),
        std::regex("cos\\(phi\\)"), "1");
    EXPECT_EQ(at.same(here, "psi'' = nu'*phi' + 3/2*phi'*nu'"), Zero::yes) << here;
}

TEST(DerivedEquations, OfALagrangianAreThoseOfItsParts) {
    const std::string variables = "phi = { role = \"fast\" }\nl = { role = \"slow\", positive = true }\n";
    const std::string prescribed = "[coordinates]\nphi = {}\n[prescribed]\nl = \"l' = eps*l\"\n";
    const System parts =
        read(variables, prescribed + "[particles]\np = { mass = \"m\", position = [\"l*sin(phi)\", "
                                     "\"-l*cos(phi)\"] }\n[energy]\npotential = \"-m*k*l*cos(phi)\"\n");
    const System whole =
        read(variables, prescribed + "[energy]\nlagrangian = \"m/2*(l'^2 + l^2*phi'^2) + m*k*l*cos(phi)\"\n");
    EXPECT_EQ(equation(parts, "phi"), "l*phi'' + 2*l'*phi' + k*sin(phi) = 0");
    EXPECT_EQ(equation(whole, "phi"), equation(parts, "phi"));
}

TEST(DerivedEquations, CoupledOnesAreSolved) {
    const System system = read("a = { role = \"fast\" }\nb = { role = \"fast\" }\n",
                               "[coordinates]\na = {}\nb = {}\n[energy]\nlagrangian = \"a'^2/2 + a'*b'/2 + "
                               "b'^2/2 - a^2/2 - b^2\"\n");
    EXPECT_EQ(equation(system, "a"), "a'' = -4*a/3 + 4*b/3");
    EXPECT_EQ(equation(system, "b"), "b'' = 2*a/3 - 8*b/3");
}

// A chain of `n` links that hangs; masses and lengths are parameters or 1.
System chain(int n, bool symbolic) {
    const auto times = [&](const std::string& parameter, int k) {
        return symbolic ? parameter + std::to_string(k) + "*" : "";
    };
    std::string parameters, names, roles, particles, x, y, potential;
    for (int k = 1; k <= n; ++k) {
        const std::string index = std::to_string(k), mass = symbolic ? "M" + index : "1";
        if (symbolic)
            parameters += "M" + index + " = { positive = true }\nL" + index + " = { positive = true }\n";
        roles += "a" + index + " = { role = \"fast\" }\n";
        names += "a" + index + " = {}\n";
        x += " + " + times("L", k) + "sin(a" + index + ")";
        y += " - " + times("L", k) + "cos(a" + index + ")";
        particles +=
            "p" + index + " = { mass = \"" + mass + "\", position = [\"" + x + "\", \"" + y + "\"] }\n";
        potential += " + " + mass + "*(" + y + ")";
    }
    return read_system_text("[system]\nname = \"chain\"\n[parameters]\n" + parameters + "[variables]\n" +
                                roles + "[coordinates]\n" + names + "[particles]\n" + particles +
                                "[energy]\npotential = \"" + potential + "\"\n",
                            "system.toml");
}

TEST(Chains, OfThreeLinksAreDerivedInSymbols) {
    const System system = chain(3, true);
    EXPECT_EQ(equation(system, "a3").substr(0, 6), "a3'' =");
    EXPECT_EQ(system.parameters.size(), 6U);
}

// The solution is longer than a text of the file may be: the equations stay coupled.
TEST(SlowChains, OfFourLinksStayCoupled) {
    const System system = chain(4, false);
    EXPECT_LT(equation(system, "a1").size(), 1000U);
    EXPECT_NE(equation(system, "a1").find("*a4''"), std::string::npos) << equation(system, "a1");
    EXPECT_NO_THROW(solve_for_highest(std::make_shared<System>(system)));
}

TEST(ConstantsOfConstraints, AreFoundWhereTheyAreElementary) {
    const System system = read("x = { role = \"fast\" }\n",
                               plane + "[constraints]\nc = \"y' = 2*x*x' + eps*x*x'^1 + cos(x)*x'\"\n");
    EXPECT_EQ(section(system.derivation->constraints, "constants of these").equations,
              std::vector<std::string>{"R_y = -sin(x) - x^2 + y"});
    EXPECT_EQ(equation(system, "R_y"), "R_y' = eps*x*x'");
    EXPECT_EQ(system.derivation->remarks.front(),
              "holonomic after all: the constraints are integrable for every eps");
}

// y' = slope*x' + eps*x*x'
std::string constant_found(const std::string& slope) {
    const System system = read("x = { role = \"fast\" }\n",
                               plane + "[constraints]\nc = \"y' = " + slope + "*x' + eps*x*x'\"\n");
    EXPECT_EQ(equation(system, "R_y"), "R_y' = eps*x*x'") << slope;
    return section(system.derivation->constraints, "constants of these").equations.front();
}

TEST(ConstantsOfConstraints, AreFoundByWiderIntegrals) {
    EXPECT_EQ(constant_found("1/(x^2 + r^2)"), "R_y = -atan(x/r)/r + y");
    EXPECT_EQ(constant_found("x/(x - r)"), "R_y = -r*log(-x + r) - x + y");
    EXPECT_EQ(constant_found("tan(x)"), "R_y = log(cos(x)) + y");
    EXPECT_EQ(constant_found("x*exp(-x)*sin(x)"),
              "R_y = (2*y*exp(x) + x*sin(x) + x*cos(x) + cos(x))/(2*exp(x))");
    EXPECT_EQ(constant_found("1/cos(x)^2"), "R_y = (-sin(x) + y*cos(x))/cos(x)");
}

TEST(ConstantsOfConstraints, AreTakenFromTheFile) {
    const System system =
        read("x = { role = \"fast\" }\nR = { positive = true, role = \"slow\" }\n",
             plane + "[constraints]\nc = \"y' = y*x' + eps*x'\"\n[integrals]\nR = \"y*exp(-x)\"\n"
                     "[change]\ny = \"R*exp(x)\"\n");
    EXPECT_EQ(equation(system, "R"), "R' = eps*x'/exp(x)");
}

// A rod: what it is long is constant for every eps.
TEST(ConstantsOfConstraints, AreParametersWhereTheyStandStill) {
    const System system =
        read("x = { role = \"fast\" }\nR = { positive = true }\n",
             "[coordinates]\nx = {}\ny = {}\n"
             "[particles]\np = { mass = \"m\", position = [\"x\", \"y\"] }\n[energy]\npotential = \"m*r*y\"\n"
             "[constraints]\nrod = \"x*x' + y*y' = 0\"\n[integrals]\nR = \"x^2 + y^2\"\n"
             "[change]\ny = \"-sqrt(R - x^2)\"\n");
    EXPECT_EQ(system.variable("R"), nullptr);
    ASSERT_NE(system.parameter("R"), nullptr);
    EXPECT_TRUE(system.parameter("R")->positive);
    EXPECT_EQ(system.derivation->remarks.back(), "R is constant for every eps: a parameter");
    EXPECT_EQ(system.equations.size(), 1U);
}

TEST(ConstantsOfConstraints, AreSlowWhereSomethingDependsOnThem) {
    const std::string spring = edited(plane, "m*x^2/2", "m*x^2*(2 + y^2)/2");
    const System system =
        read("x = { role = \"fast\" }\ny = {}\n", spring + "[constraints]\nc = \"y' = eps*x*x'\"\n");
    EXPECT_EQ(system.variable("y")->role, Role::slow);
    const System drift =
        read("x = { role = \"fast\" }\ny = {}\n", plane + "[constraints]\nc = \"y' = eps*x*x'\"\n");
    EXPECT_EQ(drift.variable("y")->role, Role::drift);
}

TEST(ConstantsOfConstraints, AreNotFoundWhereTheyAreNotElementary) {
    EXPECT_THROW(read("x = { role = \"fast\" }\n", plane + "[constraints]\nc = \"y' = y*x'\"\n"), Error);
    EXPECT_THROW(read("x = { role = \"fast\" }\n", plane + "[constraints]\nc = \"y' = exp(-x^2)*x'\"\n"),
                 Error);
}

TEST(LinesBetween, SayWhatWasChangedAndThatTwoRoutesAgree) {
    const System system =
        read("psi = { role = \"fast\" }\n", plane + "[constraints]\nc = \"y' = 2*x*x' + eps*x'\"\n"
                                                    "[change]\nx = \"psi + 1\"\n[relations]\nk = \"m*r\"\n");
    EXPECT_EQ(section(system.derivation->constraints, "change of variables").equations,
              (std::vector<std::string>{"x = psi + 1", "y = x^2 + R_y"}));
    EXPECT_EQ(system.derivation->agreement,
              std::vector<std::string>{
                  "the equations of d'Alembert and Lagrange with multipliers agree, identically"});
    ASSERT_EQ(system.relations.size(), 1U);
    EXPECT_EQ(system.relations.front().text, "m*r");
}

TEST(LinesBetween, SayThatThereAreNoConstraints) {
    const System system = read("x = { role = \"fast\" }\n",
                               "[coordinates]\nx = {}\n[energy]\nlagrangian = \"m*x'^2/2 - m*x^2/2\"\n");
    EXPECT_TRUE(system.derivation->constraints.empty());
    EXPECT_EQ(system.derivation->remarks,
              std::vector<std::string>{"no constraints: every coordinate is independent"});
    EXPECT_EQ(system.derivation->agreement,
              std::vector<std::string>{"the equations of Lagrange agree, identically"});
}

TEST(CancelledParameter, MayBeSet) {
    System system = system_named("pendulum_mechanism");
    EXPECT_EQ(system.parameter("M"), nullptr);
    EXPECT_NO_THROW(with_settings(system, {{"M", "2"}, {"g", "1"}}, "--set"));
    EXPECT_THROW(with_settings(system, {{"N", "2"}}, "--set"), Error);
}

// z' = eps*x*x' under x^2/2: x'' = -(x + eps^2*x*x'^2)/(1 + eps^2*x^2), z'' = eps*(x*x'' + x'^2).
class SecondRoute : public testing::Test {
protected:
    SecondRoute() {
        mechanism_.coordinates = {{"x", "", x, x1, x2, {}}, {"z", "", z, z1, z2, {}}};
        mechanism_.particles = {{"p", 1, {x, z}, {}}};
        mechanism_.potential.value = x * x / 2;
        mechanism_.constraints = {{"c", {z1 - eps * x * x1, "", {}}}};
        for (const GiNaC::symbol& s : {x, x1, x2, z, z1, z2}) form_.add(s, ExactForm::Kind::coordinate);
        form_.add(eps, ExactForm::Kind::eps);
    }
    // Checks with x'' as given, and what is to vanish by it.
    void check(const GiNaC::ex& acceleration, const GiNaC::ex& equation) {
        const GiNaC::ex slope = eps * x;
        const SolvedConstraints constraints{{1}, {0}, {{slope}}, {0}, {{z1, slope * x1}}};
        check_by_multipliers(mechanism_, form_, constraints,
                             {0, {{z2, eps * (x * x2 + x1 * x1)}}, 0, {equation}, {acceleration}});
    }
    void check(const GiNaC::ex& acceleration) { check(acceleration, equation_); }

    System domain_;
    GiNaC::symbol eps = domain_.eps, x{"x"}, x1{"x'"}, x2{"x''"}, z{"z"}, z1{"z'"}, z2{"z''"};
    Mechanism mechanism_;
    ExactForm form_{domain_};
    GiNaC::ex equation_ = (1 + eps * eps * x * x) * x2 + eps * eps * x * x1 * x1 + x;
};

TEST_F(SecondRoute, TakesWhatIsRight) {
    EXPECT_NO_THROW(check(-(x + eps * eps * x * x1 * x1) / (1 + eps * eps * x * x)));
}

TEST_F(SecondRoute, SeesWhatIsWrong) {
    EXPECT_THROW(check(-x / (1 + eps * eps * x * x)), Error);
    EXPECT_THROW(check(-x), Error);
    EXPECT_THROW(check(-x, x2 + x), Error);
    mechanism_.constraints.front().condition.value = z1 - 2 * eps * x * x1;
    EXPECT_THROW(check(-(x + eps * eps * x * x1 * x1) / (1 + eps * eps * x * x)), Error);
}

} // namespace
} // namespace resonform
