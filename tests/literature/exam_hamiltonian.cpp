// SPDX-License-Identifier: GPL-3.0-or-later
// Energies as functions of actions that are known in closed form, by second-order averaging, or from the
// other style: invariants, no convention enters.
#include "certify/certificate.hpp"
#include "literature/on_plane.hpp"
#include "literature/rational_series.hpp"
#include "normalize/hamiltonians.hpp"

#include <gtest/gtest.h>

#include <array>

namespace resonform {
namespace {

using test::OnPlane;
using test::RationalSeries;

Normalization certified(const std::string& toml, int order) {
    Normalization n = normalize_hamiltonian(test::field_from(toml), order);
    n.certificate = certify(n.normal_form, n.map);
    EXPECT_TRUE(n.certificate.holds) << n.certificate.complaint;
    return n;
}

// The coefficient of a monomial in K; a rational number.
Rational in_energy(const Normalization& n, const std::vector<std::pair<std::string, int>>& powers) {
    const Ring& ring = *n.normal_form.field->ring;
    const Monomial wanted = test::monomial(ring, powers).terms().front().monomial;
    const Polynomial& part = n.normal_form.hamiltonian->energy.part(ring.weight(wanted));
    for (const Term& t : part.terms())
        if (t.monomial == wanted) return t.coefficient;
    return 0;
}

Rational power(const Rational& base, int n) {
    Rational result = 1;
    for (int k = 0; k < n; ++k) result = result * base;
    return result;
}

// K as a series in the action of an oscillator with {z, zbar} = 2 i, so that z zbar = 2 I.
RationalSeries energy_by_action(const Normalization& n, const std::string& z, const std::string& zbar,
                                int through) {
    RationalSeries energy(through);
    for (int k = 1; k <= through; ++k) energy[k] = in_energy(n, {{z, k}, {zbar, k}}) * power(2, k);
    return energy;
}

RationalSeries derivative(const RationalSeries& s) {
    RationalSeries d(s.through());
    for (int k = 1; k <= s.through(); ++k) d[k - 1] = s[k] * Rational(k);
    return d;
}

RationalSeries integral(const RationalSeries& s) {
    RationalSeries i(s.through());
    for (int k = 1; k <= s.through(); ++k) i[k] = s[k - 1] / Rational(k);
    return i;
}

// H = p^2/2 + 1 - cos x = 2 m:  dI/dm = 2/omega = 2 (2/pi K(m))
TEST(LiteratureHamiltonian, PendulumToOrderEleven) {
    constexpr int pairs = 6; // K through weight 12
    const Normalization n = certified(test::one_degree("px^2/2 + 1 - cos(x)"), 11);
    const RationalSeries energy = energy_by_action(n, "z1", "z2", pairs), m = RationalSeries::variable(pairs);
    const RationalSeries action = integral(RationalSeries(pairs, 2) * test::elliptic(m));
    EXPECT_TRUE(RationalSeries::composed(energy, action) == RationalSeries(pairs, 2) * m);
    // omega = dK/dI = 1 - I/8 - 3 I^2/256 - ...   (Lichtenberg and Lieberman, Regular and Stochastic Motion)
    EXPECT_EQ(derivative(energy)[1], Rational(-1) / 8);
    EXPECT_EQ(derivative(energy)[2], Rational(-3) / 256);
}

// H = p^2/2 + x^2/2 + x^4/4 = a/2 + a^2/4 with a = A^2: omega = sqrt(1 + a)/(2/pi K(a/(2 + 2 a)))
TEST(LiteratureHamiltonian, DuffingToOrderEleven) {
    constexpr int pairs = 6;
    const Normalization n = certified(test::one_degree("px^2/2 + x^2/2 + x^4/4"), 11);
    const RationalSeries a = RationalSeries::variable(pairs), one(pairs, 1);
    const Rational half = Rational(1) / 2;
    const RationalSeries energy =
        RationalSeries(pairs, half) * a + RationalSeries(pairs, half * half) * a * a;
    const RationalSeries m = RationalSeries(pairs, half) * a * (one + a).power(-1);
    const RationalSeries period = test::elliptic(m) * (one + a).power(-half); // over 2 pi
    EXPECT_TRUE(RationalSeries::composed(energy_by_action(n, "z1", "z2", pairs),
                                         integral(derivative(energy) * period)) == energy);
}

// The invariant line x = 0 of Henon and Heiles: H = p^2/2 + y^2/2 - y^3/3, whose action is
//   I = 1/2 sum_m (1/2)_{3m}/((2m)! (m+1)!) (2/3)^{2m} (2 E)^{m+1}
// (the binomial series of (2 E - y^2 + 2 y^3/3)^{1/2}, term by term around the cut).
TEST(LiteratureHamiltonian, HenonHeilesOnTheInvariantLine) {
    constexpr int pairs = 4;
    const Normalization n = certified(test::henon_heiles(), 2 * pairs - 1);
    RationalSeries action(pairs);
    for (int m = 0; m < pairs; ++m) {
        Rational c = Rational(1) / 2 * power(Rational(2) / 3, 2 * m) * power(2, m + 1);
        for (int j = 0; j < 3 * m; ++j) c = c * (Rational(j) + Rational(1) / 2);
        for (int j = 2; j <= 2 * m; ++j) c = c / Rational(j);
        for (int j = 2; j <= m + 1; ++j) c = c / Rational(j);
        action[m + 1] = c;
    }
    const RationalSeries energy = energy_by_action(n, "z3", "z4", pairs);
    EXPECT_TRUE(RationalSeries::composed(energy, action) == RationalSeries::variable(pairs));
    EXPECT_EQ(energy[2], Rational(-5) / 12);
}

// Gustavson, Astron. J. 71 (1966) 670: through degree 4 the normal form is a function of I1 + I2 and of the
// angular momentum L = x py - y px alone, K4 = -5/12 (I1 + I2)^2 + 7/12 L^2.
TEST(LiteratureHamiltonian, HenonHeilesOfDegreeFour) {
    const Normalization n = certified(test::henon_heiles(), 3);
    // I1 + I2 = (z1 z2 + z3 z4)/2,  L = (z1 z4 - z2 z3)/(2 i)
    const Rational sum = Rational(-5) / 12 / 4, turn = Rational(-7) / 12 / 4;
    EXPECT_EQ(in_energy(n, {{"z1", 2}, {"z2", 2}}), sum);
    EXPECT_EQ(in_energy(n, {{"z3", 2}, {"z4", 2}}), sum);
    EXPECT_EQ(in_energy(n, {{"z1", 2}, {"z4", 2}}), turn);
    EXPECT_EQ(in_energy(n, {{"z2", 2}, {"z3", 2}}), turn);
    EXPECT_EQ(in_energy(n, {{"z1", 1}, {"z2", 1}, {"z3", 1}, {"z4", 1}}), 2 * sum - 2 * turn);
}

// --- the same invariants from both styles -------------------------------------------------------------

// H along the map of a normal form.
Series energy_along(const Normalization& n) {
    const GradedField& field = *n.normal_form.field;
    SeriesRun run(*field.program);
    Series energy;
    for (int k = 0; k <= n.map.through + 1; ++k) {
        for (std::size_t m = 0; m < field.modes.size(); ++m) {
            const Mode& mode = field.modes[m];
            Polynomial z = n.map.mode[m].part(k);
            if (k == 1) z = z + field.ring->gen(mode.z);
            run.set_input(mode.input_conjugate, k, field.ring->conjugate(z));
            run.set_input(mode.input, k, std::move(z));
        }
        run.advance(k);
        energy.set(k, run.part(field.energy, k));
    }
    return energy;
}

// Frequency as a function of the energy on an invariant plane w3 = i^c w1, from any normal form.
RationalSeries frequency_by_energy(const Normalization& n, int c, int pairs) {
    const OnPlane on_plane(*n.normal_form.field->ring, c);
    const RationalSeries energy = on_plane(energy_along(n), 0, pairs); // of a = w1 wbar1
    const RationalSeries frequency = on_plane(n.normal_form.mode[0], 1, pairs - 1);
    // f(E(a)) = frequency(a), solved order by order
    RationalSeries f(pairs - 1);
    for (int k = 0; k < pairs; ++k) {
        RationalSeries cut(pairs - 1);
        for (int j = 0; j < pairs; ++j) cut[j] = energy[j];
        const Rational missing = frequency[k] - RationalSeries::composed(f, cut)[k];
        f[k] = missing / power(energy[1], k);
    }
    return f;
}

TEST(LiteratureHamiltonian, AgreesWithTheStylePoincare) {
    struct Orbit {
        std::string toml;
        int c;
    };
    // of Henon and Heiles: the circular orbits w3 = +- i w1
    const std::array<Orbit, 4> orbits{{{test::one_degree("px^2/2 + x^2/2 + x^3/3 + x^4/5"), 0},
                                       {test::one_degree("px^2/2 + 1 - cos(x) + x*px^2"), 0},
                                       {test::henon_heiles(), 1},
                                       {test::henon_heiles(), -1}}};
    constexpr int pairs = 3;
    for (const Orbit& orbit : orbits) {
        const auto field = test::field_from(orbit.toml);
        const Normalization canonical = normalize_hamiltonian(field, 2 * pairs - 1);
        const Normalization poincare = normalize_poincare(field, 2 * pairs - 1);
        const RationalSeries f = frequency_by_energy(canonical, orbit.c, pairs);
        EXPECT_TRUE(f == frequency_by_energy(poincare, orbit.c, pairs)) << orbit.toml;
        EXPECT_EQ(f[0], 1);
        EXPECT_NE(f[1], 0);
    }
}

// --- two frequencies ----------------------------------------------------------------------------------

std::string swing(int w1, int w2) {
    return test::two_degrees("px^2/2 + py^2/2 + " + std::to_string(w1 * w1) + "*x^2/2 + " +
                             std::to_string(w2 * w2) + "*y^2/2 + x^2*y");
}

// H = ... + x^2 y by von Zeipel's second order, -1/4 sum_k k.d/dI (A_k^2/(k.omega)) over the harmonics of
// x^2 y = I1/w1 (2 I2/w2)^(1/2) (cos b + cos(2a + b)/2 + cos(2a - b)/2):
//   K4 = -I1^2/(2 w1^2 w2^2) - (I1^2 + 4 I1 I2)/(8 w1^2 w2 (2 w1 + w2)) + (I1^2 - 4 I1 I2)/(8 w1^2 w2 (2 w1 -
//   w2))
TEST(LiteratureHamiltonian, TwoFrequenciesBySecondOrderAveraging) {
    const std::array<std::pair<int, int>, 3> frequencies{{{1, 3}, {3, 1}, {2, 5}}};
    for (const auto& [w1, w2] : frequencies) {
        const Normalization n = certified(swing(w1, w2), 3);
        const Rational r1 = w1, r2 = w2;
        const Rational d0 = 1 / (r1 * r1 * r2 * r2), plus = 1 / (8 * r1 * r1 * r2 * (2 * r1 + r2)),
                       minus = 1 / (8 * r1 * r1 * r2 * (2 * r1 - r2));
        // z1 z2 = 2/w1 I1, z3 z4 = 2/w2 I2
        EXPECT_EQ(in_energy(n, {{"z1", 2}, {"z2", 2}}) * power(2 / r1, 2), -d0 / 2 - plus + minus);
        EXPECT_EQ(in_energy(n, {{"z1", 1}, {"z2", 1}, {"z3", 1}, {"z4", 1}}) * 4 / (r1 * r2),
                  -4 * plus - 4 * minus);
    }
}

// At w2 = 2 w1 the harmonic 2a - b stays: x^2 y -> (z1^2 z4 + z2^2 z3)/8.
TEST(LiteratureHamiltonian, OneToTwoResonance) {
    const Normalization n = certified(swing(1, 2), 4);
    EXPECT_EQ(in_energy(n, {{"z1", 2}, {"z4", 1}}), Rational(1) / 8);
    EXPECT_EQ(in_energy(n, {{"z2", 2}, {"z3", 1}}), Rational(1) / 8);
}

} // namespace
} // namespace resonform
