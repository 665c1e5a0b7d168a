// SPDX-License-Identifier: GPL-3.0-or-later
// What certificates read of the pendulum's series: values at points, and what one pass over monomials tells.
#include "certify/build_plan.hpp"
#include "certify/points/point.hpp"
#include "certify/points/survey.hpp"
#include "normalize/certified.hpp"
#include "normalize/recursion/poincare.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

using test::monomial;

std::size_t terms_of(const Normalization& n) {
    std::size_t terms = 0;
    for (const auto* group : {&n.map.mode, &n.map.drift, &n.normal_form.drift})
        for (const Series& s : *group)
            for (int weight = 0; weight <= s.through(); ++weight) terms += s.part(weight).size();
    return terms;
}

// Many points are shared out between threads, one is not.
TEST(PointReadings, PointsReadTogetherOrAloneAgree) {
    const auto field = test::pendulum();
    constexpr int order = 19;
    const Normalization n = normalize_poincare(field, order);
    ASSERT_GT(4 * terms_of(n), std::size_t{1} << 15);
    const CertificatePlan plan = plan_certificate(*field, nullptr);
    PointSampler sampler(*field->ring, 3);
    std::vector<Point> points;
    while (points.size() < 4) points.push_back(sampler.next());
    const PointReadings all(plan, n.normal_form, n.map, points, order);
    std::size_t nonzero = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const PointReadings one(plan, n.normal_form, n.map, {points[k]}, order);
        ASSERT_EQ(one.coefficients().size(), all.coefficients().size());
        for (std::size_t c = 0; c < one.coefficients().size(); ++c) {
            EXPECT_EQ(one.coefficients()[c].slot, all.coefficients()[c].slot);
            EXPECT_EQ(one.coefficients()[c].weight, all.coefficients()[c].weight);
            EXPECT_EQ(one.coefficients()[c].value[0], all.coefficients()[c].value[k]);
            nonzero += one.coefficients()[c].value[0] != 0 ? 1 : 0;
        }
    }
    EXPECT_GT(nonzero, 100U);
}

// Whatever word of a monomial its first generator stands in.
TEST(PointReader, ReadsEachGeneratorAsTheFirst) {
    const auto field = test::pendulum();
    const Ring& ring = *field->ring;
    const Point point = PointSampler(ring, 4).next();
    const Montgomery montgomery(point.field);
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Polynomial generator = Polynomial::from_terms({{ring.monomial(id), 1}});
        PointReader reader(ring, {&point, 1});
        const std::vector<Residue> terms = reader.terms(generator.fractions());
        ASSERT_EQ(terms.size(), 1U);
        EXPECT_EQ(montgomery.leave(terms[0]), point.values[static_cast<std::size_t>(id)])
            << ring.generator(id).name;
    }
}

// Series that agree in their first words are told apart all the same.
TEST(Survey, OfOneSeriesAfterAnother) {
    const auto field = test::pendulum();
    const Ring& ring = *field->ring;
    Surveyor surveys(ring);
    const auto z1 = static_cast<std::size_t>(*ring.find("z1"));
    std::vector<Series> all; // each is known by its place
    for (const char* parameter : {"r", "v", "xi"})
        all.push_back(Series({Polynomial{}, Polynomial{}, monomial(ring, {{"z1", 2}, {parameter, 1}})}));
    for (const Series& series : all) {
        const Survey survey = Surveyor(ring)(series), again = surveys(series);
        EXPECT_EQ(again.exponents[z1].highest, 2);
        EXPECT_EQ(again.size.degree, survey.size.degree);
        EXPECT_TRUE(again.homogeneous);
    }
}

// 3/4 z1^2/r - 5/6 z1 z2 xi, then 7 eps z1^3
TEST(Survey, TellsExponentsWeightsAndSize) {
    const auto field = test::pendulum();
    const Ring& ring = *field->ring;
    Surveyor surveys(ring);
    const Series good({Polynomial{}, Polynomial{},
                       Rational(3) / 4 * monomial(ring, {{"z1", 2}, {"r", -1}}) -
                           Rational(5) / 6 * monomial(ring, {{"z1", 1}, {"z2", 1}, {"xi", 1}}),
                       Polynomial{}, Rational(7) * monomial(ring, {{"eps", 1}, {"z1", 3}})});
    const Survey& survey = surveys(good);
    EXPECT_EQ(survey.first, 2);
    EXPECT_EQ(survey.last, 4);
    EXPECT_TRUE(survey.homogeneous);
    const auto range = [&](const char* name) {
        const auto k = static_cast<std::size_t>(*ring.find(name));
        return std::pair(survey.exponents[k].lowest, survey.exponents[k].highest);
    };
    EXPECT_EQ(range("z1"), std::pair(0, 3));
    EXPECT_EQ(range("r"), std::pair(-1, 0));
    EXPECT_EQ(range("v"), std::pair(0, 0));
    EXPECT_EQ(survey.exponent(*ring.find("r")), 1);
    // Times 12 r: 9 z1^2, -10 r xi z1 z2, 84 r eps z1^3.
    EXPECT_EQ(survey.size.denominator, 1);
    EXPECT_EQ(survey.size.degree, 5);
    EXPECT_GE(survey.size.bits, std::log2(9 + 10 + 84));
    EXPECT_LE(survey.size.bits, std::log2(9 + 10 + 84) + 8);

    const Series heavy({Polynomial{}, monomial(ring, {{"z1", 2}})});
    EXPECT_FALSE(surveys(heavy).homogeneous);
    EXPECT_TRUE(surveys(Series(std::vector<Polynomial>(3))).is_empty());
}

} // namespace
} // namespace resonform
