// SPDX-License-Identifier: GPL-3.0-or-later
// The normal form of Henon and Heiles through degree 8 on its eight periodic orbits that symmetry keeps at
// every energy (Churchill, Pecelli and Rod, Lect. Notes Phys. 93 (1979) 76: three straight, three curved, two
// circular). Degree 6 is given by them: it is a sum of N^3, N L^2 and Re (w+ wbar-)^3.
//
// With v = y - i x the equations are v'' = -v + vbar^2, and these orbits are v = sum_m v_m e^{i m W t} with
// real v_m: (1 - m^2 W^2) v_m = sum_{j+k=-m} v_j v_k, solved here by itself as Lindstedt did, in powers of
// the amplitude v_1 = A. The normal form has to give the energy as a function of the action:
// K(N) = E, dN = dE/W.
#include "certify/certificate.hpp"
#include "literature/on_plane.hpp"
#include "normalize/hamiltonians.hpp"

#include <gtest/gtest.h>

#include <map>

namespace resonform {
namespace {

using test::RationalSeries;

constexpr int pairs = 4, through = 2 * pairs;

RationalSeries number(const Rational& value) { return RationalSeries(through, value); }

class PeriodicOrbit {
public:
    // v_{-1} = turn A: 1 on the line x = 0, -1 on the curved orbit, 0 on a circular one.
    explicit PeriodicOrbit(int turn) {
        const RationalSeries amplitude = RationalSeries::variable(through);
        for (int m = -through; m <= through; ++m) v_.emplace(m, number(0));
        v_.at(1) = amplitude;
        v_.at(-1) = number(turn) * amplitude;
        for (int round = 0; round < through; ++round) improve();
    }

    // sum of (1 + m^2 W^2) v_m^2/2, minus Re v^3/3 on average
    [[nodiscard]] RationalSeries energy() const {
        RationalSeries e(through);
        for (const auto& [m, v] : v_) {
            e = e + number(Rational(1) / 2) * (number(1) + number(m * m) * square_) * v * v;
            e = e - number(Rational(1) / 3) * v * force(m);
        }
        return e;
    }
    [[nodiscard]] RationalSeries action() const {
        const RationalSeries e = energy(), period = square_.power(Rational(-1) / 2);
        RationalSeries slope(through), n(through);
        for (int k = 1; k <= through; ++k) slope[k - 1] = e[k] * Rational(k);
        slope = slope * period;
        for (int k = 1; k <= through; ++k) n[k] = slope[k - 1] / Rational(k);
        return n;
    }

private:
    // sum_{j+k=-m} v_j v_k
    [[nodiscard]] RationalSeries force(int m) const {
        RationalSeries sum(through);
        for (const auto& [j, v] : v_)
            if (const auto k = v_.find(-m - j); k != v_.end()) sum = sum + v * k->second;
        return sum;
    }
    void improve() {
        const RationalSeries first = force(1);
        for (int k = 0; k < through; ++k) square_[k] = -first[k + 1];
        square_[0] = square_[0] + 1;
        for (auto& [m, v] : v_) {
            if (m * m == 1) continue;
            const Rational lead = 1 - m * m;
            const RationalSeries below = number(1 / lead) * (number(1) - number(m * m) * square_);
            v = number(1 / lead) * force(m) * below.power(-1);
        }
    }

    std::map<int, RationalSeries> v_;
    RationalSeries square_{through, 1}; // W^2
};

class HenonHeiles : public testing::Test {
protected:
    static const Normalization& normalization() {
        static const Normalization n =
            normalize_hamiltonian(test::field_from(test::henon_heiles()), through - 1);
        return n;
    }
    // Of a monomial in K; a rational number.
    static Rational in_energy(const std::vector<std::pair<std::string, int>>& powers) {
        const Ring& ring = *normalization().normal_form.field->ring;
        const Monomial wanted = test::monomial(ring, powers).terms().front().monomial;
        for (const Term& t :
             normalization().normal_form.hamiltonian->energy.part(ring.weight(wanted)).terms())
            if (t.monomial == wanted) return t.coefficient;
        return 0;
    }
    // K of N = z zbar/2, the other mode at rest.
    static RationalSeries on_axis(const std::string& z, const std::string& zbar) {
        RationalSeries k(through);
        for (int n = 1; n <= pairs; ++n) k[n] = in_energy({{z, n}, {zbar, n}}) * Rational(1 << n);
        return k;
    }
    static void expect(const RationalSeries& k, int turn) {
        const PeriodicOrbit orbit(turn);
        EXPECT_TRUE(RationalSeries::composed(k, orbit.action()) == orbit.energy());
    }
};

TEST_F(HenonHeiles, IsCertified) {
    const Certificate c = certify(normalization().normal_form, normalization().map);
    EXPECT_TRUE(c.holds) << c.complaint;
}

// -15/4 g^2 and -705/16 g^4 of the cubic oscillator with g = 1/3
TEST_F(HenonHeiles, OnTheStraightOrbit) {
    const RationalSeries k = on_axis("z3", "z4");
    EXPECT_EQ(k[2], Rational(-5) / 12);
    EXPECT_EQ(k[3], Rational(-235) / 432);
    expect(k, 1);
}

TEST_F(HenonHeiles, OnTheCurvedOrbit) { expect(on_axis("z1", "z2"), -1); }

// w3 = +-i w1, N = w1 wbar1
TEST_F(HenonHeiles, OnTheCircularOrbits) {
    for (const int c : {1, -1}) {
        const test::OnPlane on_plane(*normalization().normal_form.field->ring, c);
        const RationalSeries of_pairs = on_plane(normalization().normal_form.hamiltonian->energy, 0, pairs);
        RationalSeries k(through);
        for (int n = 0; n <= pairs; ++n) k[n] = of_pairs[n];
        EXPECT_EQ(k[2], Rational(1) / 6);
        expect(k, 0);
    }
}

} // namespace
} // namespace resonform
