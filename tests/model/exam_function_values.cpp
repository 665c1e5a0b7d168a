// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of a system that a scene gives their values: the system is as if these had been written.
#include "messages.hpp"
#include "model/files/read_system.hpp"
#include "model/text/canonical.hpp"
#include "model/text/named_function.hpp"
#include "support/error_when.hpp"

namespace resonform {
namespace {

// x'' + force = 0, with f of the slow variable s, which is positive, and g of the parameter k.
std::string system_of(const std::string& force, const std::string& more = "") {
    return "[system]\nname = \"m\"\n[parameters]\nk = { positive = true }\na = {}\n[functions]\n"
           "f = { of = [\"s\"], positive = true }\ng = { of = [\"k\"], nonzero = true }\n[variables]\n"
           "x = { role = \"fast\" }\ns = { role = \"slow\", positive = true }\n" +
           more + "[equations]\nx = \"x'' + " + force + " = 0\"\ns = \"s' = eps*k\"\n";
}

// As a scene with this text reads it.
System read_for(const std::string& scene, const std::string& toml) {
    const TomlNode root = read_toml(scene, "scene.toml");
    FunctionValues values{root.find("functions"), whole_file("scene.toml")};
    if (values.table != nullptr) values.place = place_of(values.table->source);
    return read_system_text(toml, "system.toml", &values);
}

System with_values(const std::string& toml, const std::string& functions) {
    return read_for("[functions]\n" + functions + "\n", toml);
}

struct Given {
    const char *force, *f, *g, *written;
};

class GivenFunctions : public testing::TestWithParam<Given> {};

// The rates are the same to the letter.
TEST_P(GivenFunctions, StandInEveryPlace) {
    const Given& given = GetParam();
    const System bound =
        with_values(system_of(given.force), "f = \"" + std::string(given.f) + "\"\ng = \"" + given.g + "\"");
    const System written = read_system_text(system_of(given.written), "system.toml");
    EXPECT_FALSE(has_named(bound.equations[0].residual));
    EXPECT_EQ(spell(bound.equations[0].residual), spell(written.equations[0].residual));
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryForm, GivenFunctions,
    testing::Values(Given{"f(s)^2*x", "sqrt(1 + s^2)", "1", "(1 + s^2)*x"},
                    Given{"f(2*s)*x + f'(s)*x^2", "1 + s^3", "1", "(1 + 8*s^3)*x + 3*s^2*x^2"},
                    Given{"f(s)*x + f''(3*s)*x^2", "exp(s)", "1", "exp(s)*x + exp(3*s)*x^2"},
                    Given{"f(s + x)*x", "2 + sin(s)", "1", "(2 + sin(s + x))*x"},
                    Given{"f(f(s))*x", "1 + s", "1", "(2 + s)*x"},
                    Given{"f(k)*g(k)*x + g'(a)*x^3", "k + a^2 + s", "1 + k^2",
                          "(2*k + a^2)*(1 + k^2)*x + 2*a*x^3"},
                    Given{"f(s)*x", "3/2", "-2", "3/2*x"}));

// Their signs are proved where the system says that the motion is.
TEST(GivenFunctions, HaveTheirSignsInTheDomain) {
    const std::string plain = system_of("f(s)*x");
    with_values(plain, "f = \"1 + s\"\ng = \"-k\""); // s and k are positive
    const std::string message = test::message_when([&] { with_values(plain, "f = \"1 - s\"\ng = 1"); });
    EXPECT_EQ(
        message,
        "scene.toml:2:6: functions.f: the system declares f positive, and its value is not proved to be so "
        "wherever s lies in the domain\n"
        "    f = \"1 - s\"\n"
        "         ^\n"
        "  found: \"1 - s\"\n"
        "  hint:  give another value; or let the sign bound the motion: write positive = [\"f(s)\"] "
        "under [domain] of the system");
    // As the hint says.
    const System bounded =
        with_values(system_of("f(s)*x", "[domain]\npositive = [\"f(s)\"]\n"), "f = \"1 - s\"\ng = 1");
    EXPECT_EQ(spell(bounded.positive.front().value), "-s + 1");
}

// What is proved of a function by its name is proved anew of its value.
TEST(GivenFunctions, StandInTheEquilibrium) {
    const std::string resting = "[system]\nname = \"m\"\n[functions]\nf = { of = [\"s\"], positive = true }\n"
                                "[variables]\ny = { role = \"fast\" }\ns = { role = \"slow\" }\n"
                                "[equilibrium]\ny = \"1/f(s)\"\n[equations]\n"
                                "y = \"y' = 1 - f(s)*y\"\ns = \"s' = eps\"\n";
    EXPECT_EQ(spell(with_values(resting, "f = \"1 + s^2\"").equilibrium.front().value), "(1 + s^2)^(-1)");
}

// The same file with the name and with the expression in its place.
void expect_equal_systems(const std::string& named, const std::string& written) {
    const System bound = with_values(named, "f = \"1 + s^2\"");
    const System plain = read_system_text(written, "system.toml");
    ASSERT_EQ(bound.equations.size(), plain.equations.size());
    for (std::size_t k = 0; k < plain.equations.size(); ++k)
        EXPECT_EQ(spell(bound.equations[k].residual), spell(plain.equations[k].residual));
}

TEST(GivenFunctions, StandInTheEnergy) {
    const auto file = [](const std::string& declared, const std::string& stiffness) {
        return "[system]\nname = \"m\"\n" + declared +
               "[variables]\nx = { role = \"fast\" }\np = { role = \"fast\" }\ns = { role = \"slow\" }\n"
               "[hamiltonian]\nenergy = \"p^2/2 + " +
               stiffness +
               "*x^2/2\"\nmomenta = { x = \"p\" }\n"
               "[equations]\ns = \"s' = eps\"\n";
    };
    expect_equal_systems(file("[functions]\nf = { of = [\"s\"], positive = true }\n", "f(s)"),
                         file("", "(1 + s^2)"));
}

TEST(GivenFunctions, StandInTheMechanism) {
    const auto file = [](const std::string& declared, const std::string& stiffness) {
        return "[system]\nname = \"m\"\n[parameters]\nm = { positive = true }\n" + declared +
               "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n[coordinates]\nx = {}\n"
               "[prescribed]\ns = \"s' = eps\"\n[particles]\nq = { mass = \"m\", position = [\"x\", \"s\"] "
               "}\n"
               "[energy]\npotential = \"" +
               stiffness + "*x^2/2\"\n";
    };
    expect_equal_systems(file("[functions]\nf = { of = [\"s\"], positive = true }\n", "f(s)"),
                         file("", "(1 + s^2)"));
}

struct Wrong {
    const char *functions, *rule, *hint;
};

class WrongValues : public testing::TestWithParam<Wrong> {};

TEST_P(WrongValues, AreRefusedInOneMessage) {
    const Error error = test::error_when([&] {
        read_for(std::string("order = 1\n") + GetParam().functions,
                 system_of("f(s)*x + f(2)*x^2 + g'(k)*x^3"));
    });
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::bad_input) << message;
    EXPECT_NE(message.find(GetParam().rule), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().hint), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, WrongValues,
    testing::Values(
        Wrong{"",
              "scene.toml: a scene gives a value to every function that its system knows by its name "
              "only\n  found: no value of 'f'",
              "write under [functions] its expression, as f = \"sqrt(1 + s^2)\""},
        Wrong{"[functions]\nf = 1", "scene.toml:2:1: functions: a scene gives a value to every function",
              "as g = \"sqrt(1 + k^2)\""},
        Wrong{"[functions]\nf = 1\ng = 1\nf = 2", "functions.f: a key is given once",
              "remove one of the two"},
        Wrong{"[functions]\nf = 1\ngg = 1",
              "scene.toml:4:1: functions.gg: [functions] of a scene gives values", "did you mean 'g'?"},
        Wrong{"functions = 3", "'functions' is a table", "write [functions]"},
        Wrong{"[functions]\nf = 1\ng = true", "'functions.g' is a number or an expression in quotes",
              "write a number"},
        Wrong{"[functions]\nf = \"\"\ng = 1", "the expression is empty", "write one"},
        Wrong{"[functions]\nf = \"1 + x\"\ng = 1", "functions.f: unknown symbol\n", "nown are: a, k, s"},
        Wrong{"[functions]\nf = \"1 + eps\"\ng = 1", "functions.f: unknown symbol\n", "nown are: a, k, s"},
        Wrong{"[functions]\nf = \"1 + s\"\ng = \"f(k)\"", "functions.g: unknown function\n",
              "known are: sin"},
        Wrong{"[functions]\nf = \"-1\"\ng = 1", "the system declares f positive", "give another value"},
        Wrong{"[functions]\nf = 1\ng = 0", "the system declares g nonzero", "give another value"},
        Wrong{"[functions]\nf = \"1/(s - 2)\"\ng = 1", "equations.x: the expression has no value",
              "it is singular here"},
        Wrong{"[functions]\nf = \"sqrt(1 - s)\"\ng = 1", "equations.x: the value of a function is real",
              "or the expression that gives the function"},
        Wrong{"[functions]\nf = \"atanh(s)\"\ng = 1", "equations.x: the value of a function is real",
              "or the expression that gives the function"},
        Wrong{"[functions]\nf = \"sqrt(1 - s^2)\"\ng = 1", "equations.x: the value of a function is real",
              "or the expression that gives the function"},
        Wrong{"[functions]\nf = \"(1 + s + a)^1000\"\ng = 1", "terms when it is expanded",
              "smaller exponents"}));

TEST(WrongValues, OfASystemWithoutFunctions) {
    EXPECT_EQ(scene_message(edited(pendulum_scene(), "[fix]", "[functions]\nomega = 1\n[fix]")),
              "2 scene.toml:8:1: functions.omega: [functions] of a scene gives values to functions of its "
              "system\n"
              "    omega = 1\n"
              "    ^\n"
              "  found: 'omega'\n"
              "  hint:  the system has none: remove the table");
}

TEST(WrongValues, DifferentiatedTooOften) {
    EXPECT_THROW(with_values(system_of("f(s)*x + f''''''''''(s)*x^2"), "f = \"exp(s)\"\ng = 1"), Error);
    with_values(system_of("f(s)*x + f'''''''''(s)*x^2"), "f = \"exp(s)\"\ng = 1");
}

} // namespace
} // namespace resonform
