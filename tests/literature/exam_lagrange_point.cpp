// SPDX-License-Identifier: GPL-3.0-or-later
// L4 of the restricted three-body problem against A. Deprit and A. Deprit-Bartholome, Astron. J. 72 (1967):
//
//   H = w1 I1 - w2 I2 + (A I1^2 + 2 B I1 I2 + C I2^2)/2,   w1 > w2
//
// The normal form here has I1 = n1 |z3|^2, I2 = n2 |z1|^2 with positive n1, n2 that depend on the scales of
// the modes. They cancel in A/B and C/B, and these give Deprit's determinant A w2^2 + 2 B w1 w2 + C w1^2.
#include "certify/certificate.hpp"
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

Polynomial cubic_coefficient(const GradedField& field, const Series& series,
                             const std::vector<std::pair<std::string, int>>& powers) {
    const Monomial wanted = test::monomial(*field.ring, powers).terms().front().monomial;
    for (const auto& [key, value] : field.ring->collect(series.part(3), field.outer()))
        if (key == wanted) return value;
    return {};
}

TEST(LagrangePoint, HasDepritsTwist) {
    const Normalization n = normalize_poincare(test::field_named("lagrange_l4"), 3);
    const Certificate certificate = certify(n.normal_form, n.map);
    EXPECT_TRUE(certificate.holds) << certificate.complaint;
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    const Series &low = n.normal_form.mode[0], &high = n.normal_form.mode[1];
    const Polynomial low_low = cubic_coefficient(field, low, {{"z1", 2}, {"z2", 1}});              // -C n2
    const Polynomial low_high = cubic_coefficient(field, low, {{"z1", 1}, {"z3", 1}, {"z4", 1}});  // -B n1
    const Polynomial high_high = cubic_coefficient(field, high, {{"z3", 2}, {"z4", 1}});           // A n1
    const Polynomial high_low = cubic_coefficient(field, high, {{"z1", 1}, {"z2", 1}, {"z3", 1}}); // B n2
    const std::string p = "(243/373)", q = "(130/373)"; // w1^2, w2^2
    const auto diagonal = [](const std::string& own, const std::string& other) {
        return other + "*(81 - 696*" + own + " + 124*" + own + "^2)/(72*(1 - 2*" + own + ")^2*(1 - 5*" + own +
               "))";
    };
    const Polynomial a = test::coefficient(field, diagonal(p, q)),
                     c = test::coefficient(field, diagonal(q, p));
    const Polynomial b =
        test::coefficient(field, "-sqrt" + p + "*sqrt" + q + "*(43 + 64*" + p + "*" + q + ")/(6*(1 - 4*" + p +
                                     "*" + q + ")*(4 - 25*" + p + "*" + q + "))");
    EXPECT_FALSE(low_low.empty() || high_high.empty() || low_high.empty() || high_low.empty());
    EXPECT_TRUE(ring.vanishes(ring.multiply(high_high, b) + ring.multiply(low_high, a)));
    EXPECT_TRUE(ring.vanishes(ring.multiply(low_low, b) + ring.multiply(high_low, c)));
}

} // namespace
} // namespace resonform
