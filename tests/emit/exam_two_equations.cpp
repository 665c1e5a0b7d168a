// SPDX-License-Identifier: GPL-3.0-or-later
// A complex divisor vanishes where both of its parts do: one surface is one line.
#include "printed.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace resonform {
namespace {

// Damped by d, as fast as y where k - d^2 = w^2: D(z1*z5) of z3 is -2*d - i*(w - sqrt(k - d^2)).
const std::string damped_pair =
    test::system_text("test",
                      {{"x", "fast", "x'' + 2*d*x' + k*x = x*y + q*x"},
                       {"y", "fast", "y'' + w^2*y = x^2 + x*q"},
                       {"q", "fast", "q' = -d*q + x^2 + y*q"}},
                      "[parameters]\nd = {}\nw = { positive = true }\nk = { positive = true }\n"
                      "[domain]\npositive = [\"k - d^2\"]\n");

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
    const Normalization n =
        normalize_poincare(test::field_from(test::system_text(
                               "test", {{"f", "angle", "f' = c - 1"}, {"c", "slow", "c' = eps*cos(f)"}})),
                           1);
    const std::string text = print_divisors(*n.normal_form.field, n.divisors, 1, Format::text);
    EXPECT_NE(text.find("resonance surfaces:\n  c - 1 = 0\n"), std::string::npos) << text;
}

} // namespace
} // namespace resonform
