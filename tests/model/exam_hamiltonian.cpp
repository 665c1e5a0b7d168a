// SPDX-License-Identifier: GPL-3.0-or-later
// [hamiltonian]: the equations that follow from an energy, and every bad one.
#include "messages.hpp"
#include "model/files/read_system.hpp"

namespace resonform {
namespace {

const std::string hamiltonian_oscillator = "[system]\n"
                                           "name = \"oscillator\"\n"
                                           "[parameters]\n"
                                           "g = { positive = true }\n"
                                           "[variables]\n"
                                           "x = { role = \"fast\" }\n"
                                           "p = { role = \"fast\" }\n"
                                           "[hamiltonian]\n"
                                           "energy = \"p^2/2 + g*(1 - cos(x)) + eps*x^2*p\"\n"
                                           "momenta = { x = \"p\" }\n";

TEST(HamiltonianSystem, EquationsAreDerived) {
    const System system = read_system_text(hamiltonian_oscillator, "system.toml");
    ASSERT_EQ(system.equations.size(), 2U);
    EXPECT_EQ(system.equations[0].text, "x' = eps*x^2 + p");
    EXPECT_EQ(system.equations[1].text, "p' = -2*eps*p*x -g*sin(x)");
    ASSERT_TRUE(system.hamiltonian);
    ASSERT_EQ(system.hamiltonian->pairs.size(), 1U);
    EXPECT_EQ(system.hamiltonian->pairs[0].first, 0U);
    EXPECT_EQ(system.hamiltonian->pairs[0].second, 1U);
}

TEST(HamiltonianSystem, EquationsMayBeGivenAsWell) {
    EXPECT_EQ(system_message(hamiltonian_oscillator + "[equations]\nx = \"2*x' - 2*p = 2*eps*x^2\"\n"), "");
}

TEST(HamiltonianSystem, OtherVariablesHaveTheirEquations) {
    const std::string swinging =
        edited(edited(hamiltonian_oscillator, "p = {", "tau = { role = \"slow\" }\np = {"), "g*(1",
               "(1 + tau^2)*(1");
    EXPECT_EQ(system_message(swinging + "[equations]\ntau = \"tau' = eps\"\n"), "");
    EXPECT_NE(system_message(swinging), "");
}

class BadHamiltonian : public testing::TestWithParam<BadInput> {};

TEST_P(BadHamiltonian, IsRefusedInOneMessage) {
    const BadInput& bad = GetParam();
    EXPECT_EQ(system_message(edited(hamiltonian_oscillator, bad.from, bad.to)), bad.message);
}

const BadInput bad_hamiltonians[] = {
    {"NoEnergy", "energy = \"p^2/2 + g*(1 - cos(x)) + eps*x^2*p\"\n", "",
     "2 system.toml:8:1: hamiltonian: the Hamiltonian system has no energy\n"
     "    [hamiltonian]\n"
     "    ^\n"
     "  found: [hamiltonian]\n"
     "  hint:  write energy = \"p^2/2 + ...\" under [hamiltonian]"},
    {"NoPairs", "momenta = { x = \"p\" }\n", "",
     "2 system.toml:8:1: hamiltonian: the Hamiltonian system has no canonical pairs\n"
     "    [hamiltonian]\n"
     "    ^\n"
     "  found: no pairs\n"
     "  hint:  write momenta = { x = \"p\" } under [hamiltonian]"},
    {"UnknownMomentum", "x = \"p\"", "x = \"q\"",
     "2 system.toml:10:18: hamiltonian.momenta.x: a coordinate or momentum is not a declared variable\n"
     "    momenta = { x = \"q\" }\n"
     "                     ^\n"
     "  found: 'q'\n"
     "  hint:  did you mean 'x'? Known are: x, p"},
    {"OwnMomentum", "x = \"p\"", "x = \"x\"",
     "2 system.toml:10:18: hamiltonian.momenta.x: the coordinate is given as its own momentum\n"
     "    momenta = { x = \"x\" }\n"
     "                     ^\n"
     "  found: \"x\"\n"
     "  hint:  name another variable, or declare one"},
    {"PairedTwice", "x = \"p\"", "x = \"p\", p = \"x\"",
     "2 system.toml:10:22: hamiltonian.momenta.p: the variable belongs to two canonical pairs\n"
     "    momenta = { x = \"p\", p = \"x\" }\n"
     "                         ^\n"
     "  found: 'p'\n"
     "  hint:  correct one of the pairs"},
    {"SlowMomentum", "p = { role = \"fast\"", "p = { role = \"slow\"",
     "2 system.toml:10:18: hamiltonian.momenta.x: a coordinate or momentum is not a fast variable\n"
     "    momenta = { x = \"p\" }\n"
     "                     ^\n"
     "  found: 'p' is slow\n"
     "  hint:  give it role = \"fast\", or leave it out of hamiltonian.momenta and write its equation under "
     "[equations]"},
    {"CyclicCoordinate", "g*(1 - cos(x)) + eps*x^2*p", "g",
     "2 system.toml:9:11: hamiltonian.energy: the energy does not depend on every coordinate and every "
     "momentum\n"
     "    energy = \"p^2/2 + g\"\n"
     "              ^\n"
     "  found: it does not depend on x\n"
     "  hint:  a constant momentum is a parameter: leave the pair out, and write the equation of the "
     "coordinate under [equations]"},
    {"VelocityInTheEnergy", "p^2/2", "x'^2/2",
     "2 system.toml:9:11: hamiltonian.energy: 'x' has no derivative here\n"
     "    energy = \"x'^2/2 + g*(1 - cos(x)) + eps*x^2*p\"\n"
     "              ^\n"
     "  found: x'\n"
     "  hint:  remove the primes"},
    {"OtherEquation", "[hamiltonian]", "[equations]\np = \"p' = -g*x\"\n[hamiltonian]",
     "2 system.toml:9:6: equations.p: the equation of a canonical variable is the one that the energy gives\n"
     "    p = \"p' = -g*x\"\n"
     "         ^\n"
     "  found: lhs - rhs becomes -2*eps*p*x -g*sin(x) + g*x\n"
     "  hint:  leave the equation out, or correct it or the energy"},
    {"SecondOrder", "[hamiltonian]", "[equations]\nx = \"x'' = -g*x\"\n[hamiltonian]",
     "2 system.toml:6:1: variables.x: the equation of a canonical variable is not of first order\n"
     "    x = { role = \"fast\" }\n"
     "    ^\n"
     "  found: 'x' with 2 primes\n"
     "  hint:  leave it out: it follows from the energy"},
    {"UnknownKey", "momenta", "momentum",
     "2 system.toml:10:1: hamiltonian.momentum: a key is one of the known ones\n"
     "    momentum = { x = \"p\" }\n"
     "    ^\n"
     "  found: momentum\n"
     "  hint:  did you mean 'momenta'? Known are: energy, momenta"},
};

INSTANTIATE_TEST_SUITE_P(All, BadHamiltonian, testing::ValuesIn(bad_hamiltonians), name_of);

} // namespace
} // namespace resonform
