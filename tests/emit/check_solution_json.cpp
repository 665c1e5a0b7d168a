// SPDX-License-Identifier: GPL-3.0-or-later
// (22) and (23): the outputs of the plain truncation, read back from JSON by SymPy, equal the formulas as
// the paper prints them.
#include "printed.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

constexpr const char* compare = R"(
import json
from sympy import *
g, r, C = symbols("g r C_delta", positive=True)
v, xi, theta, eps, CX, CY, L1, Q = symbols("v xi theta eps C_X C_Y L1 Q_x2", real=True)
s = xi**2 + r**2
R = Rational
q = sqrt(g)
fx = -eps**2*C*v/(q*s**R(3, 8))*(xi*sin(theta) + eps*cos(theta)*(v*(8*r**2 + xi**2)
     + 2*r*q*C*sin(theta)*s**R(5, 8))/(8*q*s**R(3, 4)))
fy = eps**2*C*v/(q*s**R(3, 8))*(r*sin(theta) - eps*xi*cos(theta)*(7*r*v
     + 2*q*C*sin(theta)*s**R(5, 8))/(8*q*s**R(3, 4)))
paper = {
    "psi": eps*C/s**R(1, 8)*cos(theta)
        + eps**2*v*xi*(8*r*v + q*C*sin(theta)*s**R(5, 8))/(8*g*s**R(3, 2))
        + eps**3*C*cos(theta)*(g*C**2*s**R(5, 4)*(5 + 4*sin(theta)**2)
          + 6*v**2*(2*r**2 - xi**2))/(192*g*s**R(13, 8)),
    "x": CX + r*L1 - r*eps**2*Q + fx,
    "y": CY + sqrt(s) - eps**2/2*(r**2*v**2/(g*s) + C**2*s**R(1, 4)) + fy,
}
document = json.load(open("solution.json"))
names = {str(n): n for n in (g, r, C, v, xi, CX, CY, L1, Q)}
read = lambda text: sympify(text, locals=names)
functions = {"1": lambda a: 1, "cos": cos, "sin": sin}
for output in document["outputs"]:
    ours = sum(eps**t["eps"]*functions[t["function"]](t["harmonic"]*theta)*read(t["coefficient"])
               for t in output["terms"])
    difference = expand_trig(ours - paper[output["name"]])
    for n in range(8):
        at = {g: R(3 + n, 2), r: R(5, 3 + n), C: R(n + 1, 3), v: R(2 - n, 3), xi: R(n, 4) - 1,
              theta: R(n, 3), eps: R(1, 7), CX: 2, CY: 3, L1: R(4, 3), Q: R(1, 5)}
        assert abs(difference.subs(at).evalf(40)) < 1e-30, (output["name"], n)
quadrature = [p for p in document["primitives"] if p["kind"] == "quadrature"]
assert len(quadrature) == 1 and quadrature[0]["over"] == "xi"
assert simplify(read(quadrature[0]["argument"]) - (v**2*xi**2/(g*s**2) + C**2/(4*s**R(3, 4)))) == 0
logarithm = [p for p in document["primitives"] if p["kind"] == "logarithm"]
assert len(logarithm) == 1
assert simplify(read(logarithm[0]["argument"]) - (xi + sqrt(s))/r) == 0
print(sorted(o["name"] for o in document["outputs"]))
)";

TEST(SolutionJson, EqualsTheFormulasOfThePaper) {
    SolveOptions options;
    options.order = 3;
    options.truncation = 3;
    const Scratch scratch;
    write(scratch.path() / "solution.json", print_solution(solve(pendulum(3), options), Format::json));
    write(scratch.path() / "judge.py", compare);
    const Outcome outcome = run("python3 judge.py", scratch.path());
    EXPECT_EQ(outcome.out, "['psi', 'x', 'y']\n") << outcome.err;
}

} // namespace
} // namespace resonform::test
