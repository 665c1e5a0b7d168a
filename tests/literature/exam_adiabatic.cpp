// SPDX-License-Identifier: GPL-3.0-or-later
// psi'' + omega(tau)^2 psi = 0, tau' = eps, with omega known by its name only, against the expansion of
// Wentzel, Kramers and Brillouin: psi = W^(-1/2) cos(integral of W/eps),
//   W^2 = omega^2 - eps^2 (W''/(2 W) - 3 W'^2/(4 W^2))       (Bender and Orszag, chapter 10; ' = d/dtau)
// The normal form has the phase of w instead of that of psi. What is invariant is the phase up to derivatives
// of functions of omega, omega', ...: the variational derivative, sum over k of (-d/dtau)^k d/domega^(k), of
// the difference vanishes. That of the growth vanishes as well: omega |w|^2 (1 + ...) is conserved to all
// orders.
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace resonform {
namespace {

constexpr int highest_order = 5;
constexpr int derivatives = 12;

class AdiabaticOscillator : public ::testing::Test {
protected:
    [[nodiscard]] const Ring& ring() const { return *n_.normal_form.field->ring; }
    [[nodiscard]] GeneratorId omega(int k) const {
        return ring().find("omega" + std::string(static_cast<std::size_t>(k), '\'') + "(tau)").value();
    }
    [[nodiscard]] Polynomial rate(const Polynomial& p) const {
        return ring().derivative(p, *ring().find("tau"));
    }
    [[nodiscard]] Polynomial product(const std::vector<Polynomial>& factors) const {
        Polynomial result = ring().one();
        for (const Polynomial& f : factors) result = ring().multiply(result, f);
        return result;
    }
    // The coefficient of eps^k w in w'/w.
    [[nodiscard]] Polynomial coefficient(int k) const {
        return test::coefficient_of(*n_.normal_form.field, n_.normal_form.mode[0], {{"z1", 1}, {"eps", k}});
    }
    [[nodiscard]] Polynomial variation(const Polynomial& p) const {
        Polynomial sum;
        for (int k = 0; k <= highest_order; ++k) {
            std::vector<Term> terms;
            for (const Term& t : p.terms())
                terms.push_back({t.monomial - ring().monomial(omega(k)),
                                 t.coefficient * Rational(ring().exponent(t.monomial, omega(k)))});
            Polynomial slope = Polynomial::from_terms(std::move(terms));
            for (int j = 0; j < k; ++j) slope = -rate(slope);
            sum = sum + slope;
        }
        return sum;
    }

    Normalization n_ = normalize_poincare(
        with_derivatives(test::field_named("adiabatic_oscillator"), derivatives), highest_order);
};

TEST_F(AdiabaticOscillator, IsCertified) {
    const Certificate c = test::certificate_of(n_);
    EXPECT_TRUE(c.holds) << c.complaint;
}

TEST_F(AdiabaticOscillator, HasThePhaseOfWentzelKramersAndBrillouin) {
    const Polynomial w = ring().gen(omega(0)), below = ring().gen(omega(0), -1);
    const Polynomial w1 = ring().gen(omega(1)), w2 = ring().gen(omega(2));
    // S = W''/(2 W) - 3 W'^2/(4 W^2): at W = omega, and its part that is linear in v, of W = omega + v
    const Polynomial s =
        product({Rational(1) / 2 * w2, below}) - Rational(3) / 4 * product({w1, w1, below, below});
    const Polynomial second = Rational(-1) / 2 * product({s, below});
    const auto linear = [&](const Polynomial& v) {
        const Polynomial v1 = rate(v), v2 = rate(v1);
        return Rational(1) / 2 * (product({v2, below}) - product({w2, v, below, below})) -
               Rational(3) / 2 *
                   (product({w1, v1, below, below}) - product({w1, w1, v, below, below, below}));
    };
    const Polynomial fourth = Rational(-1) / 2 * product({linear(second) + product({second, second}), below});
    const Polynomial i = ring().imaginary();
    EXPECT_EQ(coefficient(0), product({i, w}));
    for (const auto& [k, expected] : {std::pair(2, second), std::pair(4, fourth)}) {
        const Polynomial found = -product({i, coefficient(k)});
        EXPECT_EQ(ring().conjugate(found), found) << k;
        EXPECT_TRUE(variation(found - expected).empty()) << k;
        EXPECT_FALSE(variation(found).empty()) << k;
    }
}

TEST_F(AdiabaticOscillator, ConservesItsAction) {
    EXPECT_EQ(coefficient(1), Rational(-1) / 2 * product({ring().gen(omega(1)), ring().gen(omega(0), -1)}));
    for (const int k : {1, 3}) {
        const Polynomial growth = coefficient(k);
        EXPECT_FALSE(growth.empty()) << k;
        EXPECT_EQ(ring().conjugate(growth), growth) << k;
        EXPECT_TRUE(variation(growth).empty()) << k;
    }
}

} // namespace
} // namespace resonform
