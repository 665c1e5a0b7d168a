// SPDX-License-Identifier: GPL-3.0-or-later
// A complex divisor vanishes where both of its parts do: one surface is one line.
#include "printed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace resonform {
namespace {

// Damped by d, as fast as y where k - d^2 = w^2: D(z1*z5) of z3 is -2*d - i*(w - sqrt(k - d^2)).
const std::string damped_pair = R"toml(
[system]
name = "test"
[parameters]
d = {}
w = { positive = true }
k = { positive = true }
[domain]
positive = ["k - d^2"]
[variables]
x = { role = "fast" }
y = { role = "fast" }
q = { role = "fast" }
[equations]
x = "x'' + 2*d*x' + k*x = x*y + q*x"
y = "y'' + w^2*y = x^2 + x*q"
q = "q' = -d*q + x^2 + y*q"
)toml";

std::string printed_surfaces(Format format) {
    const Normalization n = normalize_poincare(test::field_from(damped_pair), 2);
    const std::string text = print_divisors(*n.normal_form.field, n.divisors, 2, format);
    return text.substr(text.find("resonance surfaces"));
}

TEST(ResonanceSurfaces, OfTwoEquationsAreOneLineEach) {
    const std::string text = printed_surfaces(Format::text);
    EXPECT_EQ(std::count(text.begin(), text.end(), '='), 6)
        << text; // 4 surfaces, two of them of two equations
    EXPECT_EQ(text.find("\n  d = 0\n"), text.rfind("\n  d = 0\n")) << text;
    EXPECT_NE(text.find("\n  d = 0 and "), std::string::npos) << text;
    EXPECT_NE(printed_surfaces(Format::latex).find(" d &= 0 \\quad\\text{and}\\quad "), std::string::npos);
}

// The ring has learned 1 - c; the equation begins with c.
TEST(ResonanceSurfaces, BeginWithoutAMinus) {
    const Normalization n = normalize_poincare(
        test::field_from(
            "[system]\nname = \"test\"\n[variables]\nf = { role = \"angle\" }\n"
            "c = { role = \"slow\" }\n[equations]\nf = \"f' = c - 1\"\nc = \"c' = eps*cos(f)\"\n"),
        1);
    const std::string text = print_divisors(*n.normal_form.field, n.divisors, 1, Format::text);
    EXPECT_NE(text.find("resonance surfaces:\n  c - 1 = 0\n"), std::string::npos) << text;
}

} // namespace
} // namespace resonform
