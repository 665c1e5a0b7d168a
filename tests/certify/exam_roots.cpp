// SPDX-License-Identifier: GPL-3.0-or-later
// Fractional powers in the equations of the pendulum, as powers of its roots G^2 = g and
// sigma^4 = xi^2 + r^2.
#include "certify/roots.hpp"
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

class PendulumRoots : public ::testing::Test {
protected:
    std::shared_ptr<const GradedField> field = test::pendulum();
    const System& system = field->system();
    CertificateRoots roots{*field};
    GiNaC::ex g = system.parameter("g")->symbol, r = system.parameter("r")->symbol,
              v = system.parameter("v")->symbol, xi = system.variable("xi")->jet[0],
              psi = system.variable("psi")->jet[0];

    [[nodiscard]] GeneratorId root_of_index(int index) const {
        for (GeneratorId id = 0; id < field->ring->size(); ++id)
            if (field->ring->generator(id).index == index) return id;
        return -1;
    }

    Radical resolve(const GiNaC::ex& base, int numerator, int denominator) {
        return roots.resolve(base, Rational(numerator) / denominator, system.equations[0]);
    }

    void expect_refused(const GiNaC::ex& base, int numerator, int denominator, const std::string& rule,
                        const std::string& part) {
        const Error e = test::error_when([&] { resolve(base, numerator, denominator); });
        EXPECT_EQ(e.kind(), ErrorKind::refused);
        EXPECT_EQ(e.diagnostic().rule, "the certificate substitutes into the equation as written: " + rule);
        EXPECT_EQ(e.diagnostic().value, part + " in " + system.equations[0].text);
    }
};

using Powers = std::vector<std::pair<GeneratorId, int>>;

TEST_F(PendulumRoots, NumbersAreTakenOut) {
    const Radical radical = resolve(4 * xi * xi + 4 * r * r, -1, 2);
    EXPECT_EQ(radical.number, Rational(1) / 2);
    EXPECT_EQ(radical.roots, (Powers{{root_of_index(4), -2}}));
    EXPECT_TRUE(radical.rest.is_equal(1));
}

TEST_F(PendulumRoots, ProductsAreSplit) {
    Radical radical = resolve((g * pow(xi * xi + r * r, 3)).expand(), 1, 2);
    std::sort(radical.roots.begin(), radical.roots.end());
    EXPECT_EQ(radical.number, 1);
    EXPECT_EQ(radical.roots, (Powers{{root_of_index(2), 1}, {root_of_index(4), 6}}));
}

TEST_F(PendulumRoots, NestedRootsAreMultiplied) {
    Radical radical = resolve(g * pow(xi * xi + r * r, GiNaC::numeric(1, 2)), 1, 2);
    std::sort(radical.roots.begin(), radical.roots.end());
    EXPECT_EQ(radical.roots, (Powers{{root_of_index(2), 1}, {root_of_index(4), 1}}));
}

TEST_F(PendulumRoots, OnlyTheWeightZeroPartCounts) {
    EXPECT_EQ(resolve(xi * xi + r * r + system.eps * v + psi, 1, 2).roots, (Powers{{root_of_index(4), 2}}));
}

TEST_F(PendulumRoots, WholePowersOfPositiveFactorsRemain) {
    const Radical radical = resolve(9 * r * r, 1, 2);
    EXPECT_EQ(radical.number, 3);
    EXPECT_TRUE(radical.roots.empty());
    EXPECT_TRUE(radical.rest.is_equal(r));
}

// sqrt(v^2) = |v|, and the sign of v is not known.
TEST_F(PendulumRoots, FactorsOfUnknownSignAreRefused) {
    const std::string rule = "the base of a fractional power is a product of factors proved positive";
    expect_refused(v * v, 1, 2, rule, "(v^2)^(1/2)");
    expect_refused(-g, 1, 2, rule, "(-g)^(1/2)");
}

TEST_F(PendulumRoots, RootsThatTheRingLacksAreRefused) {
    const std::string rule = "every fractional power in an equation is one of the ring's roots";
    expect_refused(g, 1, 3, rule, "g^(1/3)");
    expect_refused(r, 1, 2, rule, "r^(1/2)");
    expect_refused(GiNaC::ex(2), 1, 2, "every root of a number in an equation is one of the ring's roots",
                   "(2)^(1/2)");
    expect_refused(1 / psi, 1, 2, "no denominator vanishes at the origin", "psi^(-1/2)");
}

} // namespace
} // namespace resonform
