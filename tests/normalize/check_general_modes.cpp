// SPDX-License-Identifier: GPL-3.0-or-later
// Modes of every kind, slow variables driven by fast ones, angles: known answers, and the certificate.
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::certificate_of;
using test::coefficient_of;
using test::field_from;

struct Declared {
    std::string variables, equations, parameters, domain;
};

std::string toml(const Declared& d) {
    return "[system]\nname = \"general\"\n[parameters]\n" + d.parameters + "[variables]\n" + d.variables +
           (d.domain.empty() ? "" : "[domain]\npositive = [" + d.domain + "]\n") + "[equations]\n" +
           d.equations;
}

Normalization normalized(const Declared& d, int through) {
    const Normalization n = normalize_poincare(field_from(toml(d)), through);
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint << "\n" << toml(d);
    return n;
}

Polynomial number(std::int64_t p, std::int64_t q = 1) { return Polynomial(Rational(p) / q); }

// Poincare: x' = x, y' = 2 y + x^2 is resonant (2 = 1 + 1) and cannot be linearised.
TEST(GeneralModes, ResonantNodeKeepsItsSquare) {
    const Normalization n = normalized({"x = { role = \"fast\" }\ny = { role = \"fast\" }\n",
                                        "x = \"x' = x\"\ny = \"y' = 2*y + x^2 + 3*x*y + y^2\"\n", "", ""},
                                       6);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z1", 2}}), number(1));
    EXPECT_EQ(n.normal_form.mode[1].total(6).size(), 2U);
    EXPECT_EQ(n.normal_form.mode[0].total(6).size(), 1U);
}

// x'' - x + x^2 = 0: the period of motion near the saddle is not defined, but H is: the product z1 z2 is an
// integral, so that both rates have the same factor with opposite signs.
TEST(GeneralModes, ASaddleHasTheIntegralZ1Z2) {
    const Normalization n =
        normalized({"x = { role = \"fast\" }\n", "x = \"x'' - x + x^2 = 0\"\n", "", ""}, 7);
    const Ring& ring = *n.normal_form.field->ring;
    const Mode& first = n.normal_form.field->modes[0];
    const Mode& second = n.normal_form.field->modes[1];
    EXPECT_TRUE((ring.multiply(n.normal_form.mode[0].total(7), ring.gen(second.z)) +
                 ring.multiply(n.normal_form.mode[1].total(7), ring.gen(first.z)))
                    .empty());
    EXPECT_EQ(coefficient_of(*n.normal_form.field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}}),
              number(-5, 3));
}

// x' = x y, y' = -y + x^2: on the centre manifold y = x^2 + ..., x' = x^3 + ...
TEST(GeneralModes, ACentreManifoldIsRead) {
    const Normalization n = normalized({"x = { role = \"fast\" }\ny = { role = \"fast\" }\n",
                                        "x = \"x' = x*y\"\ny = \"y' = -y + x^2\"\n", "", ""},
                                       5);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 3}}), number(1));
    EXPECT_EQ(coefficient_of(field, n.map.mode[1], {{"z1", 2}}), number(1));
    // y = x^2 - 2 x^4 + ... on the manifold: h obeys h' x^3... = -h + x^2
    EXPECT_EQ(coefficient_of(field, n.map.mode[1], {{"z1", 4}}), number(-2));
}

// s' = k s + s^2 has h_2 = s^2/k for any k that is not zero, declared so or not.
TEST(GeneralModes, SymbolsOfUnknownSignAreDividedBy) {
    for (const std::string rate : {"k", "k*m", "-2*k^2*m", "k*(k + m)"}) {
        const Normalization n = normalized(
            {"s = { role = \"fast\" }\n", "s = \"s' = " + rate + "*s + s^2\"\n", "k = {}\nm = {}\n", ""}, 4);
        const GradedField& field = *n.normal_form.field;
        EXPECT_EQ(n.normal_form.mode[0].total(4).size(), field.modes[0].growth.size()) << rate;
        const Polynomial square = coefficient_of(field, n.map.mode[0], {{"z1", 2}});
        EXPECT_EQ(field.ring->multiply(square, field.modes[0].growth), number(1)) << rate;
    }
}

// Two rates that hold roots are known as they are written, without a root of the square of their difference.
TEST(GeneralModes, RatesThatHoldRootsAreKnown) {
    for (const std::string f : {"3/2/sqrt(2 + (k - 1/3)^2)", "(3 + 2*sin(7/10))/2", "1/(2 + sqrt(3))"}) {
        const Normalization n =
            normalized({"y = { role = \"fast\" }\n",
                        "y = \"y'' = -(" + f + " + 2)*y' - " + f + "*2*y + y*y'\"\n", "k = {}\n", ""},
                       3);
        const std::vector<Mode>& modes = n.normal_form.field->modes;
        EXPECT_TRUE(modes[0].growth == number(-2) || modes[1].growth == number(-2)) << f;
    }
}

TEST(GeneralModes, DampedOscillatorIsLinearised) {
    const Normalization n =
        normalized({"x = { role = \"fast\" }\n", "x = \"x'' + 2*d*x' + w2*x + x^3 + x^2*x' = 0\"\n",
                    "d = { positive = true }\nw2 = { positive = true }\n", "\"w2 - d^2\""},
                   3);
    EXPECT_EQ(n.normal_form.mode[0].total(3), n.normal_form.mode[0].part(1));
}

// Symmetric: normal coordinates q = (x +- y)/2 with squares 2 and 4; x^3 + y^3 in each equation.
TEST(GeneralModes, CoupledOscillatorsAreDecoupled) {
    const Normalization n =
        normalized({"x = { role = \"fast\" }\ny = { role = \"fast\" }\n",
                    "x = \"x'' + 3*x - y + x^3 = 0\"\ny = \"y'' + 3*y - x + y^3 = 0\"\n", "", ""},
                   3);
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    EXPECT_EQ(ring.multiply(field.modes[0].omega, field.modes[0].omega), number(2));
    EXPECT_EQ(field.modes[1].omega, number(2));
    // q'' + 4 q + q^3 + 3 q p^2 = 0: frequency 2 + 3 a^2/16 for q alone
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z3", 2}, {"z4", 1}}),
              ring.multiply(ring.imaginary(), number(3, 16)));
}

TEST(GeneralModes, TriangularCouplingsHoldTheirCertificate) {
    normalized(
        {"x = { role = \"fast\" }\ny = { role = \"fast\" }\ntau = { role = \"slow\" }\n",
         "x = \"x'' + (1 + tau)*x + y^2 + eps*y = 0\"\ny = \"y' = -a*y + x + x*y\"\ntau = \"tau' = eps\"\n",
         "a = { positive = true }\n", "\"1 + tau\""},
        3);
    normalized({"x = { role = \"fast\" }\ny = { role = \"fast\" }\n",
                "x = \"x'' + x + 2*y' + y + y^2 = 0\"\ny = \"y'' + 5*y + x*y = 0\"\n", "", ""},
               3);
    normalized({"x = { role = \"fast\" }\ny = { role = \"fast\" }\n",
                "x = \"x' = -x - 2*y + x*y\"\ny = \"y' = 3*x - y + y^2 + eps*x\"\n", "", ""},
               4);
}

// van der Pol graded by eps alone: radius 2 to all orders of N_1, frequency 1 - eps^2/16 + 17 eps^4/3072.
TEST(GeneralModes, VanDerPolCycle) {
    const Normalization n = normalized(
        {"x = { role = \"fast\", weight = 0 }\n", "x = \"x'' + x = eps*(1 - x^2)*x'\"\n", "", ""}, 4);
    const GradedField& field = *n.normal_form.field;
    const Polynomial i = field.ring->imaginary();
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 1}, {"eps", 1}}), number(1, 2));
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}, {"eps", 1}}),
              number(-1, 8));
    const auto times_i = [&](std::int64_t p, std::int64_t q) {
        return field.ring->multiply(i, number(p, q));
    };
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 1}, {"eps", 2}}), times_i(-1, 8));
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}, {"eps", 2}}),
              times_i(3, 16));
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 3}, {"z2", 2}, {"eps", 2}}),
              times_i(-11, 256));
}

// The fast oscillation pushes its slow parameter: xi' = x x' averages to nothing at weight 2, but xi moves
// with it: k = x^2/2 with its mean taken out; and the frequency of x feels k.
TEST(DrivenSlowVariables, AreNormalisedWithTheirMaps) {
    const Normalization n =
        normalized({"x = { role = \"fast\" }\nxi = { role = \"slow\" }\nu = { role = \"drift\" }\n",
                    "x = \"x'' + sqrt(xi^2 + r^2)*x + x^3 = 0\"\nxi = \"xi' = x*x' + eps*x^2 + eps\"\n"
                    "u = \"u' = xi*x\"\n",
                    "r = { positive = true }\n", ""},
                   4);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.map.slow[0], {{"z1", 2}}), number(1, 8));
    EXPECT_TRUE(coefficient_of(field, n.map.slow[0], {{"z1", 1}, {"z2", 1}}).empty());
    EXPECT_EQ(coefficient_of(field, n.normal_form.slow[0], {{"eps", 1}}), number(1));
}

TEST(DrivenSlowVariables, EachCouplingIsCertified) {
    const std::string two = "xi = { role = \"slow\", positive = true }\neta = { role = \"slow\" }\n";
    normalized({"x = { role = \"fast\" }\n" + two,
                "x = \"x'' + xi*x + eta*x^2 = 0\"\nxi = \"xi' = eps*x*eta\"\neta = \"eta' = x^2 + eps*xi\"\n",
                "", ""},
               3);
    // weight 0: A'(zeta) k_n w at the weight of k
    normalized({"x = { role = \"fast\", weight = 0 }\nxi = { role = \"slow\", positive = true }\n",
                "x = \"x'' + xi^2*x = eps*x^2\"\nxi = \"xi' = eps*x^2 + eps*x*x'\"\n", "", ""},
               2);
    // a rate linear in the fast variable: g_u h_n at weight n
    normalized({"x = { role = \"fast\" }\nxi = { role = \"slow\" }\n",
                "x = \"x'' + x + (1 + xi)*x^2 = 0\"\nxi = \"xi' = (2 + xi)*x' + eps*xi\"\n", "", ""},
               4);
}

// J' = eps cos phi, phi' = J: the mean of phi' is that of J, so theta' = zeta exactly; and the energy
// E = J^2/2 - eps sin phi is zeta^2/2 + 3 eps^2/(4 zeta^2) + ..., as the period of phi,
// the integral of d phi/sqrt(2 E + 2 eps sin phi), says: zeta = sqrt(2 E) (1 - 3 eps^2/(16 E^2) + ...).
TEST(Angles, PendulumInRotation) {
    const Normalization n =
        normalized({"J = { role = \"slow\", positive = true }\nphi = { role = \"angle\" }\n",
                    "J = \"J' = eps*cos(phi)\"\nphi = \"phi' = J\"\n", "", ""},
                   4);
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    EXPECT_TRUE(n.normal_form.slow[0].total(4).empty());
    EXPECT_EQ(coefficient_of(field, n.normal_form.angle[0], {}), ring.gen(field.slow[0].generator));
    EXPECT_EQ(n.normal_form.angle[0].total(4).size(), 1U);
    const Polynomial k =
        coefficient_of(field, n.map.slow[0], {{"phi", 1}, {"eps", 1}}); // J = zeta + k e^{i theta} + ...
    const Polynomial m =
        coefficient_of(field, n.map.angle[0], {{"phi", 1}, {"eps", 1}}); // phi = theta + m e^{i theta} + ...
    EXPECT_EQ(ring.multiply(k, ring.conjugate(k)) - m,
              Rational(3) / 4 * ring.gen(field.slow[0].generator, -2));
}

TEST(Angles, ForcedOscillatorsAndSeveralAngles) {
    normalized({"x = { role = \"fast\" }\nt1 = { role = \"angle\" }\n",
                "x = \"x'' + x + x^3 = eps*cos(t1) + eps^2*x*sin(2*t1)\"\nt1 = \"t1' = W\"\n",
                "W = { positive = true }\n", ""},
               3);
    normalized({"J = { role = \"slow\", positive = true }\nK = { role = \"slow\", positive = true }\n"
                "p = { role = \"angle\" }\nq = { role = \"angle\" }\n",
                "J = \"J' = eps*sin(p - 2*q)\"\nK = \"K' = -2*eps*sin(p - 2*q) + eps^2*cos(q)\"\n"
                "p = \"p' = J + eps*cos(p)\"\nq = \"q' = K^2 + J\"\n",
                "", ""},
               2);
    normalized({"x = { role = \"fast\", weight = 0 }\nxi = { role = \"slow\", positive = true }\n"
                "p = { role = \"angle\" }\n",
                "x = \"x'' + xi^2*x = eps*x*cos(p + x - x)\"\nxi = \"xi' = eps*x^2*sin(p)\"\np = \"p' = xi + "
                "eps*x\"\n",
                "", ""},
               2);
}

TEST(Angles, AResonantForcingAsLargeAsTheModeIsRefused) {
    const Error e = test::error_when([&] {
        normalize_poincare(field_from(toml({"x = { role = \"fast\" }\nt1 = { role = \"angle\" }\n",
                                            "x = \"x'' + x = eps*cos(t1)\"\nt1 = \"t1' = 1\"\n", "", ""})),
                           2);
    });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(e.what()).find("scale the forcing"), std::string::npos) << e.what();
    // scaled, it is kept
    const Normalization n = normalized({"x = { role = \"fast\" }\nt1 = { role = \"angle\" }\n",
                                        "x = \"x'' + x + x^3 = eps^3*cos(t1)\"\nt1 = \"t1' = 1\"\n", "", ""},
                                       3);
    EXPECT_FALSE(
        coefficient_of(*n.normal_form.field, n.normal_form.mode[0], {{"t1", 1}, {"eps", 3}}).empty());
}

// The squares of the eigenvalues are 1 +- sqrt(2): sqrt(sqrt(2) - 1) = 1/sqrt(sqrt(2) + 1) is no root of its
// own.
TEST(GeneralModes, NumbersWithDependentRoots) {
    const std::string two = "x = { role = \"fast\" }\ny = { role = \"fast\" }\n";
    normalized({two, "x = \"x'' - x + 2*y + x*y = 0\"\ny = \"y'' + x - y = x^2\"\n", "", ""}, 2);
    // a double pendulum in numbers: squares 2 +- sqrt(2), with the product 2
    normalized({two,
                "x = \"(2 + y^2)*x'' + cos(x - y)*y'' + sin(x - y)*y'^2 + 2*sin(x) = 0\"\n"
                "y = \"cos(x - y)*x'' + y'' - sin(x - y)*x'^2 + sin(y) = eps*x'\"\n",
                "", ""},
               2);
}

} // namespace
} // namespace resonform
