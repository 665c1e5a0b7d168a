// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input that a system file can be, one edit of a good one each.
#include "messages.hpp"

namespace resonform {
namespace {

class BadSystem : public testing::TestWithParam<BadInput> {};

TEST_P(BadSystem, IsRefusedInOneMessage) {
    const BadInput& bad = GetParam();
    EXPECT_EQ(system_message(edited(pendulum_system(), bad.from, bad.to)), bad.message);
}

const BadInput bad_systems[] = {
    {"UnknownKey", "unit = \"m/s\" }", "unti = \"m/s\" }",
     "2 system.toml:9:7: parameters.v.unti: a key is one of the known ones\n"
     "    v = { unti = \"m/s\" }\n"
     "          ^\n"
     "  found: unti\n"
     "  hint:  did you mean 'unit'? Known are: positive, nonzero, unit, weight"},
    {"UnknownTable", "[notation]", "[notations]",
     "2 system.toml:23:2: notations: a key is one of the known ones\n"
     "    [notations] # the paper's names for the constants of the solution\n"
     "     ^\n"
     "  found: notations\n"
     "  hint:  did you mean 'notation'? Known are: system, parameters, variables, functions, hamiltonian, "
     "equations, domain, relations, modes, equilibrium, normal_form, notation, coordinates, prescribed, "
     "quasi_velocities, particles, bodies, energy, forces, constraints, ..."},
    {"NotToml", "[parameters]", "[parameters",
     "2 system.toml:6:12: the file is not valid TOML\n"
     "    [parameters\n"
     "               ^\n"
     "  found: [parameters\n"
     "  hint:  the TOML parser says: Error while parsing table header: expected ']', saw '\\n"
     "'"},
    {"NumberBeyondToml", "[parameters]", "[parameters]\nk = 1e400",
     "2 system.toml:7:10: a number without quotes has the length and the range that TOML gives to numbers\n"
     "    k = 1e400\n"
     "             ^\n"
     "  found: k = 1e400\n"
     "  hint:  write it in quotes: it is taken exactly as spelled"},
    {"UnknownSymbol", "+ g*sqrt", "+ gg*sqrt",
     "2 system.toml:18:43: equations.psi: unknown symbol\n"
     "    psi = \"(xi^2 + r^2)*psi'' + xi*xi'*psi' + gg*sqrt(xi^2 + r^2)*sin(psi) - r*xi*xi'^2/(xi^2 + r^2) "
     "= 0 ...\n"
     "                                              ^\n"
     "  found: gg\n"
     "  hint:  did you mean 'g'? Known are: eps, g, psi, r, v, x, xi, y"},
    {"NotLinear", "(xi^2 + r^2)*psi''", "(xi^2 + r^2)*psi''^2",
     "2 system.toml:18:21: equations.psi: an equation is linear in the highest derivatives, once the known "
     "rates are put in\n"
     "    psi = \"(xi^2 + r^2)*psi''^2 + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - r*xi*xi'^2/(xi^2 + r^2) "
     "=  ...\n"
     "                        ^\n"
     "  found: psi''\n"
     "  hint:  solve it for psi'' by hand, or introduce a variable for its lower derivative"},
    {"VariableWithoutEquation", "xi = \"xi' = eps*v\"\n", "",
     "2 system.toml:13:1: variables.xi: the variable has no equation\n"
     "    xi = { role = \"slow\", unit = \"m\" }\n"
     "    ^\n"
     "  found: 'xi'\n"
     "  hint:  write xi = \"xi' = ...\" under [equations]"},
    {"EquationWithoutVariable", "y = { role = \"drift\", unit = \"m\" }\n", "",
     "2 system.toml:19:1: equations.y: an equation belongs to no variable\n"
     "    y = \"y' = (r*sin(psi) + xi*cos(psi))/sqrt(xi^2 + r^2)*xi'\"\n"
     "    ^\n"
     "  found: 'y'\n"
     "  hint:  did you mean 'x'? Known are: psi, xi, x"},
    {"UnknownRole", "role = \"slow\"", "role = \"slwo\"",
     "2 system.toml:13:16: variables.xi.role: unknown role: the roles are fast, angle, slow and drift\n"
     "    xi = { role = \"slwo\", unit = \"m\" }\n"
     "                   ^\n"
     "  found: \"slwo\"\n"
     "  hint:  did you mean 'slow'? Known are: fast, angle, slow, drift"},
    {"NoRole", "role = \"slow\", ", "",
     "2 system.toml:13:1: variables.xi: the variable has no role\n"
     "    xi = { unit = \"m\" }\n"
     "    ^\n"
     "  found: 'xi'\n"
     "  hint:  write role = \"fast\", \"angle\", \"slow\" or \"drift\""},
    {"NegativeWeight", "role = \"fast\"", "role = \"fast\", weight = -1",
     "2 system.toml:12:33: variables.psi.weight: 'variables.psi.weight' is a rational number in 0 ... 9, its "
     "denominator at most 12\n"
     "    psi = { role = \"fast\", weight = -1 }\n"
     "                                    ^\n"
     "  found: -1\n"
     "  hint:  write a number such as 2, 0.5 or \"1/3\""},
    {"LargeWeight", "role = \"fast\"", "role = \"fast\", weight = 1e30",
     "2 system.toml:12:33: variables.psi.weight: 'variables.psi.weight' is a rational number in 0 ... 9, its "
     "denominator at most 12\n"
     "    psi = { role = \"fast\", weight = 1e30 }\n"
     "                                    ^\n"
     "  found: 1e30\n"
     "  hint:  write a number such as 2, 0.5 or \"1/3\""},
    {"WeightOfALargeDenominator", "role = \"fast\"", "role = \"fast\", weight = \"1/1000\"",
     "2 system.toml:12:34: variables.psi.weight: 'variables.psi.weight' is a rational number in 0 ... 9, its "
     "denominator at most 12\n"
     "    psi = { role = \"fast\", weight = \"1/1000\" }\n"
     "                                     ^\n"
     "  found: \"1/1000\"\n"
     "  hint:  write a number such as 2, 0.5 or \"1/3\""},
    {"WeightWithAName", "role = \"fast\"", "role = \"fast\", weight = \"a\"",
     "2 system.toml:12:34: variables.psi.weight: unknown symbol\n"
     "    psi = { role = \"fast\", weight = \"a\" }\n"
     "                                     ^\n"
     "  found: a\n"
     "  hint:  no name is known here"},
    {"WeightDividedByZero", "role = \"fast\"", "role = \"fast\", weight = \"1/0\"",
     "2 system.toml:12:36: variables.psi.weight: a denominator is zero\n"
     "    psi = { role = \"fast\", weight = \"1/0\" }\n"
     "                                       ^\n"
     "  found: 0\n"
     "  hint:  this expression is zero for all values: correct it"},
    {"WeightOfASlowVariable", "role = \"slow\"", "role = \"slow\", weight = 1",
     "3 system.toml:13:32: variables.xi.weight: the weight of a variable that is not fast is 0\n"
     "    xi = { role = \"slow\", weight = 1, unit = \"m\" }\n"
     "                                   ^\n"
     "  found: 1\n"
     "  hint:  remove the key, or scale the variable"},
    {"WeightOfAParameter", "v = { unit = \"m/s\" }", "v = { unit = \"m/s\", weight = -1 }",
     "2 system.toml:9:30: parameters.v.weight: 'parameters.v.weight' is a rational number in 0 ... 9, its "
     "denominator at most 12\n"
     "    v = { unit = \"m/s\", weight = -1 }\n"
     "                                 ^\n"
     "  found: -1\n"
     "  hint:  write a number such as 2, 0.5 or \"1/3\""},
    {"RelationOfNoParameter", "[notation]", "[relations]\nq = \"2*g\"\n[notation]",
     "2 system.toml:24:1: relations.q: the relation does not give a parameter by others\n"
     "    q = \"2*g\"\n"
     "    ^\n"
     "  found: 'q'\n"
     "  hint:  did you mean 'g'? Known are: g, r, v"},
    {"RelationAgainstADeclaration", "[notation]", "[relations]\nr = \"eps*g\"\n[notation]",
     "2 system.toml:24:6: relations.r: a relation keeps at eps = 0 what is declared of 'r'\n"
     "    r = \"eps*g\"\n"
     "         ^\n"
     "  found: \"eps*g\"\n"
     "  hint:  declare what its value is made of positive"},
    {"UnknownStyle", "[notation]", "[normal_form]\nstyle = \"innerproduct\"\n[notation]",
     "2 system.toml:24:10: normal_form.style: unknown style: the styles are poincare, inner_product and "
     "hamiltonian\n"
     "    style = \"innerproduct\"\n"
     "             ^\n"
     "  found: \"innerproduct\"\n"
     "  hint:  did you mean 'inner_product'? Known are: poincare, inner_product, hamiltonian"},
    {"NearTooLarge", "[notation]", "[normal_form]\nnear = 2\n[notation]",
     "2 system.toml:24:8: normal_form.near: 0 <= near < 1: divisors up to this size are kept\n"
     "    near = 2\n"
     "           ^\n"
     "  found: 2\n"
     "  hint:  write for example near = 0.01"},
    {"ReservedName", "g = {", "eps = {",
     "2 system.toml:7:1: parameters.eps: the name of a parameter is not a reserved one\n"
     "    eps = { positive = true, unit = \"m/s^2\" }\n"
     "    ^\n"
     "  found: eps\n"
     "  hint:  choose another; reserved are I, pi, E, eps, lambda, t, z1, z2, ..., the functions, and the "
     "words of Python and SymPy"},
    {"ReservedFunction", "g = {", "sin = {",
     "2 system.toml:7:1: parameters.sin: the name of a parameter is not a reserved one\n"
     "    sin = { positive = true, unit = \"m/s^2\" }\n"
     "    ^\n"
     "  found: sin\n"
     "  hint:  choose another; reserved are I, pi, E, eps, lambda, t, z1, z2, ..., the functions, and the "
     "words of Python and SymPy"},
    {"PythonKeyword", "g = {", "is = {",
     "2 system.toml:7:1: parameters.is: the name of a parameter is not a reserved one\n"
     "    is = { positive = true, unit = \"m/s^2\" }\n"
     "    ^\n"
     "  found: is\n"
     "  hint:  choose another; reserved are I, pi, E, eps, lambda, t, z1, z2, ..., the functions, and the "
     "words of Python and SymPy"},
    {"ReservedMode", "g = {", "z1 = {",
     "2 system.toml:7:1: parameters.z1: the name of a parameter is not a reserved one\n"
     "    z1 = { positive = true, unit = \"m/s^2\" }\n"
     "    ^\n"
     "  found: z1\n"
     "  hint:  choose another; reserved are I, pi, E, eps, lambda, t, z1, z2, ..., the functions, and the "
     "words of Python and SymPy"},
    {"NotAnIdentifier", "g = {", "\"g-1\" = {",
     "2 system.toml:7:1: parameters.g-1: a parameter's name is a letter followed by letters, digits and _, "
     "at most 60\n"
     "    \"g-1\" = { positive = true, unit = \"m/s^2\" }\n"
     "    ^\n"
     "  found: g-1\n"
     "  hint:  choose such a name, in ASCII"},
    {"ParameterNamedAsVariable", "v = { unit", "psi = { unit",
     "2 system.toml:12:1: variables.psi: the name is used twice\n"
     "    psi = { role = \"fast\" }\n"
     "    ^\n"
     "  found: 'psi' is a parameter already\n"
     "  hint:  rename one of the two"},
    {"NotationOfTheWrongKind", "\"constant.y\"", "\"constant.psi\"",
     "2 system.toml:27:8: notation.C_Y: a notation names amplitude or phase of a fast variable or the "
     "constant of a drift variable\n"
     "    C_Y = \"constant.psi\"\n"
     "           ^\n"
     "  found: \"constant.psi\"\n"
     "  hint:  did you mean 'constant.x'? Known are: amplitude.psi, phase.psi, constant.x, constant.y"},
    {"NotationOfNoVariable", "\"constant.y\"", "\"constant.z\"",
     "2 system.toml:27:8: notation.C_Y: a notation names amplitude or phase of a fast variable or the "
     "constant of a drift variable\n"
     "    C_Y = \"constant.z\"\n"
     "           ^\n"
     "  found: \"constant.z\"\n"
     "  hint:  did you mean 'constant.x'? Known are: amplitude.psi, phase.psi, constant.x, constant.y"},
    {"NotationNamedAsVariable", "C_Y = \"constant.y\"", "psi = \"constant.y\"",
     "2 system.toml:27:1: notation.psi: the name is used twice\n"
     "    psi = \"constant.y\"\n"
     "    ^\n"
     "  found: 'psi' is a variable already\n"
     "  hint:  rename one of the two"},
    {"TwoNamesForOneConstant", "C_Y = \"constant.y\"", "C_Y = \"constant.x\"",
     "2 system.toml:27:8: notation.C_Y: a constant has one name: 'C_X' stands for it already\n"
     "    C_Y = \"constant.x\"\n"
     "           ^\n"
     "  found: \"constant.x\"\n"
     "  hint:  remove one of the two"},
    {"ParameterIsNoTable", "[parameters]", "[parameters]\nq = 3",
     "2 system.toml:7:5: parameters.q: 'parameters.q' is a table\n"
     "    q = 3\n"
     "        ^\n"
     "  found: 3\n"
     "  hint:  write it as { key = value, ... }"},
    {"FlagIsAString", "positive = true", "positive = \"yes\"",
     "2 system.toml:7:19: parameters.g.positive: 'parameters.g.positive' is true or false\n"
     "    g = { positive = \"yes\", unit = \"m/s^2\" }\n"
     "                      ^\n"
     "  found: \"yes\"\n"
     "  hint:  write true or false, without quotes"},
    {"PositiveFastVariable", "role = \"fast\"", "role = \"fast\", positive = true",
     "2 system.toml:12:35: variables.psi.positive: a variable that is not slow is declared positive or "
     "nonzero\n"
     "    psi = { role = \"fast\", positive = true }\n"
     "                                      ^\n"
     "  found: 'psi' is fast\n"
     "  hint:  remove the key"},
    {"EquationIsANumber", "xi = \"xi' = eps*v\"", "xi = 3",
     "2 system.toml:21:6: equations.xi: 'equations.xi' is a string\n"
     "    xi = 3\n"
     "         ^\n"
     "  found: 3\n"
     "  hint:  write it in quotes"},
    {"EmptyEquation", "xi = \"xi' = eps*v\"", "xi = \" \"",
     "2 system.toml:21:7: equations.xi: the equation is empty\n"
     "    xi = \" \"\n"
     "          ^\n"
     "  found: \" \"\n"
     "  hint:  write it as xi' = ..."},
    {"NoEqualsSign", "xi = \"xi' = eps*v\"", "xi = \"xi'\"",
     "2 system.toml:21:7: equations.xi: the equation does not have exactly one '='\n"
     "    xi = \"xi'\"\n"
     "          ^\n"
     "  found: xi'\n"
     "  hint:  write it as left = right"},
    {"TwoEqualsSigns", "xi = \"xi' = eps*v\"", "xi = \"xi' = eps = v\"",
     "2 system.toml:21:17: equations.xi: the equation does not have exactly one '='\n"
     "    xi = \"xi' = eps = v\"\n"
     "                    ^\n"
     "  found: =\n"
     "  hint:  remove the second"},
    {"NoDerivative", "y = \"y' =", "y = \"x' =",
     "2 system.toml:15:1: variables.y: the derivative of the variable does not occur in the equations\n"
     "    y = { role = \"drift\", unit = \"m\" }\n"
     "    ^\n"
     "  found: no y' in any equation\n"
     "  hint:  write its equation with y', or make it a parameter"},
    {"NoDerivativeLeft", "xi = \"xi' = eps*v\"", "xi = \"xi = eps*v\"",
     "2 system.toml:21:7: equations.xi: the equations do not determine every highest derivative\n"
     "    xi = \"xi = eps*v\"\n"
     "          ^\n"
     "  found: none is left in the equation of 'xi'\n"
     "  hint:  write xi' in this equation"},
    {"SlowOfSecondOrder", "xi = \"xi' = eps*v\"", "xi = \"xi'' = eps*v\"",
     "2 system.toml:13:1: variables.xi: a slow variable has an equation of first order\n"
     "    xi = { role = \"slow\", unit = \"m\" }\n"
     "    ^\n"
     "  found: 'xi' with 2 primes\n"
     "  hint:  make it fast, or declare its derivative as a variable"},
    {"TenPrimes", "psi'' + xi", "psi'''''''''' + xi",
     "2 system.toml:12:1: variables.psi: a variable has at most 9 primes\n"
     "    psi = { role = \"fast\" }\n"
     "    ^\n"
     "  found: 'psi' with 10 primes\n"
     "  hint:  write a system of lower order"},
    {"DivisionByZero", "/(xi^2 + r^2) = 0", "/(xi - xi) = 0",
     "2 system.toml:18:84: equations.psi: a denominator is zero\n"
     "    psi = \"(xi^2 + r^2)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - r*xi*xi'^2/(xi - xi) = "
     "0\"\n"
     "                                                                                       ^\n"
     "  found: (xi - xi)\n"
     "  hint:  this expression is zero for all values: correct it"},
    {"DivisionByZeroOnceSubstituted", "/(xi^2 + r^2) = 0", "/(xi' - eps*v) = 0",
     "2 system.toml:18:8: equations.psi: an equation stays regular when the other rates are put in\n"
     "    psi = \"(xi^2 + r^2)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - r*xi*xi'^2/(xi' - eps*v) "
     "= 0 ...\n"
     "           ^\n"
     "  found: (xi^2 + r^2)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(ps...\n"
     "  hint:  a denominator becomes zero: correct it"},
    {"CoefficientIsZero", "(xi^2 + r^2)*psi''", "((xi+r)^2-xi^2-r^2-2*xi*r)*psi''",
     "2 system.toml:18:8: equations.psi: the equations cannot be solved for the highest derivatives\n"
     "    psi = \"((xi+r)^2-xi^2-r^2-2*xi*r)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - "
     "r*xi*xi'^2/(xi ...\n"
     "           ^\n"
     "  found: the coefficient of psi'' is zero\n"
     "  hint:  correct the equations"},
    {"CoefficientUndecided", "(xi^2 + r^2)*psi''", "(sqrt(3+2*sqrt(2))-1-sqrt(2))*psi''",
     "3 system.toml:18:8: equations.psi: the coefficients of the highest derivatives are not proved nonzero\n"
     "    psi = \"(sqrt(3+2*sqrt(2))-1-sqrt(2))*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - "
     "r*xi*xi'^2/ ...\n"
     "           ^\n"
     "  found: the one of psi'' can be told neither zero nor nonzero\n"
     "  hint:  simplify the equation"},
    {"CoefficientZeroByAnIdentity", "(xi^2 + r^2)*psi''", "(sin(xi)^2+cos(xi)^2-1)*psi''",
     "2 system.toml:18:8: equations.psi: the equations cannot be solved for the highest derivatives\n"
     "    psi = \"(sin(xi)^2+cos(xi)^2-1)*psi'' + xi*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - "
     "r*xi*xi'^2/(xi^2  ...\n"
     "           ^\n"
     "  found: the coefficient of psi'' is zero\n"
     "  hint:  correct the equations"},
    {"Greek", "xi*xi'*psi'", "ξ*xi'*psi'",
     "2 system.toml:18:29: equations.psi: an expression is written with ASCII letters, digits, + - * / ^ ' ( "
     ") = and spaces\n"
     "    psi = \"(xi^2 + r^2)*psi'' + ξ*xi'*psi' + g*sqrt(xi^2 + r^2)*sin(psi) - r*xi*xi'^2/(xi^2 + r^2) = "
     "0\"\n"
     "                                ^\n"
     "  found: ξ\n"
     "  hint:  write xi"},
    {"NameWithASlash", "name = \"almost", "name = \"../almost",
     "2 system.toml:2:9: system.name: a system's name is a letter followed by letters, digits and _, at most "
     "60\n"
     "    name = \"../almost_holonomic_pendulum\"\n"
     "            ^\n"
     "  found: \"../almost_holonomic_pendulum\"\n"
     "  hint:  choose such a name, in ASCII"},
    {"HugeNumber", "eps*v", "eps*1e999999999",
     "2 system.toml:21:17: equations.xi: a number has at most 1000 digits, its decimal exponent included\n"
     "    xi = \"xi' = eps*1e999999999\"\n"
     "                    ^\n"
     "  found: 1e999999999\n"
     "  hint:  write a shorter number, or a parameter in its place"},
    {"NotUtf8", "eps*v", "eps*\xff",
     "2 system.toml:21:16: the file is not valid TOML\n"
     "    xi = \"xi' = eps*?\"\n"
     "                   ^\n"
     "  found: xi = \"xi' = eps*?\"\n"
     "  hint:  the TOML parser says: Encountered invalid utf-8 sequence"},
    {"DeclaredPositiveIsZero", "[notation]", "[domain]\npositive = [\"xi - xi\"]\n[notation]",
     "2 system.toml:24:14: domain.positive[0]: an expression declared positive can be positive\n"
     "    positive = [\"xi - xi\"]\n"
     "                 ^\n"
     "  found: \"xi - xi\"\n"
     "  hint:  correct or remove it"},
    {"DeclaredPositiveHasAFastVariable", "[notation]", "[domain]\npositive = [\"psi\"]\n[notation]",
     "2 system.toml:24:14: domain.positive[0]: unknown symbol\n"
     "    positive = [\"psi\"]\n"
     "                 ^\n"
     "  found: psi\n"
     "  hint:  known are: g, r, v, xi"},
};

INSTANTIATE_TEST_SUITE_P(All, BadSystem, testing::ValuesIn(bad_systems), name_of);

TEST(BadSystems, DeclarationsAreCounted) {
    std::string many;
    for (int k = 0; k < 65; ++k) many += "\"xi^2 + r\", ";
    const std::string message = system_message(
        edited(pendulum_system(), "[notation]", "[domain]\npositive = [" + many + "]\n[notation]"));
    EXPECT_NE(
        message.find("2 system.toml:24:12: domain.positive: 'domain.positive' has at most 64 expressions"),
        std::string::npos)
        << message;
}

TEST(BadSystems, DeclarationsDoNotContradictEachOther) {
    const std::string both = system_message(
        edited(pendulum_system(), "g = { positive = true", "g = { nonzero = false, positive = true"));
    EXPECT_NE(both.find("parameters.g.nonzero: what is positive is not zero\n"), std::string::npos) << both;
    const std::string small =
        system_message(edited(edited(pendulum_system(), "v = { unit", "v = { weight = 1, unit"), "[notation]",
                              "[relations]\nv = \"2*g\"\n[notation]"));
    EXPECT_NE(small.find("relations.v: a parameter computed by [relations] is given a weight of its own\n"),
              std::string::npos)
        << small;
}

TEST(BadSystems, AreNamedWithoutCharactersThatTurnOrControl) {
    EXPECT_EQ(printable("a\xE2\x80\xAE"
                        "b\xC2\x9B"
                        "c\x1B\xD8\x9C\xC3\xA9\xE2\x80\x93"),
              "a???b??c???\xC3\xA9\xE2\x80\x93");
    const std::string message =
        system_message(edited(pendulum_system(), "[notation]", "[notation\xE2\x81\xA6]"));
    EXPECT_NE(message, "");
    EXPECT_EQ(message.find("\xE2\x81\xA6"), std::string::npos) << message;
}

} // namespace
} // namespace resonform
