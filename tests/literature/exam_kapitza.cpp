// SPDX-License-Identifier: GPL-3.0-or-later
// Kapitza's pendulum near its two positions of rest against the characteristic exponent nu of Mathieu's
// equation u'' + (a - 2 h cos 2z) u = 0 (Digital Library of Mathematical Functions, 28.15.1),
//   a = nu^2 + h^2/(2 (nu^2 - 1)) + h^4 (5 nu^2 + 7)/(32 (nu^2 - 1)^3 (nu^2 - 4))
//     + h^6 (9 nu^4 + 58 nu^2 + 29)/(64 (nu^2 - 1)^5 (nu^2 - 4)(nu^2 - 9)) + O(h^8),
// with a = 4 eps^2 cos(theta), h = 2 eps q, nu = 2 eps Omega.
#include "literature/point_in_doubles.hpp"
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

double mathieu(double nu2, double h) {
    const double h2 = h * h, one = nu2 - 1, four = nu2 - 4;
    return nu2 + h2 / (2 * one) + h2 * h2 * (5 * nu2 + 7) / (32 * std::pow(one, 3) * four) +
           h2 * h2 * h2 * (9 * nu2 * nu2 + 58 * nu2 + 29) / (64 * std::pow(one, 5) * four * (nu2 - 9));
}

class KapitzaPendulum : public testing::TestWithParam<int> {}; // cos(theta)

TEST_P(KapitzaPendulum, SwaysAsMathieusEquationSays) {
    constexpr double q = 1.7;
    const Normalization n = test::certified(test::field_named("kapitza_pendulum"), 5);
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    const test::PointInDoubles at(ring,
                                  {{"q", q}, {"theta", GetParam() > 0 ? 0 : std::acos(-1.0)}, {"p", 0}});
    const auto slope = [&](std::size_t rate, const char* by, double eps) {
        double sum = 0;
        for (int k = 1; k <= 5; ++k)
            sum += std::pow(eps, k) *
                   at(ring.derivative(test::coefficient_of(field, n.normal_form.slow[rate], {{"eps", k}}),
                                      *ring.find(by)))
                       .real();
        return sum;
    };
    const auto miss = [&](double eps) {
        const double square = -slope(0, "p", eps) * slope(1, "theta", eps); // (eps Omega)^2
        EXPECT_NEAR(slope(0, "theta", eps), 0, 1e-14);
        EXPECT_NEAR(slope(1, "p", eps), 0, 1e-14);
        return mathieu(4 * square, 2 * eps * q) / (4 * eps * eps) - GetParam();
    };
    // Omega^2 is known through eps^4
    EXPECT_LT(std::abs(miss(0.01)), 1e-8);
    EXPECT_NEAR(std::log2(miss(0.02) / miss(0.01)), 6, 0.2);
}

INSTANTIATE_TEST_SUITE_P(BelowAndAbove, KapitzaPendulum, testing::Values(1, -1));

} // namespace
} // namespace resonform
