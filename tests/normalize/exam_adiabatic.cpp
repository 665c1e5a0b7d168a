// SPDX-License-Identifier: GPL-3.0-or-later
// The oscillator whose frequency is a function of slow time that is known by its name only.
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

std::shared_ptr<const GradedField> adiabatic(const std::string& force) {
    return test::field_from(
        "[system]\nname = \"a\"\n[variables]\npsi = { role = \"fast\" }\n"
        "tau = { role = \"slow\" }\n[functions]\nomega = { of = [\"tau\"], positive = true }\n"
        "[equations]\npsi = \"psi'' + omega(tau)^2*psi" +
        force + " = 0\"\ntau = \"tau' = eps\"\n");
}

Polynomial gen(const Ring& ring, const std::string& name, int exponent = 1) {
    return ring.gen(ring.find(name).value(), exponent);
}

// w' = i omega w - omega'/(2 omega) eps w - i omega'^2/(8 omega^3) eps^2 w + ...: |w|^2 omega is the
// adiabatic invariant. The phase is that of the WKB expansion, 3 omega'^2/(8 omega^3) - omega''/(4 omega^2),
// but for the derivative of -omega'/(4 omega^2), which belongs to the map.
TEST(Adiabatic, InvariantAndPhase) {
    const Normalization n = normalize_poincare(adiabatic(""), 3);
    const Ring& ring = *n.normal_form.field->ring;
    const Polynomial w = gen(ring, "z1"), eps = gen(ring, "eps");
    const Polynomial slope = gen(ring, "omega'(tau)");
    const Polynomial first = ring.multiply(slope, gen(ring, "omega(tau)", -1));
    EXPECT_EQ(n.normal_form.mode[0].part(2), Rational(-1) / 2 * ring.multiply(first, ring.multiply(eps, w)));
    const Polynomial second = ring.multiply(ring.power(slope, 2), gen(ring, "omega(tau)", -3));
    EXPECT_EQ(n.normal_form.mode[0].part(3), Rational(-1) / 8 *
                                                 ring.multiply(ring.multiply(ring.imaginary(), second),
                                                               ring.multiply(ring.power(eps, 2), w)));
}

TEST(Adiabatic, WithACubicForceToOrderSeven) {
    const Normalization n = normalize_poincare(adiabatic(" + psi^3"), 7);
    const Certificate c = test::certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    EXPECT_EQ(c.through_weight, 7);
}

// The rate of the last derivative that a ring holds is unknown to it: a map with it cannot be judged.
TEST(Adiabatic, TheLastDerivativeIsNotFollowed) {
    Normalization n = normalize_poincare(adiabatic(""), 3);
    const Ring& ring = *n.normal_form.field->ring;
    std::string last = "omega(tau)";
    for (std::string next = "omega'(tau)"; ring.find(next); next.insert(5, "'")) last = next;
    const Polynomial term =
        ring.multiply(gen(ring, last), ring.multiply(gen(ring, "eps", 2), gen(ring, "z2")));
    n.map.mode[0].set(3, n.map.mode[0].part(3) + term);
    const Error error = test::error_when([&] { static_cast<void>(test::certificate_of(n)); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_EQ(error.diagnostic().rule,
              "a normal form holds no higher derivatives than its weights can bring");
    EXPECT_EQ(error.diagnostic().value, last);
}

} // namespace
} // namespace resonform
