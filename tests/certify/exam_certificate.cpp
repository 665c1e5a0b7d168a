// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate on normal forms that were found by hand, on the pendulum, and on what it must refuse.
#include "certify/points/reader.hpp"
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace resonform {
namespace {

using test::monomial;

// x'' + x + x^3 = 0 with z = x - i x' is z' = i z + (i/8)(z + zbar)^3; dividing by <alpha, lambda> - i,
// h = z^3/16 - 3 z zbar^2/16 - zbar^3/32 and N = i w + (3/8) i w^2 wbar.
Normalization duffing_by_hand() {
    Normalization n;
    n.normal_form.field = test::duffing();
    n.normal_form.through = n.map.through = 3;
    const Ring& ring = *n.normal_form.field->ring;
    n.normal_form.mode.resize(1);
    n.normal_form.mode[0].set(1, ring.multiply(ring.imaginary(), monomial(ring, {{"z1", 1}})));
    n.normal_form.mode[0].set(3, Rational(3) / 8 *
                                     ring.multiply(ring.imaginary(), monomial(ring, {{"z1", 2}, {"z2", 1}})));
    n.map.mode.resize(1);
    n.map.mode[0].set(3, Rational(1) / 16 * monomial(ring, {{"z1", 3}}) -
                             Rational(3) / 16 * monomial(ring, {{"z1", 1}, {"z2", 2}}) -
                             Rational(1) / 32 * monomial(ring, {{"z2", 3}}));
    return n;
}

TEST(Certificate, HoldsForDuffingByHand) {
    const Certificate c = test::certificate_of(duffing_by_hand());
    EXPECT_TRUE(c.holds) << c.complaint;
    EXPECT_TRUE(c.residual_zero);
    EXPECT_TRUE(c.normal_form_scan);
    EXPECT_EQ(c.through_weight, 3);
    EXPECT_EQ(c.complaint, "");
    EXPECT_GE(c.points, 2);
    EXPECT_EQ(c.primes.size(), static_cast<std::size_t>(c.points));
    EXPECT_GT(c.error_probability, 0);
    EXPECT_LE(c.error_probability, 1e-30);
}

TEST(Certificate, ComplaintsSayWhatIsWrong) {
    const Normalization good = duffing_by_hand();
    const Ring& ring = *good.normal_form.field->ring;

    Normalization wrong = good;
    wrong.map.mode[0].set(3, 2 * good.map.mode[0].part(3));
    EXPECT_EQ(test::certificate_of(wrong).complaint, "weight 3: d/dt of x along the normal form is not x'");

    wrong = good;
    wrong.normal_form.mode[0].set(1, 2 * good.normal_form.mode[0].part(1));
    EXPECT_EQ(test::certificate_of(wrong).complaint, "weight 1: the linear part of z1' is not lambda*z1");

    wrong = good;
    wrong.map.mode[0].set(3, good.map.mode[0].part(3) + monomial(ring, {{"z1", 2}, {"z2", 1}}));
    EXPECT_EQ(test::certificate_of(wrong).complaint, "map of z1, weight 3: z1^2*z2 is resonant");

    wrong = good;
    wrong.map.mode[0].set(2, monomial(ring, {{"z1", 3}}));
    EXPECT_EQ(test::certificate_of(wrong).complaint, "map of z1, weight 2: z1^3 has another weight");

    wrong = good;
    wrong.map.mode[0].set(4, monomial(ring, {{"z1", 4}}));
    EXPECT_EQ(test::certificate_of(wrong).complaint,
              "map of z1, weight 4: z1^4 stands outside the weights of the series");

    wrong = good;
    wrong.map.through = 2;
    EXPECT_EQ(test::certificate_of(wrong).complaint,
              "the normal form goes through weight 3, the map through 2");

    wrong = good;
    wrong.map.mode.clear();
    EXPECT_EQ(test::certificate_of(wrong).complaint,
              "normal form and map do not have one series for each variable");
}

TEST(Certificate, HoldsForThePendulumThroughEveryWeight) {
    const auto field = test::pendulum();
    for (int through = 1; through <= 7; ++through) {
        const Normalization n = normalize_poincare(field, through);
        const Certificate c = test::certificate_of(n);
        EXPECT_TRUE(c.holds) << through << ": " << c.complaint;
        EXPECT_EQ(c.through_weight, through);
        EXPECT_LE(c.error_probability, 1e-30) << through;
    }
}

TEST(Certificate, IsReproducible) {
    const Normalization n = normalize_poincare(test::pendulum(), 3);
    const Certificate a = test::certificate_of(n), b = test::certificate_of(n);
    EXPECT_EQ(a.primes, b.primes);
    EXPECT_EQ(a.error_probability, b.error_probability);
    EXPECT_NE(a.primes, test::certificate_of(n, 2).primes);
}

// h = 0 and N = F passes the substitution and is no normal form.
TEST(Certificate, TheFieldItselfPassesTheSubstitutionOnly) {
    const auto field = test::pendulum();
    Normalization n = normalize_poincare(field, 4);
    const FieldSeries f = evaluate_field(*field, 4);
    const Polynomial linear = n.normal_form.mode[0].part(1);
    n.normal_form.mode = f.mode;
    n.normal_form.mode[0].set(1, f.mode[0].part(1) + linear);
    n.normal_form.drift = f.drift;
    n.map.mode.assign(1, Series());
    n.map.drift.assign(2, Series());
    const Certificate c = test::certificate_of(n);
    EXPECT_TRUE(c.residual_zero);
    EXPECT_FALSE(c.normal_form_scan);
    EXPECT_FALSE(c.holds);
    EXPECT_EQ(c.complaint, "normal form of z1, weight 2: z2*eps is not resonant");
}

// Weights that the equation loses are noticed: eps times an equation says less.
TEST(Certificate, RefusesEquationsThatAreDegenerateAtTheOrigin) {
    Normalization n = duffing_by_hand();
    auto first_order = *n.normal_form.field->first_order;
    auto system = std::make_shared<System>(n.normal_form.field->system());
    system->equations[0].residual = system->eps * system->equations[0].residual;
    first_order.system = system;
    auto field = std::make_shared<GradedField>(*n.normal_form.field);
    field->first_order = std::make_shared<FirstOrderSystem>(first_order);
    n.normal_form.field = field;
    const Error e = test::error_when([&] { test::certificate_of(n); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_EQ(e.diagnostic().rule, "at the origin no denominator of the equations vanishes and their "
                                   "highest derivatives are determined");
}

TEST(Certificate, OfFunctionsInsideOfFunctionsNamesTheNesting) {
    std::string nested = "x";
    for (int k = 0; k < 10; ++k) nested = "exp(sin(" + nested + ")) - 1";
    const Normalization n =
        normalize(test::field_from(test::oscillator_file("x'' + x = (" + nested + ")^2")), 3);
    const Error e = test::error_when([&] { test::certificate_of(n); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    EXPECT_NE(e.diagnostic().hint.find("inside of one another"), std::string::npos);
    EXPECT_FALSE(e.diagnostic().place.file.empty());
}

TEST(Certificate, StyleHamiltonianNeedsAnEnergy) {
    Normalization n = duffing_by_hand();
    n.normal_form.style = Style::hamiltonian;
    const Certificate c = test::certificate_of(n);
    EXPECT_FALSE(c.holds);
    EXPECT_EQ(c.complaint, "energy and generator go with the style hamiltonian");
}

// Roots that depend on each other would split the variety of points: a factor may vanish on one part.
TEST(PointSampler, RefusesDependentRoots) {
    RingBuilder builder;
    Generator a;
    a.kind = GeneratorKind::parameter;
    a.name = "a";
    a.positive = a.invertible = true;
    const GeneratorId id = builder.add(a);
    Generator root;
    root.kind = GeneratorKind::root;
    root.positive = root.invertible = true;
    root.index = 2;
    root.name = "first";
    root.radicand = builder.gen(id);
    builder.add(root);
    const RingPtr independent = builder.freeze();
    root.name = "second";
    root.radicand = Rational(4) * builder.gen(id);
    builder.add(root);
    const RingPtr dependent = builder.freeze();

    PointSampler good(*independent, 1);
    EXPECT_EQ(good.dependent_root(), std::nullopt);
    PointSampler bad(*dependent, 1);
    EXPECT_EQ(bad.dependent_root(), dependent->find("second"));
}

TEST(PointSampler, PointsSatisfyTheRelations) {
    const auto field = test::pendulum();
    const Ring& ring = *field->ring;
    PointSampler sampler(ring, 5);
    for (int n = 0; n < 20; ++n) {
        const Point point = sampler.next();
        const Montgomery montgomery(point.field);
        PointReader reader(ring, {&point, 1});
        const auto at = [&](const Polynomial& p) {
            Residue sum = 0;
            for (const Residue term : reader.terms(p.fractions())) sum = montgomery.add(sum, term);
            return montgomery.leave(sum);
        };
        EXPECT_EQ(point.field.multiply(point.values[0], point.values[0]), point.field.prime() - 1);
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const Generator& g = ring.generator(id);
            if (g.kind != GeneratorKind::root) continue;
            EXPECT_EQ(point.field.power(point.values[static_cast<std::size_t>(id)], g.index), at(g.radicand));
        }
    }
}

} // namespace
} // namespace resonform
