// SPDX-License-Identifier: GPL-3.0-or-later
// Centre manifolds against the invariance equation and against the literature.
#include "normalize/certified.hpp"
#include "normalize/recursion/centre_manifold.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

namespace {

constexpr int through = 7;

// Guckenheimer and Holmes, Nonlinear Oscillations, section 3.2: x' = x y, y' = -y + a x^2 has the centre
// manifold y = a x^2 - 2 a^2 x^4 + ...
Normalization guckenheimer_holmes() {
    return normalize_poincare(
        field_from(system_text("test", {{"x", "fast", "x' = x*y"}, {"y", "fast", "y' = -y + a*x^2"}},
                               "[parameters]\na = {}\n")),
        through);
}

Polynomial through_weight(const Ring& ring, const Polynomial& p, int weight) {
    const std::vector<Polynomial> parts = ring.by_weight(p, weight);
    return sum(parts);
}

} // namespace

TEST(CentreManifold, SolvesTheInvarianceEquation) {
    const Normalization n = guckenheimer_holmes();
    const CentreManifold c = centre_manifold(n);
    ASSERT_EQ(c.slaved, (std::vector<bool>{false, true}));
    const Ring& ring = *n.normal_form.field->ring;
    const GeneratorId w = n.normal_form.field->modes[0].z;
    const Polynomial a = ring.gen(*ring.find("a"));
    const Polynomial x = ring.gen(w) + c.manifold.mode[0].total(through),
                     y = c.manifold.mode[1].total(through);
    const Polynomial rate = c.flow.mode[0].total(through);
    const Polynomial of_x = ring.multiply(ring.derivative(x, w), rate) - ring.multiply(x, y);
    const Polynomial of_y =
        ring.multiply(ring.derivative(y, w), rate) + y - ring.multiply(a, ring.multiply(x, x));
    EXPECT_TRUE(through_weight(ring, of_x, through).empty());
    EXPECT_TRUE(through_weight(ring, of_y, through).empty());
    EXPECT_FALSE(rate.empty());
    const Polynomial x2 = ring.multiply(x, x), a2 = ring.multiply(a, a);
    const Polynomial graph =
        y - ring.multiply(a, x2) + Rational(2) * ring.multiply(a2, ring.multiply(x2, x2));
    EXPECT_TRUE(through_weight(ring, graph, 5).empty());
    EXPECT_FALSE(through_weight(ring, graph, 6).empty());
}

// The base point of a point of the manifold is the point itself.
TEST(CentreManifold, FibresStandOnIt) {
    const Normalization n = guckenheimer_holmes();
    const CentreManifold c = centre_manifold(n);
    const GradedField& field = *n.normal_form.field;
    EXPECT_TRUE(c.fibres.mode[1].total(through).empty());
    const Series moved = compose(field, c.fibres.mode[0], c.manifold, through);
    const Polynomial defect = moved.total(through) + c.manifold.mode[0].total(through);
    bool off_it = false;
    for (const Term& t : defect.terms()) {
        EXPECT_NE(field.ring->exponent(t.monomial, field.modes[1].z), 0);
        off_it = true;
    }
    EXPECT_TRUE(off_it); // fibres are not the planes z1 = const
}

TEST(CentreManifold, NeedsModesThatDecayOrGrow) {
    const Normalization n = normalize_poincare(duffing(), 3);
    EXPECT_THROW(centre_manifold(n), Error);
}

// x' = eps x - ... with y kept near zero: the threshold keeps what would have to be removed.
TEST(CentreManifold, IsNotTherePastAThreshold) {
    const Normalization n = normalize_poincare(
        field_from(system_text("test", {{"x", "fast", "x' = x*y"}, {"y", "fast", "y' = -y/100 + x^2"}},
                               "[normal_form]\nnear = \"1/10\"\n")),
        3);
    EXPECT_THROW(centre_manifold(n), Error);
}

} // namespace resonform::test
