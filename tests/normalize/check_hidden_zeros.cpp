// SPDX-License-Identifier: GPL-3.0-or-later
// Terms that cancel by the relations of roots and functions only: b^3 - (1 - w)*b with b = sqrt(1 - w). They
// change nothing wherever they stand, in forces, couplings, frequencies, denominators and rates.
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// Z stands for what is zero.
std::string file() {
    return "[system]\nname = \"zeros\"\n[parameters]\na = {}\nb = {}\nc = {}\nw = {}\np = { positive = true "
           "}\n"
           "q = { positive = true }\n[relations]\nb = \"sqrt(1 - w)\"\nc = \"sqrt(2 - 2*w)\"\n"
           "[domain]\npositive = [\"1 - w\"]\n"
           "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
           "d = { role = \"drift\" }\n[equations]\n"
           "x = \"x'' + (1 + Z)*x + Z*y + (Z) + x^3/(1 + x*y*(a + b + c + p + q) + Z) = 0\"\n"
           "y = \"y'' + 2*y + Z*x + sin(x^2 + Z)*y^2 = 0\"\n"
           "tau = \"tau' = eps + Z\"\nd = \"d' = x*Z + eps*tau*x^2 + Z\"\n";
}

std::string file_with(const std::string& zero) {
    std::string text = file();
    for (std::size_t at = text.find('Z'); at != std::string::npos; at = text.find('Z', at + zero.size()))
        text.replace(at, 1, "(" + zero + ")");
    return text;
}

class HiddenZeros : public ::testing::TestWithParam<const char*> {};

TEST_P(HiddenZeros, ChangeNothing) {
    const auto field = test::field_from(file_with(GetParam()));
    const Normalization n = test::certified(field, 3);
    EXPECT_EQ(test::coefficient_of(*field, n.normal_form.mode[0], {{"z1", 1}}), field->ring->imaginary());
    EXPECT_EQ(test::coefficient_of(*field, n.normal_form.mode[0], {{"z1", 2}, {"z2", 1}}),
              test::coefficient(*field, "3/8", true));
    EXPECT_EQ(test::coefficient_of(*field, n.normal_form.mode[0], {{"z3", 1}}), Polynomial());
    EXPECT_EQ(n.normal_form.slow[0].total(3), field->ring->gen(field->eps));
}

INSTANTIATE_TEST_SUITE_P(All, HiddenZeros,
                         ::testing::Values("b^3 - (1 - w)*b", "b^5 - (1 - w)^2*b",
                                           "(1 - w)^(5/2) - (1 - 2*w + w^2)*b", "b*c - sqrt(2)*(1 - w)",
                                           "b^3/(1 - w) - b", "(b^3 - (1 - w)*b)/(1 + b)",
                                           "sqrt(p)*sqrt(q) - sqrt(p*q)", "sqrt(p^3*q) - p*sqrt(p*q)",
                                           "sqrt(1 - 2*w + w^2) - 1 + w", "exp(a)*exp(-a) - 1",
                                           "exp(a/2)^2 - exp(a)", "log(p*q) - log(p) - log(q)",
                                           "sin(2*a) - 2*sin(a)*cos(a)", "sqrt(2)*sqrt(3) - sqrt(6)",
                                           "atan(a) + atan(-a)", "tanh(a)*cosh(a) - sinh(a)"));

// What can be told neither zero nor nonzero is not called a force.
TEST(HiddenZeros, UndecidedOnesAreRefused) {
    for (const char* variable : {"x", "tau"}) {
        std::string text = file();
        for (std::size_t at = text.find('Z'); at != std::string::npos; at = text.find('Z', at + 1)) {
            const bool here = text.find(std::string(variable) + " = \"", text.rfind('\n', at)) < at;
            text.replace(at, 1, here ? "(sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2))" : "0");
        }
        const Error error = test::error_when([&] { test::field_from(text); });
        EXPECT_EQ(error.kind(), ErrorKind::refused) << error.what();
        EXPECT_NE(error.diagnostic().value.find("which may be zero"), std::string::npos) << error.what();
        EXPECT_EQ(error.diagnostic().place.key, std::string("equations.") + variable);
    }
}

} // namespace
} // namespace resonform
