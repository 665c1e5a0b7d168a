// SPDX-License-Identifier: GPL-3.0-or-later
// The Duffing frequency as a function of the amplitude of x, an invariant of the normal form:
//   omega(A) = 1 + 3/8 A^2 - 21/256 A^4 + 81/2048 A^6 + O(A^8)
// (from the elliptic integral; Nayfeh and Mook, Nonlinear Oscillations, section 2.3, to A^4).
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

constexpr int through = 7;

// sum of c_k rho^k, cut at rho^through
using Expansion = std::vector<Rational>;

Expansion multiply(const Expansion& a, const Expansion& b) {
    Expansion c(through + 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size() && i + j <= through; ++j) c[i + j] = c[i + j] + a[i] * b[j];
    return c;
}

// A series at w = wbar = rho, each coefficient divided by i^divide_by_i.
Expansion on_the_axis(const Ring& ring, const Series& series, int divide_by_i) {
    Expansion c(through + 1, 0);
    for (int n = 0; n <= std::min(through, series.through()); ++n)
        for (const Term& t : series.part(n).terms()) {
            EXPECT_EQ(ring.exponent(t.monomial, Ring::imaginary_unit), divide_by_i);
            c[static_cast<std::size_t>(n)] = c[static_cast<std::size_t>(n)] + t.coefficient;
        }
    return c;
}

} // namespace

TEST(Duffing, FrequencyAsAFunctionOfTheAmplitude) {
    const auto field = test::field_from(test::system_text("duffing", {{"x", "fast", "x'' + x + x^3 = 0"}}));
    const Normalization n = normalize_poincare(field, through);
    Expansion rate = on_the_axis(*field->ring, n.normal_form.mode[0], 1); // rho omega(rho)
    Expansion amplitude = on_the_axis(*field->ring, n.map.mode[0], 0);    // x at theta = 0
    amplitude[1] = amplitude[1] + 1;

    const std::vector<Rational> known = {1, Rational(3) / 8, Rational(-21) / 256, Rational(81) / 2048};
    Expansion expected(through + 1, 0), power(through + 1, 0);
    power[1] = 1; // rho, then rho A^2, rho A^4, ...
    for (const Rational& c : known) {
        for (std::size_t k = 0; k <= through; ++k) expected[k] = expected[k] + c * power[k];
        power = multiply(multiply(power, amplitude), amplitude);
    }
    EXPECT_EQ(rate, expected);
}

} // namespace resonform
