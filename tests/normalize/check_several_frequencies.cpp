// SPDX-License-Identifier: GPL-3.0-or-later
// Several oscillators: symbolic frequencies, exact resonances, and invariants that are known.
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using test::certificate_of;
using test::coefficient;
using test::field_from;

std::string two_oscillators(const std::string& x, const std::string& y, const std::string& parameters) {
    return "[system]\nname = \"two\"\n\n[parameters]\n" + parameters +
           "\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n\n[equations]\nx = \"" + x +
           "\"\ny = \"" + y + "\"\n";
}

// The spring pendulum's cubic coupling, V = a x^2 y, with frequencies that are independent symbols.
std::shared_ptr<const GradedField> coupled() {
    return field_from(two_oscillators("x'' + w1^2*x + 2*a*x*y = 0", "y'' + w2^2*y + a*x^2 = 0",
                                      "w1 = { positive = true }\nw2 = { positive = true }\na = {}\n"));
}

Polynomial of(const Normalization& n, std::size_t mode,
              const std::vector<std::pair<std::string, int>>& powers) {
    return test::coefficient_of(*n.normal_form.field, n.normal_form.mode[mode], powers);
}

TEST(SeveralFrequencies, RingLearnsToDivideAsDivisorsTurnUp) {
    const auto field = coupled();
    const Normalization n = normalize_poincare(field, 3);
    EXPECT_GT(n.normal_form.field->ring->size(), field->ring->size());
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    for (const DivisorRecord& record : n.divisors) EXPECT_NE(record.verdict, DivisorVerdict::ambiguous);
    // Below weight 2 nothing is divided by: the field is as it was given.
    EXPECT_EQ(normalize_poincare(field, 1).normal_form.field, field);
}

// The frequency shift of x by the amplitude of y, by second-order averaging done by hand:
// x'' + (w1^2 + 2 a y) x = 0 with y = b cos(w2 t): Mathieu far from its tongues, together with what x
// excites in y. From the averaged Hamiltonian of V = a x^2 y (z = q - i p/w):
//   z1' = ... - i a^2 / (w1 (4 w1^2 - w2^2)) z1 z3 z4,  z3' = ... - i a^2 / (w2 (4 w1^2 - w2^2)) z1 z2 z3
TEST(SeveralFrequencies, ShiftEachOther) {
    const Normalization n = normalize_poincare(coupled(), 3);
    const Ring& ring = *n.normal_form.field->ring;
    const auto times_denominator = [&](const Polynomial& p, const std::string& text) {
        return ring.multiply(p, coefficient(*n.normal_form.field, text));
    };
    const Polynomial expected = -coefficient(*n.normal_form.field, "a^2", true);
    EXPECT_TRUE(ring.vanishes(
        times_denominator(of(n, 0, {{"z1", 1}, {"z3", 1}, {"z4", 1}}), "w1*(4*w1^2 - w2^2)") - expected));
    EXPECT_TRUE(ring.vanishes(
        times_denominator(of(n, 1, {{"z3", 1}, {"z1", 1}, {"z2", 1}}), "w2*(4*w1^2 - w2^2)") - expected));
    EXPECT_TRUE(
        ring.vanishes(times_denominator(of(n, 0, {{"z1", 2}, {"z2", 1}}), "4*w1*w2^2*(4*w1^2 - w2^2)") -
                      coefficient(*n.normal_form.field, "-a^2*(8*w1^2 - 3*w2^2)", true)));
}

// What is exact for numbers is exact for symbols: the symbolic result with numbers put in equals the
// result for the numbers.
TEST(SeveralFrequencies, SymbolsAndNumbersAgree) {
    const Normalization symbolic = normalize_poincare(coupled(), 4);
    const Normalization numeric = normalize_poincare(
        field_from(two_oscillators("x'' + 49*x + 6*x*y = 0", "y'' + 9*y + 3*x^2 = 0", "")), 4);
    const Ring& from = *symbolic.normal_form.field->ring;
    std::vector<std::pair<GeneratorId, Polynomial>> values;
    for (GeneratorId id = 0; id < from.size(); ++id) {
        const Generator& g = from.generator(id);
        if (g.name == "w1") values.emplace_back(id, Polynomial(Rational(7)));
        if (g.name == "w2") values.emplace_back(id, Polynomial(Rational(3)));
        if (g.name == "a") values.emplace_back(id, Polynomial(Rational(3)));
    }
    for (GeneratorId id = 0; id < from.size(); ++id) { // the divisors follow
        const Generator& g = from.generator(id);
        if (g.kind != GeneratorKind::root) continue;
        Rational value = 0;
        for (const Term& t : g.radicand.terms()) {
            Rational term = t.coefficient;
            for (GeneratorId k = 0; k < from.size(); ++k) {
                const std::string& name = from.generator(k).name;
                const Rational base = name == "w1" ? 7 : 3;
                term = term * cln::expt(base, Integer(from.exponent(t.monomial, k)));
            }
            value = value + term;
        }
        values.emplace_back(id, Polynomial(value));
    }
    const RingMap put(symbolic.normal_form.field->ring, numeric.normal_form.field->ring, [&] {
        std::vector<Polynomial> images;
        for (GeneratorId id = 0; id < from.size(); ++id) {
            const auto value =
                std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == id; });
            images.push_back(value != values.end()
                                 ? value->second
                                 : numeric.normal_form.field->ring->gen(
                                       *numeric.normal_form.field->ring->find(from.generator(id).name)));
        }
        return images;
    }());
    for (std::size_t k = 0; k < 2; ++k)
        for (int weight = 1; weight <= 4; ++weight) {
            EXPECT_EQ(put(symbolic.normal_form.mode[k].part(weight)),
                      numeric.normal_form.mode[k].part(weight));
            EXPECT_EQ(put(symbolic.map.mode[k].part(weight)), numeric.map.mode[k].part(weight));
        }
}

// Henon and Heiles: V = x^2 y - y^3/3, both frequencies 1. Averaged over the common period, H_4 is
//   -(5/12)(I1 + I2)^2 + (7/12) (2 sqrt(I1 I2) sin(phase))^2   (Gustavson 1966; Braun 1973):
// the square of the energy and of the angular momentum L = x y' - y x'. Here the frequency of the two
// circular orbits and of the straight ones is compared: dH/dE = 1 - (5/6) E + (7/6) L dL/dE.
TEST(SeveralFrequencies, HenonAndHeiles) {
    const Normalization n = normalize_poincare(
        field_from(two_oscillators("x'' + x + 2*x*y = 0", "y'' + y + x^2 - y^2 = 0", "")), 3);
    EXPECT_TRUE(certificate_of(n).holds);
    const Ring& ring = *n.normal_form.field->ring;
    // Straight, x = 0: z1 = 0, E = |z3|^2/2, frequency 1 - (5/6) E = 1 - (5/12) |z3|^2.
    EXPECT_EQ(of(n, 1, {{"z3", 2}, {"z4", 1}}), Rational(-5) / 12 * ring.imaginary());
    // Circular, z1 = w, z3 = i w: E = |w|^2, L^2 = E^2, frequency 1 - (5/6) E + (7/6) E = 1 + |w|^2/3.
    const Polynomial i = ring.imaginary();
    Polynomial sum = of(n, 0, {{"z1", 2}, {"z2", 1}});       // w^2 wbar
    sum = sum + of(n, 0, {{"z1", 1}, {"z3", 1}, {"z4", 1}}); // w (i w)(-i wbar)
    sum = sum - of(n, 0, {{"z2", 1}, {"z3", 2}});            // wbar (i w)^2
    EXPECT_EQ(sum, Rational(1) / 3 * i);
}

// Divisors that are numbers up to `near` keep their monomials; one that equals the threshold is kept.
TEST(SeveralFrequencies, NearResonancesAreKeptByTheUsersThreshold) {
    const auto with = [](const std::string& near) {
        std::string text = two_oscillators("x'' + x + 2*x*y = 0", "y'' + 441/100*y + x^2 = 0", "");
        return field_from(text + "[normal_form]\nnear = " + near + "\n");
    };
    const auto verdict = [](const Normalization& n) {
        for (const DivisorRecord& d : n.divisors)
            if (d.variable == "z3" &&
                n.normal_form.field->ring->exponent(d.monomial, n.normal_form.field->modes[0].z) == 2)
                return d.verdict;
        return DivisorVerdict::ambiguous;
    };
    for (const auto& [near, expected] : {std::pair("0.2", DivisorVerdict::kept_near),
                                         {"0.1", DivisorVerdict::kept_near},
                                         {"0.09", DivisorVerdict::removed}}) {
        const Normalization n = normalize_poincare(with(near), 3);
        EXPECT_EQ(verdict(n), expected) << near;
        EXPECT_EQ(of(n, 1, {{"z1", 2}}).empty(), expected == DivisorVerdict::removed);
        EXPECT_TRUE(certificate_of(n).holds) << certificate_of(n).complaint;
    }
    // and a term that the threshold does not allow to stay is found by the scan
    Normalization liar = normalize_poincare(with("0.2"), 3);
    const NormalForm& small = normalize_poincare(with("0.09"), 3).normal_form;
    liar.normal_form.field = small.field;
    EXPECT_FALSE(certificate_of(liar).holds);
}

TEST(SeveralFrequencies, MoreDivisorsThanARingHoldsAreRefused) {
    std::string text =
        "[system]\nname = \"three\"\n\n[parameters]\na = { positive = true }\nb = { positive = true }\n"
        "c = { positive = true }\n\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
        "z = { role = \"fast\" }\n\n[equations]\nx = \"x'' + a^2*x + (x + y + z)^2 = 0\"\n"
        "y = \"y'' + b^2*y + (x + y + z)^2 = 0\"\nz = \"z'' + c^2*z + (x + y + z)^2 = 0\"\n";
    const auto field = field_from(text);
    EXPECT_TRUE(certificate_of(normalize_poincare(field, 2)).holds);
    const Error error = test::error_when([&] { static_cast<void>(normalize_poincare(field, 4)); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("--set"), std::string::npos) << error.what();
}

} // namespace
} // namespace resonform
