// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of slow variables in print: each notation, and SymPy as the judge of those it reads.
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/json.hpp"
#include "emit/display/latex.hpp"
#include "emit/display/spelling.hpp"
#include "printed.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

std::shared_ptr<const GradedField> adiabatic(const std::string& force) {
    return field_from("[system]\nname = \"a\"\n[parameters]\nn = {}\nr = { positive = true }\n[variables]\n"
                      "psi = { role = \"fast\" }\ntau = { role = \"slow\" }\n[functions]\n"
                      "omega = { of = [\"tau\"], positive = true }\n[equations]\n"
                      "psi = \"psi'' + omega(tau)^2*psi + " +
                      force + " = 0\"\ntau = \"tau' = eps\"\n");
}

// The coefficient of psi^2 in the equation through its own ring.
Polynomial coefficient_of(const GradedField& field, const std::string& text) {
    Scope scope = field.system().constants();
    scope.define("tau", field.system().variables[1].jet[0]);
    scope.define_function("omega");
    return field.coefficients->convert(read_expression(text, scope, SourceText{}), {});
}

struct Spelled {
    const char* name;
    const char *written, *text, *json, *latex, *maxima;
};

class Spellings : public ::testing::TestWithParam<Spelled> {};

TEST_P(Spellings, OfOneFunction) {
    const Spelled& expected = GetParam();
    const auto field = adiabatic(std::string("(") + expected.written + ")*psi^2");
    const DisplaySum shown = display(*field->ring, coefficient_of(*field, expected.written));
    EXPECT_EQ(spell(shown, text_spelling()), expected.text);
    EXPECT_EQ(spell(shown, json_spelling()), expected.json);
    EXPECT_EQ(latex(shown), expected.latex);
    EXPECT_EQ(spell(shown, maxima_spelling()), expected.maxima);
}

INSTANTIATE_TEST_SUITE_P(
    All, Spellings,
    ::testing::Values(Spelled{"exponential", "3*exp(-2*tau)", "3*exp(-2*tau)", "3*exp(-2*tau)",
                              "3 \\exp \\left(-2 \\tau\\right)", "3*exp(-2*tau)"},
                      Spelled{"angle", "sin(n*tau)^2*cos(r)", "-(cos(n*tau)^2 - 1)*cos(r)",
                              "-(cos(n*tau)**2 - 1)*cos(r)",
                              "-\\left(\\left(\\cos \\left(n \\tau\\right)\\right)^{2} - 1\\right) \\cos r",
                              "-(cos(n*tau)^2 - 1)*cos(r)"},
                      Spelled{"power", "exp(n*log(r))", "r^n", "r**n", "r^{n}", "r^n"},
                      Spelled{"named", "omega(tau)*omega'(tau)", "omega(tau)*omega'(tau)",
                              "omega(tau)*Derivative(omega(tau), tau)",
                              "\\omega\\left(\\tau\\right) \\omega'\\left(\\tau\\right)",
                              "omega(tau)*'diff(omega(tau), tau, 1)"},
                      Spelled{"elsewhere", "omega''(2*tau)", "omega''(2*tau)",
                              "Subs(Derivative(omega(_u), (_u, 2)), _u, 2*tau)",
                              "\\omega''\\left(2 \\tau\\right)", "at('diff(omega(u_), u_, 2), u_ = 2*tau)"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Sympy, ReadsFunctionsOfTheJson) {
    const Scratch scratch;
    write(scratch.path() / "normal_form.json",
          print_normal_form(*certified(adiabatic("omega'(2*tau)*psi^2"), 4), 4, Format::json));
    write(scratch.path() / "judge.py", R"py(
import json
from sympy import Function, Lambda, Symbol, exp, simplify, sympify
omega, tau, u = Function("omega"), Symbol("tau"), Symbol("u")
names = {"omega": omega, "tau": tau, "n": Symbol("n"), "r": Symbol("r", positive=True)}
document = json.load(open("normal_form.json"))
values = [sympify(t["coefficient"], locals=names) for t in document["normal_form"] + document["map"]]
assert len(values) > 10
first = next(t for t in document["normal_form"] if t["exponents"] == {"z1": 1, "eps": 1})
value = sympify(first["coefficient"], locals=names)
assert simplify(value + omega(tau).diff(tau)/(2*omega(tau))) == 0, value
assert simplify(value.subs(omega, Lambda(u, exp(3*u))).doit() + sympify("3/2")) == 0
for value in values: value.subs(omega, Lambda(u, 2 + u**2)).doit().subs({tau: 1}).evalf()
print("read")
)py");
    EXPECT_EQ(run("python3 judge.py", scratch.path()).out, "read\n")
        << run("python3 judge.py", scratch.path()).err;
}

TEST(SympyScript, RunsWithFunctions) {
    const Scratch scratch;
    write(scratch.path() / "script.py",
          print_normal_form(*certified(adiabatic("omega'(2*tau)*sin(tau)*psi^2"), 3), 3, Format::sympy));
    const Outcome outcome = run("python3 script.py", scratch.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Derivative(omega(tau), tau)"), std::string::npos) << outcome.out;
}

} // namespace
} // namespace resonform::test
