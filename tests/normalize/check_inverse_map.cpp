// SPDX-License-Identifier: GPL-3.0-or-later
// Map o inverse = inverse o map = identity through M, and composition against known expansions.
#include "normalize/inverse_map.hpp"

#include "normalize/certified.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::monomial;

// first + second(first) = 0 weight by weight, where `first` shifts the modes.
void expect_opposite(const GradedField& field, const std::vector<Series>& first,
                     const std::vector<Series>& second, const std::vector<Series>& shift, int through) {
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        const Series composed = compose(field, second[k], shift, through);
        for (int n = 0; n <= through; ++n)
            EXPECT_TRUE((first[k].part(n) + composed.part(n)).empty()) << k << ", weight " << n;
    }
}

void expect_inverse(const std::shared_ptr<const GradedField>& field, int through) {
    const Normalization n = normalize_poincare(field, through);
    const NearIdentityMap inverse = invert(n.normal_form, n.map);
    EXPECT_EQ(inverse.through, through);
    // w = z + g, z = w + h(w):  g + h(z + g) = 0;  the drift: m + l(z + g) = 0
    expect_opposite(*field, inverse.mode, n.map.mode, inverse.mode, through);
    expect_opposite(*field, inverse.drift, n.map.drift, inverse.mode, through);
    // and the other way round: h + g(w + h) = 0;  l + m(w + h) = 0
    expect_opposite(*field, n.map.mode, inverse.mode, n.map.mode, through);
    expect_opposite(*field, n.map.drift, inverse.drift, n.map.mode, through);
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
    Series shift;
    shift.set(2, ring.multiply(i, ring.multiply(z, z)));
    // z^2 zbar at z + i z^2, zbar - i zbar^2, through weight 5
    const Series composed =
        compose(*field, Series::split(ring, monomial(ring, {{"z1", 2}, {"z2", 1}}), 3), {shift}, 5);
    const Polynomial new_z = z + shift.part(2), new_zbar = zbar - ring.multiply(i, ring.multiply(zbar, zbar));
    const Polynomial expected = ring.multiply(ring.multiply(new_z, new_z), new_zbar);
    const std::vector<Polynomial> parts = ring.by_weight(expected, 5);
    for (int n = 0; n <= 5; ++n) EXPECT_EQ(composed.part(n), parts[static_cast<std::size_t>(n)]) << n;
}

} // namespace
} // namespace resonform
