// SPDX-License-Identifier: GPL-3.0-or-later
// Published normal forms of first-order flows and resonant oscillators, compared by what is invariant.
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::coefficient;
using test::coefficient_of;

Normalization normalized(const std::string& tables, int through) {
    const Normalization n =
        normalize_poincare(test::field_from("[system]\nname = \"flow\"\n" + tables), through);
    const Certificate c = test::certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    return n;
}

// Guckenheimer and Holmes, Nonlinear Oscillations, (3.4.11), for x' = -w y + f, y' = w x + g:
//   16 a = f_xxx + f_xyy + g_xxy + g_yyy + (f_xy (f_xx + f_yy) - g_xy (g_xx + g_yy) - f_xx g_xx + f_yy
//   g_yy)/w
// and r' = a r^3; here with every quadratic and cubic coefficient a symbol.
TEST(Literature, FirstLyapunovCoefficientOfAHopfPoint) {
    const Normalization n = normalized(
        "[parameters]\nw = { positive = true }\na = {}\nb = {}\nc = {}\nd = {}\ne = {}\nf = {}\np = {}\nq = "
        "{}\n"
        "r = {}\ns = {}\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
        "x = \"x' = -w*y + a*x^2 + b*x*y + c*y^2 + p*x^3 + q*x*y^2\"\n"
        "y = \"y' = w*x + d*x^2 + e*x*y + f*y^2 + r*x^2*y + s*y^3\"\n",
        3);
    const GradedField& field = *n.normal_form.field;
    const Polynomial cubic = coefficient_of(field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}});
    const Polynomial real = Rational(1) / 2 * (cubic + field.ring->conjugate(cubic));
    EXPECT_EQ(real, coefficient(field, "(6*p + 2*q + 2*r + 6*s)/16 + (b*(2*a + 2*c) - e*(2*d + 2*f) - 4*a*d "
                                       "+ 4*c*f)/(16*w)"));
}

// y' = -y + x + y^2 with x at rest: y = (1 - sqrt(1 - 4 x))/2 = sum of Catalan numbers times x^n.
TEST(Literature, CatalanSlowManifold) {
    constexpr int through = 9;
    const Normalization n =
        normalized("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                   "x = \"x' = -eps*x\"\ny = \"y' = -y + x + y^2\"\n",
                   through);
    const GradedField& field = *n.normal_form.field;
    std::int64_t catalan = 1; // C_1
    for (int k = 2; k <= through; ++k) {
        catalan = catalan * 2 * (2 * k - 3) / k;
        EXPECT_EQ(coefficient_of(field, n.map.mode[1], {{"z1", k}}), Polynomial(Rational(catalan))) << k;
    }
}

// Kuramoto, Chemical Oscillations, Waves, and Turbulence, chapter 2: beyond the bifurcation the cubic
// coefficient g has Im g/Re g = (4 - 7 A^2 + 4 A^4)/(3 A (2 + A^2)), and the growth rate is eps/2.
TEST(Literature, BrusselatorBeyondItsHopfPoint) {
    const Normalization n = test::certified(test::field_named("brusselator"), 3);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 1}, {"eps", 2}}),
              Polynomial(Rational(1) / 2));
    const Polynomial cubic = coefficient_of(field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}});
    const auto half = [](const Polynomial& p) { return Rational(1) / 2 * p; };
    EXPECT_EQ(half(cubic + field.ring->conjugate(cubic)), coefficient(field, "-(2 + A^2)/(8*A^2)"));
    EXPECT_EQ(half(cubic - field.ring->conjugate(cubic)),
              coefficient(field, "-(4 - 7*A^2 + 4*A^4)/(24*A^3)", true));
}

// The spring pendulum at 1:2 (Broer, Lunter, Vegter; also Nayfeh and Mook, section 6.5): of V = a x^2 y only
// x^2 y in resonance is left, z1' = i w z1 + i a/(2 w) z1bar z3 and z3' = 2 i w z3 + i a/(8 w) z1^2, and
// |z1|^2 + 4 |z3|^2 is an integral.
TEST(Literature, SpringPendulumAtOneToTwo) {
    const Normalization n =
        normalized("[parameters]\nw = { positive = true }\na = {}\n[variables]\nx = { role = \"fast\" }\n"
                   "y = { role = \"fast\" }\n[equations]\nx = \"x'' + w^2*x + 2*a*x*y = 0\"\n"
                   "y = \"y'' + 4*w^2*y + a*x^2 = 0\"\n",
                   4);
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z2", 1}, {"z3", 1}}),
              coefficient(field, "a/(2*w)", true));
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z1", 2}}), coefficient(field, "a/(8*w)", true));
    // quadratic energy along the normal form through weight 3 in the square
    const auto growth = [&](std::size_t mode) {
        const Polynomial product =
            ring.multiply(n.normal_form.mode[mode].part(2), ring.gen(field.modes[mode].zbar));
        return product + ring.conjugate(product);
    };
    EXPECT_TRUE((growth(0) + Rational(4) * growth(1)).empty());
}

// The same resonance declared with a detuning: w2 = 2 w1 + eps s keeps z1^2 and adds i s eps z3.
TEST(Literature, DeclaredResonanceWithDetuning) {
    const Normalization n = normalized(
        "[parameters]\nw1 = { positive = true }\nw2 = { positive = true }\na = {}\ns = {}\n[relations]\n"
        "w2 = \"2*w1 + eps*s\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
        "x = \"x'' + w1^2*x + 2*a*x*y = 0\"\ny = \"y'' + w2^2*y + a*x^2 = 0\"\n",
        3);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z3", 1}, {"eps", 1}}),
              coefficient(field, "s", true));
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z1", 2}}),
              coefficient(field, "a/(8*w1)", true));
}

} // namespace
} // namespace resonform
