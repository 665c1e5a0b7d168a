// SPDX-License-Identifier: GPL-3.0-or-later
// Two equal imaginary pairs with one eigenvector each, coupled through velocities: a chain of generalised
// eigenvectors of one block of four states.
#include "normalize/certified.hpp"
#include "normalize/styles/normalize.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// A free particle in a frame that turns with the rate w.
std::string particle(const std::string& style) {
    return "[system]\nname = \"test\"\n[parameters]\nw = { positive = true }\n[variables]\n"
           "x = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
           "x = \"x'' - 2*w*y' - w^2*x + x*(x^2 + y^2) = eps*x\"\n"
           "y = \"y'' + 2*w*x' - w^2*y + y*(x^2 + y^2) = eps*y\"\n[normal_form]\nstyle = \"" +
           style + "\"\n";
}

TEST(HamiltonianHopf, HasAChainOfTwoModes) {
    const auto field = test::field_from(particle("inner_product"));
    ASSERT_EQ(field->modes.size(), 2U);
    ASSERT_EQ(field->couplings(0).size(), 1U);
    EXPECT_EQ(field->couplings(0).front().factor, 1);
    EXPECT_TRUE(field->couplings(1).empty());
    const Normalization n = normalize(field, 5);
    const Certificate certificate = certify(n.normal_form, n.map);
    EXPECT_TRUE(certificate.holds) << certificate.complaint;
    EXPECT_EQ(test::coefficient_of(*field, n.normal_form.mode[1], {{"z1", 2}, {"z2", 1}}),
              test::coefficient(*field, "-1"));
}

TEST(HamiltonianHopf, IsRefusedInStylePoincare) {
    const Error error = test::error_when([&] { test::field_from(particle("poincare")); });
    EXPECT_EQ(error.diagnostic().value, "lambda^2 + w^2 is a 2-fold factor of the characteristic polynomial "
                                        "of x, y, and has fewer eigenvectors");
    EXPECT_EQ(error.diagnostic().hint.substr(0, 29), "write style = \"inner_product\"");
}

} // namespace
} // namespace resonform
