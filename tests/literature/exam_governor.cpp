// SPDX-License-Identifier: GPL-3.0-or-later
// Watt's governor about its state of rest: the eigenvalues of the normal form against the cubic equation of
// Vyshnegradskii (Pontryagin, Ordinary Differential Equations, section 27),
//   l^3 + b l^2 + w^2 s l + 2 eps s/w = 0,   s = 1 - 1/w^4,   load = 1/w^2.
#include "literature/point_in_doubles.hpp"
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <vector>

namespace resonform {
namespace {

constexpr int highest = 3;
using Value = std::complex<double>;
using Powers = std::vector<Value>; // of eps, through the highest

Powers product(const Powers& a, const Powers& b) {
    Powers c(highest + 1);
    for (std::size_t i = 0; i <= highest; ++i)
        for (std::size_t k = 0; i + k <= highest; ++k) c[i + k] += a[i] * b[k];
    return c;
}

TEST(Literature, WattGovernorAtRestHasTheEquationOfVyshnegradskii) {
    constexpr double w = 1.3, b = 0.7, s = 1 - 1 / (w * w * w * w);
    const Normalization n = test::certified(test::field_named("watt_governor"), highest + 1);
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    const test::PointInDoubles at(ring, {{"b", b}, {"load", 1 / (w * w)}, {"w", w}});
    std::vector<Powers> eigenvalues(2, Powers(highest + 1));
    for (int k = 0; k <= highest; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const Polynomial rate = test::coefficient_of(field, n.normal_form.slow[0], {{"eps", k}});
        eigenvalues[0][i] = at(ring.derivative(rate, *ring.find("w")));
        eigenvalues[1][i] = at(test::coefficient_of(field, n.normal_form.mode[0], {{"z1", 1}, {"eps", k}}));
    }
    EXPECT_NEAR(eigenvalues[0][1].real(), -2 / (w * w * w), 1e-12);
    EXPECT_NEAR(eigenvalues[1][1].real(), 1 / (w * w * w), 1e-12);
    for (const Powers& l : eigenvalues) {
        const Powers square = product(l, l), cube = product(square, l);
        for (std::size_t k = 0; k <= highest; ++k) {
            const Value rest = cube[k] + b * square[k] + w * w * s * l[k] + (k == 1 ? 2 * s / w : 0);
            EXPECT_LT(std::abs(rest), 1e-10 * (1 + std::abs(cube[k]))) << k;
        }
    }
}

} // namespace
} // namespace resonform
