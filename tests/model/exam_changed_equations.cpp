// SPDX-License-Identifier: GPL-3.0-or-later
// [change] beside [equations]: the equations in the new variables, held against the old ones, and bad input.
#include "mechanisms.hpp"
#include "model/exact/substitution.hpp"

#include <map>

namespace resonform {
namespace {

using GiNaC::ex;

struct File {
    std::string parameters, variables, equations, change, more;
};

std::string text_of(const File& file) {
    return "[system]\nname = \"changed\"\n[parameters]\n" + file.parameters + "[variables]\n" +
           file.variables + "[equations]\n" + file.equations + "[change]\n" + file.change + file.more;
}

const File pendulum{"g = { positive = true }\nr = { positive = true }\nv = {}\n",
                    "psi = { role = \"fast\" }\nxi = { role = \"slow\" }\nx = { role = \"drift\" }\n",
                    "phi = \"(xi^2 + r^2)*phi'' + xi*xi'*phi' + g*r*sin(phi) - g*xi*cos(phi) = 0\"\n"
                    "xi = \"xi' = eps*v\"\nx = \"x' = xi'*cos(phi)\"\n",
                    "phi = \"psi + atan(xi/r)\"\n", ""};

// The rates of a system by the names of its states, in symbols that several systems share by name.
class Motions {
public:
    Motions(const System& system, GiNaC::symtab& names) : names_(names) {
        const FirstOrderSystem first = solve_for_highest(std::make_shared<const System>(system));
        GiNaC::exmap shared;
        const auto share = [&](const GiNaC::symbol& symbol) {
            shared[symbol] = names_.try_emplace(symbol.get_name(), symbol).first->second;
        };
        for (const State& state : first.states) share(state.symbol);
        for (const Parameter& p : system.parameters) share(p.symbol);
        share(system.eps);
        for (const State& state : first.states) rates_[state.name] = put(state.rate, shared);
    }
    [[nodiscard]] const std::map<std::string, ex>& rates() const { return rates_; }
    [[nodiscard]] std::vector<TimeDerivative> motion() const {
        std::vector<TimeDerivative> all;
        for (const auto& [state, rate] : rates_)
            all.push_back({GiNaC::ex_to<GiNaC::symbol>(names_.at(state)), rate});
        return all;
    }

private:
    GiNaC::symtab& names_;
    std::map<std::string, ex> rates_;
};

// phi = f(psi, ...) along the new motion moves as the old equations say: for every state of the old system,
// d/dt of what it is in the new variables is its old rate there. `old_variables` declares the old ones.
void expect_the_same_motion(const File& file, const std::string& old_variables) {
    const System changed = read_system_text(text_of(file), "system.toml");
    File before = file;
    before.variables = old_variables;
    const std::string old_text = text_of(before);
    GiNaC::symtab names;
    const Motions after(changed, names);
    Scope scope;
    ExactForm form(changed);
    for (const auto& [name, symbol] : names) {
        scope.define(name, symbol);
        form.add(GiNaC::ex_to<GiNaC::symbol>(symbol), ExactForm::Kind::slow);
    }
    const Motions then(
        read_system_text(old_text.substr(0, old_text.find("[change]")) + file.more, "system.toml"), names);
    GiNaC::exmap in_new;
    for (const EquationBefore& c : changed.derivation->change) {
        ex value = read_expression(c.text, scope, {});
        for (std::string state = c.variable; then.rates().count(state) > 0; state += "'") {
            in_new[names.at(state)] = value;
            value = along(value, after.motion());
        }
    }
    for (const auto& [state, rate] : then.rates()) {
        const ex now = put(names.at(state), in_new);
        EXPECT_EQ(form.vanishes(along(now, after.motion()) - put(rate, in_new)), Zero::yes) << state;
    }
}

TEST(ChangedEquations, ThePendulumIsThatOfThePaper) {
    const System system = read_system_text(text_of(pendulum), "system.toml");
    EXPECT_EQ(equation(system, "psi"), "(xi^2 + r^2)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - "
                                       "r*xi*xi'^2/(xi^2 + r^2) = 0");
    EXPECT_EQ(equation(system, "psi"), equation(system_named("pendulum_mechanism"), "psi"));
    EXPECT_EQ(equation(system, "xi"), "xi' = eps*v");
    EXPECT_EQ(equation(system, "x"), equation(system_named("pendulum_mechanism"), "x"));
    ASSERT_NE(system.derivation, nullptr);
    EXPECT_FALSE(system.derivation->is_of_mechanism());
    EXPECT_EQ(system.derivation->before.front().variable, "phi");
    EXPECT_EQ(system.derivation->change.front().text, "psi + atan(xi/r)");
}

TEST(ChangedEquations, MoveAsTheOldOnes) {
    expect_the_same_motion(pendulum, "phi = { role = \"fast\" }\nxi = { role = \"slow\" }\nx = { role = "
                                     "\"drift\" }\n");
    // Two at once, of second order, mixed.
    expect_the_same_motion({"k = { positive = true }\n", "p = { role = \"fast\" }\nq = { role = \"fast\" }\n",
                            "x = \"x'' = -x - k*(x - y) + eps*y'\"\ny = \"2*y'' + x'' = -y + x^2\"\n",
                            "x = \"p + q + p^2\"\ny = \"p - q\"\n", ""},
                           "x = { role = \"fast\" }\ny = { role = \"fast\" }\n");
    // A canonical momentum: a velocity is replaced, the angle of a forcing stays.
    expect_the_same_motion(
        {"", "x = { role = \"fast\" }\np = { role = \"fast\" }\ns = { role = \"angle\" }\n",
         "x = \"x' = v\"\nv = \"v' = -eps^2*x - x*cos(s)\"\ns = \"s' = 1\"\n", "v = \"p - sin(s)*x\"\n", ""},
        "x = { role = \"fast\" }\nv = { role = \"fast\" }\ns = { role = \"angle\" }\n");
    // A slow variable that is driven: its rate, differentiated, holds the fast velocity.
    expect_the_same_motion({"", "psi = { role = \"fast\" }\ns = { role = \"slow\", positive = true }\n",
                            "u = \"u'' + u' *eps + s*u = 0\"\ns = \"s' = eps*(1 + u*u')\"\n",
                            "u = \"psi + psi^2 + eps*s^2\"\n", ""},
                           "u = { role = \"fast\" }\ns = { role = \"slow\", positive = true }\n");
    // A former action in place of a slow variable, and highest derivatives in a power.
    expect_the_same_motion(
        {"", "x = { role = \"fast\" }\nJ = { role = \"slow\", positive = true }\nK = { role = \"slow\" }\n",
         "x = \"x'' + x = eps*A\"\nA = \"A' = eps*sqrt(2*A)*x\"\nL = \"L' = A'^2\"\n",
         "A = \"J^2/2\"\nL = \"K + J\"\n", ""},
        "x = { role = \"fast\" }\nA = { role = \"slow\", positive = true }\nL = { role = \"slow\" }\n");
}

TEST(ChangedEquations, WithAnEquilibriumOfTheNewVariables) {
    const File enzyme{"kappa = { positive = true }\nnu = {}\n",
                      "s = { role = \"slow\", positive = true }\ne = { role = \"fast\" }\n",
                      "s = \"s' = eps*(-s + (s + kappa - nu)*c)\"\nc = \"c' = s - (s + kappa)*c\"\n",
                      "c = \"1 - e\"\n", "[equilibrium]\ne = \"solve\"\n"};
    const System system = read_system_text(text_of(enzyme), "system.toml");
    EXPECT_EQ(equation(system, "e"), "e' = -(s + kappa)*e + kappa");
    const Equilibrium& at = system.equilibrium.front();
    const ex s = system.variable("s")->jet.front(), kappa = system.parameter("kappa")->symbol;
    EXPECT_TRUE((at.value - kappa / (s + kappa)).normal().is_zero());
}

TEST(ChangedEquations, NeedNoParameterThatCancels) {
    File shifted{"a = {}\n", "y = { role = \"fast\" }\n", "x = \"x'' = -(x - a) + (x - a)^2\"\n",
                 "x = \"a + y\"\n", ""};
    const System system = read_system_text(text_of(shifted), "system.toml");
    EXPECT_EQ(equation(system, "y"), "y'' = y^2 - y");
    EXPECT_TRUE(system.parameters.empty());
    ASSERT_EQ(system.cancelled.size(), 1U);
    EXPECT_EQ(system.cancelled.front().name, "a");
}

class BadChange : public testing::TestWithParam<BadInput> {};

INSTANTIATE_TEST_SUITE_P(
    Files, BadChange,
    testing::Values(
        BadInput{"NotInvertible", "psi + atan(xi/r)\"", "psi^2 + xi\"",
                 "2 system.toml:16:8: change.phi: a change of variables is invertible where the equations "
                 "are expanded\n"
                 "    phi = \"psi^2 + xi\"\n"
                 "           ^\n"
                 "  found: the determinant of its derivatives is zero at the origin of the new variables\n"
                 "  hint:  correct it, or choose another origin"},
        BadInput{"NotInvertibleAtEpsZero", "psi + atan(xi/r)\"", "eps*psi\"",
                 "2 system.toml:16:8: change.phi: a change of variables is invertible where the equations "
                 "are expanded\n"
                 "    phi = \"eps*psi\"\n"
                 "           ^\n"
                 "  found: the determinant of its derivatives is zero at the origin of the new variables\n"
                 "  hint:  correct it, or choose another origin"},
        BadInput{"NoSlopeThere", "psi + atan(xi/r)\"", "psi + 1/psi\"",
                 "2 system.toml:16:8: change.phi: a change of variables has derivatives where the equations "
                 "are expanded\n"
                 "    phi = \"psi + 1/psi\"\n"
                 "           ^\n"
                 "  found: the determinant of its derivatives, (-1 + psi^2)*psi^(-2), has no value at the "
                 "origin of the new variables\n"
                 "  hint:  correct it, or choose another origin"},
        BadInput{"UnknownName", "psi + atan(xi/r)\"", "psi + atan(xi/q)\"",
                 "2 system.toml:16:22: change.phi: unknown symbol\n"
                 "    phi = \"psi + atan(xi/q)\"\n"
                 "                         ^\n"
                 "  found: q\n"
                 "  hint:  did you mean 'g'? Known are: eps, g, psi, r, v, x, xi"},
        BadInput{"OldVariable", "psi + atan(xi/r)\"", "phi + psi\"",
                 "2 system.toml:16:8: change.phi: unknown symbol\n"
                 "    phi = \"phi + psi\"\n"
                 "           ^\n"
                 "  found: phi\n"
                 "  hint:  did you mean 'psi'? Known are: eps, g, psi, r, v, x, xi"},
        BadInput{"Derivative", "psi + atan(xi/r)\"", "psi + xi'\"",
                 "2 system.toml:16:14: change.phi: 'xi' has no derivative here\n"
                 "    phi = \"psi + xi'\"\n"
                 "                 ^\n"
                 "  found: xi'\n"
                 "  hint:  remove the primes"},
        BadInput{"StandsNowhere", "psi + atan(xi/r)\"", "xi\"",
                 "2 system.toml:8:1: variables.psi: every new variable stands in [change]\n"
                 "    psi = { role = \"fast\" }\n"
                 "    ^\n"
                 "  found: 'psi' does not\n"
                 "  hint:  write a replaced variable in it, as x = \"psi + ...\", or give its equation"},
        BadInput{"NewVariableInEquation", "g*r*sin(phi)", "g*r*sin(psi)",
                 "2 system.toml:12:51: equations.phi: unknown symbol\n"
                 "    phi = \"(xi^2 + r^2)*phi'' + xi*xi'*phi' + g*r*sin(psi) - g*xi*cos(phi) = 0\"\n"
                 "                                                      ^\n"
                 "  found: psi\n"
                 "  hint:  did you mean 'phi'? Known are: eps, g, phi, r, v, x, xi"},
        BadInput{"DeclaredStill", "xi = { role", "phi = { role = \"fast\" }\nxi = { role",
                 "2 system.toml:17:1: change.phi: [change] gives old variables by new ones, and only the new "
                 "ones are declared\n"
                 "    phi = \"psi + atan(xi/r)\"\n"
                 "    ^\n"
                 "  found: 'phi' is declared under [variables]\n"
                 "  hint:  write it the other way round, or leave the old variable out of [variables]"},
        BadInput{"OtherWayRound", "phi = \"psi + atan", "psi = \"phi - atan",
                 "2 system.toml:16:1: change.psi: [change] gives old variables by new ones, and only the new "
                 "ones are declared\n"
                 "    psi = \"phi - atan(xi/r)\"\n"
                 "    ^\n"
                 "  found: 'psi' is declared under [variables]\n"
                 "  hint:  write it the other way round, or leave the old variable out of [variables]"},
        BadInput{"EquationOfNew", "phi = \"(xi", "psi = \"(xi",
                 "2 system.toml:15:1: change: [change] has one new variable for each one that it replaces: "
                 "those of [variables] without an equation are new\n"
                 "    [change]\n"
                 "    ^\n"
                 "  found: new: none; replaced: phi\n"
                 "  hint:  write an equation for each variable that stays, and none for new ones"},
        BadInput{"NoEquation", "xi = \"xi' = eps*v\"\n", "",
                 "2 system.toml:14:1: change: [change] has one new variable for each one that it replaces: "
                 "those of [variables] without an equation are new\n"
                 "    [change]\n"
                 "    ^\n"
                 "  found: new: psi, xi; replaced: phi\n"
                 "  hint:  write an equation for each variable that stays, and none for new ones"},
        BadInput{"TwoNew", "xi = { role", "chi = { role = \"fast\" }\nxi = { role",
                 "2 system.toml:16:1: change: [change] has one new variable for each one that it replaces: "
                 "those of [variables] without an equation are new\n"
                 "    [change]\n"
                 "    ^\n"
                 "  found: new: psi, chi; replaced: phi\n"
                 "  hint:  write an equation for each variable that stays, and none for new ones"},
        BadInput{"Nothing", "phi = \"psi + atan(xi/r)\"\n", "",
                 "2 system.toml:15:1: change: [change] has one new variable for each one that it replaces: "
                 "those of [variables] without an equation are new\n"
                 "    [change]\n"
                 "    ^\n"
                 "  found: new: psi; replaced: none\n"
                 "  hint:  write an equation for each variable that stays, and none for new ones"},
        BadInput{"Energy", "[change]",
                 "[hamiltonian]\nenergy = \"psi^2/2\"\nmomenta = { phi = \"psi\" }\n[change]",
                 "3 system.toml:15:1: hamiltonian: a change of variables is one of equations: of an energy "
                 "it would have to be canonical\n"
                 "    [hamiltonian]\n"
                 "    ^\n"
                 "  found: [change] beside [hamiltonian]\n"
                 "  hint:  write the energy in the new variables, or equations in place of it"},
        BadInput{"OldEquilibrium", "[change]", "[equilibrium]\nphi = \"0\"\n[change]",
                 "2 system.toml:16:1: equilibrium.phi: [equilibrium] names no variable of the system\n"
                 "    phi = \"0\"\n"
                 "    ^\n"
                 "  found: 'phi'\n"
                 "  hint:  did you mean 'psi'? Known are: psi"}),
    name_of);

TEST_P(BadChange, HasOneMessage) {
    EXPECT_EQ(system_message(edited(text_of(pendulum), GetParam().from, GetParam().to)), GetParam().message);
}

TEST(ChangedEquations, AreRefusedWhereTheirOrderIsNotThatOfAChange) {
    const File two{"", "p = { role = \"fast\" }\nq = { role = \"fast\" }\n",
                   "x = \"x'' = -x\"\ny = \"y' = -y\"\n", "x = \"p + q\"\ny = \"p - q\"\n", ""};
    EXPECT_EQ(system_message(text_of(two)),
              "3 system.toml:12:6: change.y: variables that a change replaces by the same new ones have "
              "equations of one order\n"
              "    y = \"p - q\"\n"
              "         ^\n"
              "  found: x (order 2) and y (order 1) hold 'p'\n"
              "  hint:  write the equations in first order, with velocities as variables");
    const std::string third = edited(edited(text_of(pendulum), "phi'' + xi", "phi''' + phi'' + xi"),
                                     "xi' = eps*v", "xi' = eps*phi'");
    EXPECT_EQ(system_message(third),
              "3 system.toml:16:8: change.phi: what a change of variables puts in does not depend on "
              "derivatives that it is to give\n"
              "    phi = \"psi + atan(xi/r)\"\n"
              "           ^\n"
              "  found: the derivative of xi' does\n"
              "  hint:  write the equations in first order, with velocities as variables");
}

} // namespace
} // namespace resonform
