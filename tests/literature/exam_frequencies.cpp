// SPDX-License-Identifier: GPL-3.0-or-later
// Frequencies that are known in closed form or to high order. They are invariants: no convention of the
// normal form enters.
#include "certify/certificate.hpp"
#include "literature/rational_series.hpp"
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace resonform {
namespace {

using test::RationalSeries;

RationalSeries frequency_of_duffing(int through) {
    // x'' + x + x^3 = 0: omega = sqrt(1 + A^2)/(2/pi K(m)), m = A^2/(2 (1 + A^2))
    const RationalSeries a = RationalSeries::variable(through), one(through, 1);
    const RationalSeries square = one + a * a;
    const RationalSeries m = RationalSeries(through, Rational(1) / 2) * a * a * square.power(-1);
    return square.power(Rational(1) / 2) * test::elliptic(m).power(-1);
}

RationalSeries frequency_of_pendulum(int through) {
    // psi'' + sin psi = 0: omega = 1/(2/pi K(sin^2(A/2))), sin^2(A/2) = (1 - cos A)/2
    RationalSeries cosine(through, 1);
    Rational factorial = 1;
    for (int n = 2; n <= through; n += 2) {
        factorial = factorial * Rational(n) * Rational(n - 1);
        cosine[n] = (n % 4 == 0 ? 1 : -1) / factorial;
    }
    const RationalSeries m = RationalSeries(through, Rational(1) / 2) * (RationalSeries(through, 1) - cosine);
    return test::elliptic(m).power(-1);
}

// A series of an autonomous oscillator at w = wbar = rho, its coefficients divided by i^divide_by_i.
RationalSeries on_the_axis(const Ring& ring, const Series& series, int divide_by_i, int through) {
    RationalSeries s(through);
    for (int n = 0; n <= std::min(through, series.through()); ++n)
        for (const Term& t : series.part(n).terms()) {
            EXPECT_EQ(ring.exponent(t.monomial, Ring::imaginary_unit), divide_by_i);
            s[n] = s[n] + t.coefficient;
        }
    return s;
}

// rho omega(A(rho)) is the rate of the normal form, with A(rho) the value of x at theta = 0.
void expect_frequency(const std::string& equation, const RationalSeries& frequency) {
    const int through = frequency.through();
    const auto field = test::field_from("[system]\nname = \"one\"\n[variables]\nx = { role = \"fast\" }\n"
                                        "[equations]\nx = \"" +
                                        equation + "\"\n");
    const Normalization n = normalize_poincare(field, through);
    EXPECT_TRUE(certify(n.normal_form, n.map).holds);
    const RationalSeries rho = RationalSeries::variable(through);
    const RationalSeries amplitude = rho + on_the_axis(*field->ring, n.map.mode[0], 0, through);
    EXPECT_TRUE(on_the_axis(*field->ring, n.normal_form.mode[0], 1, through) ==
                rho * RationalSeries::composed(frequency, amplitude));
}

constexpr int eleventh = 11;

TEST(Literature, DuffingFrequencyToOrderEleven) {
    const RationalSeries frequency = frequency_of_duffing(eleventh);
    EXPECT_EQ(frequency[4], Rational(-21) / 256); // Nayfeh and Mook, Nonlinear Oscillations, section 2.3
    expect_frequency("x'' + x + x^3 = 0", frequency);
}

TEST(Literature, PendulumFrequencyToOrderEleven) {
    const RationalSeries frequency = frequency_of_pendulum(eleventh);
    EXPECT_EQ(frequency[4], Rational(1) / 3072);
    expect_frequency("x'' + sin(x) = 0", frequency);
}

// N = w (growth + i frequency), both series in eps with polynomials in a = w wbar.
struct Polar {
    std::vector<std::vector<Rational>> growth, frequency; // [power of eps][power of a]
};

Polar polar(const Normalization& n) {
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    const auto size = static_cast<std::size_t>(n.normal_form.through) + 1;
    constexpr std::size_t most = 40;
    Polar result{{size, std::vector<Rational>(most, 0)}, {size, std::vector<Rational>(most, 0)}};
    for (int k = 0; k <= n.normal_form.through; ++k)
        for (const Term& t : n.normal_form.mode[0].part(k).terms()) {
            auto& part =
                ring.exponent(t.monomial, Ring::imaginary_unit) == 0 ? result.growth : result.frequency;
            part[static_cast<std::size_t>(ring.exponent(t.monomial, field.eps))]
                [static_cast<std::size_t>(ring.exponent(t.monomial, field.modes[0].zbar))] = t.coefficient;
        }
    return result;
}

RationalSeries at(const std::vector<std::vector<Rational>>& part, const RationalSeries& a) {
    const int through = a.through();
    RationalSeries sum(through);
    for (int k = 0; k <= through; ++k) {
        RationalSeries power(through, 1);
        for (const Rational& c : part[static_cast<std::size_t>(k)]) {
            for (int n = 0; n + k <= through; ++n) sum[n + k] = sum[n + k] + c * power[n];
            power = power * a;
        }
    }
    return sum;
}

// Andersen and Geer, SIAM J. Appl. Math. 42 (1982) 678: the limit cycle's frequency is
//   1 - eps^2/16 + 17 eps^4/3072 + 35 eps^6/884736 - 678899 eps^8/5096079360 + ...
TEST(Literature, VanDerPolCycleToOrderEight) {
    constexpr int through = 9; // growth at eps^9 fixes the radius at eps^8
    const auto field = test::field_from("[system]\nname = \"van_der_pol\"\n[variables]\n"
                                        "x = { role = \"fast\", weight = 0 }\n[equations]\n"
                                        "x = \"x'' + x = eps*(1 - x^2)*x'\"\n");
    const Normalization n = normalize_poincare(field, through);
    EXPECT_TRUE(certify(n.normal_form, n.map).holds);
    const Polar p = polar(n);
    // growth/eps = 1/2 - a/8 + ... = 0 by a Newton step for each order
    RationalSeries a(through, 4);
    for (int k = 1; k < through; ++k) a[k] = a[k] + Rational(8) * at(p.growth, a)[k + 1];
    const RationalSeries growth = at(p.growth, a), frequency = at(p.frequency, a);
    for (int k = 0; k <= through; ++k) EXPECT_EQ(growth[k], 0) << k;
    EXPECT_EQ(frequency[0], 1);
    EXPECT_EQ(frequency[2], Rational(-1) / 16);
    EXPECT_EQ(frequency[4], Rational(17) / 3072);
    EXPECT_EQ(frequency[6], Rational(35) / 884736);
    EXPECT_EQ(frequency[8], Rational("-678899/5096079360"));
}

} // namespace
} // namespace resonform
