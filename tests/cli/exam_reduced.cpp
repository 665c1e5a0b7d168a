// SPDX-License-Identifier: GPL-3.0-or-later
// No format prints a coefficient with a common factor above and below the fraction bar, and none is emitted.
#include "support/command.hpp"

namespace resonform::test {

namespace {

// The frequency of y is sqrt(s^2 - 4*k), where the ring has k as the square of the frequency of x.
class Reduced : public Command {
protected:
    Reduced() {
        write(scratch_.path() / "systems/pair/system.toml",
              "[system]\nname = \"pair\"\n[parameters]\nk = { positive = true }\ns = { positive = true }\n"
              "[domain]\npositive = [\"s^2 - 4*k\"]\n[variables]\nx = { role = \"fast\" }\n"
              "y = { role = \"fast\" }\n[equations]\nx = \"x'' + k*x + x*y = 0\"\n"
              "y = \"y'' + (s^2 - 4*k)*y + s*(s^2 - 4*k)*x^2 = 0\"\n");
        write(scratch_.path() / "systems/pair/scenes/s.toml",
              "order = 2\ntruncation = 2\noutputs = [\"y\"]\n[start]\namplitude.x = 1\nphase.x = 0\n"
              "amplitude.y = 1\nphase.y = 0\n");
        write(scratch_.path() / "systems/slaved/system.toml",
              "[system]\nname = \"slaved\"\n[parameters]\nk = { positive = true }\n[variables]\n"
              "x = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x*y = 0\"\n"
              "y = \"y' = -k*y + x*x'\"\n");
    }
    void expect(const std::string& command, const std::string& reduced, const std::string& unreduced) const {
        const std::string text = printed(command);
        EXPECT_NE(text.find(reduced), std::string::npos) << command << "\n" << text;
        EXPECT_EQ(text.find(unreduced), std::string::npos) << command << "\n" << text;
    }
};

} // namespace

TEST_F(Reduced, InEveryFormat) {
    const std::string derive = "derive pair --order 2 --format ";
    expect(derive + "text", "- s/2*z1*z2", "(s^2 - 4*k)/(2*(s^2 - 4*k))");
    expect(derive + "latex", "- \\frac{s}{2} z_{1} z_{2}",
           "\\left(s^{2} - 4 k\\right)}{2 \\left(s^{2} - 4 k");
    expect(derive + "json", "\"coefficient\":\"-s/2\"", "(s**2 - 4*k)/(2*(s**2 - 4*k))");
    expect(derive + "maxima", "- s/2*z1*z2", "(s^2 - 4*k)/(2*(s^2 - 4*k))");
    expect(derive + "sympy", "(1, 1, 0, 0, 0): -s/2,", "(s**2 - 4*k)/(2*(s**2 - 4*k))");
}

TEST_F(Reduced, OnTheSlowManifold) {
    const std::string derive = "derive slaved --order 3 --stage manifold --format ";
    expect(derive + "text", "I/(16*k)*z1*z2^2", "(k^2 + 4)/(16*k*(k^2 + 4))");
    expect(derive + "latex", "\\frac{i}{16 k} z_{1} z_{2}^{2}",
           "\\left(k^{2} + 4\\right)}{16 k \\left(k^{2} + 4");
    expect(derive + "json", "I/(16*k)\"", "(k**2 + 4)/(16*k*(k**2 + 4))");
}

// A division less than with s^2 - 4*k in the denominator of which it cancels.
TEST_F(Reduced, InEmittedCode) {
    expect("generate systems/pair/scenes/s.toml -o -", "//     - s/2*z1*z2", "(2*(s^2 - 4*k))");
    expect("generate systems/pair/scenes/s.toml -o -", ", 12 divide", ", 13 divide");
}

} // namespace resonform::test
