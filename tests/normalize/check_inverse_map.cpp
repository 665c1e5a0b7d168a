// SPDX-License-Identifier: GPL-3.0-or-later
// Map o inverse = inverse o map = identity through M, and composition against known expansions.
#include "normalize/recursion/inverse_map.hpp"

#include "normalize/certified.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::monomial;

// first + second(Y + first) = 0 weight by weight, for every variable.
void expect_opposite(const GradedField& field, const NearIdentityMap& first, const NearIdentityMap& second) {
    const auto check = [&](const char* what, const std::vector<Series>& a, const std::vector<Series>& b) {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            const Series composed = compose(field, b[k], first, first.through);
            for (int n = 0; n <= first.through; ++n)
                EXPECT_TRUE((a[k].part(n) + composed.part(n)).empty())
                    << what << " " << k << ", weight " << n;
        }
    };
    check("mode", first.mode, second.mode);
    check("angle", first.angle, second.angle);
    check("slow", first.slow, second.slow);
    check("drift", first.drift, second.drift);
}

void expect_inverse(const std::shared_ptr<const GradedField>& field, int through) {
    const Normalization n = normalize_poincare(field, through);
    const NearIdentityMap inverse = invert(n.normal_form, n.map);
    EXPECT_EQ(inverse.through, through);
    expect_opposite(*n.normal_form.field, inverse, n.map); // y = Y + g, Y = y + c(y):  g + c(Y + g) = 0
    expect_opposite(*n.normal_form.field, n.map, inverse); // and the other way round: c + g(y + c) = 0
}

TEST(InverseMap, OfDuffing) { expect_inverse(test::duffing(), 9); }

TEST(InverseMap, OfThePendulum) { expect_inverse(test::pendulum(), 6); }

// A drift that feels the mode at weight 1, so that l starts there.
TEST(InverseMap, OfADriftWithAWeightOneMap) {
    expect_inverse(test::field_from(
                       test::oscillator_file("x'' + a*x + eps*x' + x^2 = eps^2", "X = { role = \"drift\" }\n",
                                             "X = \"X' = x + x'*x\"\n", "a = { positive = true }\n")),
                   6);
}

// Damping, a real mode, a slow variable under a root that the oscillation pushes, an angle, forcing.
TEST(InverseMap, OfEveryKindOfVariable) {
    expect_inverse(test::field_from(
                       test::oscillator_file("x'' + sqrt(1 + xi^2)*x + x^2 = eps*y*x",
                                             "y = { role = \"fast\" }\nxi = { role = \"slow\" }\n",
                                             "y = \"y' = -y + x^2\"\nxi = \"xi' = x*x' + x' + eps*x^2\"\n")),
                   4);
    expect_inverse(
        test::field_from(test::oscillator_file(
            "x'' + x + x^2 = eps*cos(p)",
            "J = { role = \"slow\", positive = true }\np = { role = \"angle\" }\nX = { role = \"drift\" }\n",
            "J = \"J' = eps*sin(p) + x^2\"\np = \"p' = 2*J + eps*x\"\nX = \"X' = x*sin(p)\"\n")),
        3);
}

TEST(InverseMap, StartsWithTheOppositeOfTheMap) {
    const Normalization n = normalize_poincare(test::pendulum(), 4);
    const NearIdentityMap inverse = invert(n.normal_form, n.map);
    EXPECT_TRUE(inverse.mode[0].part(0).empty());
    EXPECT_TRUE(inverse.mode[0].part(1).empty());
    EXPECT_EQ(inverse.mode[0].part(2), -n.map.mode[0].part(2));
    EXPECT_FALSE(n.map.mode[0].part(2).empty());
}

TEST(Compose, IsSubstitutionOfModesAndConjugates) {
    const auto field = test::duffing();
    const Ring& ring = *field->ring;
    const Polynomial i = ring.imaginary(), z = ring.gen(field->modes[0].z),
                     zbar = ring.gen(field->modes[0].zbar);
    NearIdentityMap shift;
    shift.mode.resize(1);
    shift.mode[0].set(2, ring.multiply(i, ring.multiply(z, z)));
    // z^2 zbar at z + i z^2, zbar - i zbar^2, through weight 5
    const Series composed =
        compose(*field, Series::split(ring, monomial(ring, {{"z1", 2}, {"z2", 1}}), 3), shift, 5);
    const Polynomial new_z = z + shift.mode[0].part(2),
                     new_zbar = zbar - ring.multiply(i, ring.multiply(zbar, zbar));
    const Polynomial expected = ring.multiply(ring.multiply(new_z, new_z), new_zbar);
    const std::vector<Polynomial> parts = ring.by_weight(expected, 5);
    for (int n = 0; n <= 5; ++n) EXPECT_EQ(composed.part(n), parts[static_cast<std::size_t>(n)]) << n;
}

} // namespace
} // namespace resonform
