// SPDX-License-Identifier: GPL-3.0-or-later
// Energies in invariants that are real: of a quartet lambda, conj(lambda), -lambda, -conj(lambda) the real
// and the imaginary part of z1*z4.
#include "emit/display/real_invariants.hpp"
#include "printed.hpp"

#include "normalize/styles/hamiltonian.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

std::shared_ptr<const Normalization> focus_focus() {
    return std::make_shared<Normalization>(normalize_hamiltonian(
        test::field_from(
            "[system]\nname = \"test\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" "
            "}\np = { role = \"fast\" }\nq = { role = \"fast\" }\n[hamiltonian]\n"
            "energy = \"x*p + 3*y*q + 2*x*q - 2*y*p + x^2*p^2 + y^2*p\"\n"
            "momenta = { x = \"p\", y = \"q\" }\n"),
        3));
}

TEST(RealInvariants, OfAComplexQuartet) {
    const auto n = focus_focus();
    const Ring& ring = *n->normal_form.field->ring;
    const RealInvariants invariants = real_invariants(n->normal_form, 3);
    EXPECT_TRUE(invariants.actions.empty());
    for (const InvariantTerm& t : invariants.energy) {
        EXPECT_EQ(ring.conjugate(t.coefficient), t.coefficient);
        const Polynomial resonant(t.resonant, 1);
        EXPECT_TRUE(t.part != InvariantTerm::Part::whole || ring.conjugate(resonant) == resonant);
    }
    const std::string text = print_normal_form(*n, 3, Format::text, nullptr);
    const std::string energy = text.substr(text.find("energy in real invariants"));
    EXPECT_NE(energy.find("Re(z1*z4)"), std::string::npos) << energy;
    EXPECT_NE(energy.find("Im(z1*z4)"), std::string::npos) << energy;
    EXPECT_NE(energy.find("*z1*z2*z3*z4"), std::string::npos) << energy;
    EXPECT_EQ(energy.find("where:"), std::string::npos) << energy;
}

} // namespace
} // namespace resonform
