// SPDX-License-Identifier: GPL-3.0-or-later
// The triangular point L4 of the restricted three-body problem: the determinant that decides its stability
// (Deprit and Deprit-Bartholome, Astron. J. 72 (1967) 173). With H_2 = w1 I1 - w2 I2 and
// K_4 = (A I1^2 + 2 B I1 I2 + C I2^2)/2,
//
//   D = -(A w2^2 + 2 B w1 w2 + C w1^2)
//     = -(36 - 541 w1^2 w2^2 + 644 w1^4 w2^4)/(8 (1 - 4 w1^2 w2^2) (4 - 25 w1^2 w2^2))
#include "certify/certificate.hpp"
#include "normalize/hamiltonians.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// w1^2 + w2^2 = 1 and w1 w2 give the mass ratio: s = 1 - 2 mu, s^2 = 1 - 16 w1^2 w2^2/27.
struct Masses {
    Rational w1, w2;
    const char* s;
};

std::string spelled(const Rational& r) { return "(" + to_string(r) + ")"; }

// The frame rotates and has its origin at L4:
//   H = (px^2 + py^2)/2 - x py + y px - s x/2 - sqrt(3) y/2 - (1 + s)/(2 r1) - (1 - s)/(2 r2),
//   r1^2 = 1 + 2 a + x^2 + y^2, a = (x + sqrt(3) y)/2,   r2^2 = 1 + 2 b + x^2 + y^2, b = (-x + sqrt(3) y)/2,
// 1/r by Legendre polynomials. The coordinates are canonical and diagonalise H_2: with k = 3 sqrt(3) s/4 the
// eigenvector of i w is x = k + 2 i w, y = -n, n = w^2 + 3/4; the bracket of its real and imaginary part is
// beta = w (k^2 - 4 n + 4 w^2 + n^2), and H_2 = sum of w (p^2/beta + beta q^2)/2.
std::string energy(const Masses& m) {
    const std::string s = std::string("(") + m.s + ")";
    const Rational k2 = Rational(27) / 16 - m.w1 * m.w1 * m.w2 * m.w2;
    std::string h2, x, y;
    for (const auto& [w, number] : {std::pair(m.w1, "1"), std::pair(m.w2, "2")}) {
        const std::string q = std::string("q") + number, p = std::string("p") + number;
        const Rational n = w * w + Rational(3) / 4, beta = w * (k2 - 4 * n + 4 * w * w + n * n);
        const std::string plus = x.empty() ? "" : " + ";
        h2 += plus + spelled(w / (2 * beta)) + "*" + p + "^2 + " + spelled(w * beta / 2) + "*" + q + "^2";
        x += plus + "3*sqrt(3)*" + s + "/4*" + q + " + " + spelled(2 * w / beta) + "*" + p;
        y += plus + spelled(-n) + "*" + q;
    }
    x = "(" + x + ")";
    y = "(" + y + ")";
    const std::string square = "(" + x + "^2 + " + y + "^2)";
    std::string potential;
    for (const int side : {1, -1}) {
        const std::string mass = side > 0 ? "(1 + " + s + ")/2" : "(1 - " + s + ")/2";
        const std::string a = std::string("((") + (side > 0 ? "" : "-") + x + " + sqrt(3)*" + y + ")/2)";
        potential += " + " + mass + "*(5*" + a + "^3 - 3*" + a + "*" + square + ")/2 - " + mass + "*(35*" +
                     a + "^4 - 30*" + a + "^2*" + square + " + 3*" + square + "^2)/8";
    }
    return h2 + potential;
}

class TriangularPoint : public testing::TestWithParam<Masses> {};

TEST_P(TriangularPoint, HasTheDeterminantOfDeprit) {
    const Masses& m = GetParam();
    const auto field = test::field_from(
        "[system]\nname = \"l4\"\n[variables]\nq1 = { role = \"fast\" }\np1 = { role = \"fast\" }\n"
        "q2 = { role = \"fast\" }\np2 = { role = \"fast\" }\n[hamiltonian]\nenergy = \"" +
        energy(m) + "\"\nmomenta = { q1 = \"p1\", q2 = \"p2\" }\n");
    const Normalization n = normalize_hamiltonian(field, 3);
    const Certificate c = certify(n.normal_form, n.map);
    EXPECT_TRUE(c.holds) << c.complaint;

    const Ring& ring = *field->ring;
    const HamiltonianForm& form = *n.normal_form.hamiltonian;
    // z zbar = b I with {z, zbar} = +- i b, b > 0
    std::vector<Rational> b, signs;
    for (const HamiltonianForm::Bracket& bracket : form.brackets) {
        ASSERT_EQ(bracket.value.size(), 1U);
        const Rational value = bracket.value.terms().front().coefficient;
        b.push_back(cln::abs(value));
        signs.push_back(value > 0 ? 1 : -1);
    }
    EXPECT_EQ(signs, (std::vector<Rational>{1, -1}));
    const auto in_energy = [&](const Polynomial& part, int e1, int e2) -> Rational {
        const Polynomial monomial = test::monomial(ring, {{"z1", e1}, {"z2", e1}, {"z3", e2}, {"z4", e2}});
        for (const Term& t : part.terms())
            if (t.monomial == monomial.terms().front().monomial) {
                Rational value = t.coefficient;
                for (int k = 0; k < e1; ++k) value = value * b[0];
                for (int k = 0; k < e2; ++k) value = value * b[1];
                return value;
            }
        return 0;
    };
    EXPECT_EQ(in_energy(form.energy.part(2), 1, 0), m.w1);
    EXPECT_EQ(in_energy(form.energy.part(2), 0, 1), -m.w2);
    const Polynomial& k4 = form.energy.part(4);
    EXPECT_EQ(k4.size(), 3U); // rational, and of actions only
    const Rational determinant = -2 * (in_energy(k4, 2, 0) * m.w2 * m.w2 + in_energy(k4, 1, 1) * m.w1 * m.w2 +
                                       in_energy(k4, 0, 2) * m.w1 * m.w1);
    const Rational square = m.w1 * m.w1 * m.w2 * m.w2;
    EXPECT_EQ(to_string(determinant), to_string(-(36 - 541 * square + 644 * square * square) /
                                                (8 * (1 - 4 * square) * (4 - 25 * square))));
}

INSTANTIATE_TEST_SUITE_P(LiteratureHamiltonian, TriangularPoint,
                         testing::Values(Masses{Rational(4) / 5, Rational(3) / 5, "sqrt(4857)/75"},
                                         Masses{Rational(12) / 13, Rational(5) / 13, "sqrt(237849)/507"}),
                         [](const auto& tested) {
                             return tested.index == 0 ? "FourToThree" : "TwelveToFive";
                         });

} // namespace
} // namespace resonform
