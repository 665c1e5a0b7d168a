// SPDX-License-Identifier: GPL-3.0-or-later
// GiNaC holds (b - tau)^3 as -(tau - b)^3 or not, as the order of its symbols happens to be: that must
// decide nothing. Each file is read many times, with new symbols each time.
#include "normalize/certified.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

struct File {
    const char* positive;
    const char* equation;
    const char* parameters;
};

Normalization normalized(const File& file) {
    const std::string text = std::string("[system]\nname = \"signs\"\n\n[parameters]\n") + file.parameters +
                             "\n[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n\n[domain]\n"
                             "positive = [\"" +
                             file.positive + "\"]\n\n[equations]\nx = \"" + file.equation +
                             "\"\ntau = \"tau' = eps\"\n";
    return normalize_poincare(test::field_from(text), 3);
}

class Signs : public ::testing::TestWithParam<File> {};

TEST_P(Signs, OfTheLibraryDecideNothing) {
    const Normalization first = normalized(GetParam());
    const Certificate certificate = test::certificate_of(first);
    EXPECT_TRUE(certificate.holds) << certificate.complaint;
    for (int k = 0; k < 15; ++k) {
        const Normalization again = normalized(GetParam());
        EXPECT_TRUE(test::certificate_of(again).holds);
        for (int weight = 1; weight <= 3; ++weight) {
            EXPECT_EQ(again.normal_form.mode[0].part(weight), first.normal_form.mode[0].part(weight));
            EXPECT_EQ(again.map.mode[0].part(weight), first.map.mode[0].part(weight));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Files, Signs,
    ::testing::Values(File{"l - tau", "(l-tau)*x'' - 2*eps*x' + g*sin(x) = 0",
                           "l = { positive = true }\ng = { positive = true }\n"},
                      File{"1 - tau", "(1-tau)*x'' - 2*eps*x' + sin(x) = 0", ""},
                      File{"b - tau", "x'' + x + x^3*sqrt((b-tau)^3*b) = 0", "b = { positive = true }\n"},
                      File{"b - tau", "x'' + sqrt(1/(b-tau))*x = 0", "b = { positive = true }\n"},
                      File{"b - tau", "x'' + (b/(b-tau)^3)^(1/2)*x + x^2/(b-tau)^5 = 0",
                           "b = { positive = true }\n"},
                      File{"tau^2 - 2", "x'' + (tau^2 - 1)*x + x^3/tau = 0", ""},
                      File{"4 - tau^2", "x'' + (tau + 2)*x + x^2/(tau - 3) = 0", ""},
                      File{"b - 2", "x'' + (sqrt(b^2 + 1) - b + tau^2)*x + sqrt(b)*x^3 = 0", "b = {}\n"},
                      File{"3 - tau", "x'' + (3*sin(tau) + 4*cos(tau) + 6)*x + x^2 = 0", ""}));

constexpr const char* a_and_b = "a = {}\nb = {}\n";
constexpr const char* roots_of_a_and_b = "a = { positive = true }\nb = { positive = true }\n";

// Even powers: (1 - tau)^2 or (-1 + tau)^2, as it happens.
INSTANTIATE_TEST_SUITE_P(
    Squares, Signs,
    ::testing::Values(File{"a - b", "x'' + (a - b)^2*x = x^2", a_and_b},
                      File{"1 - tau", "x'' + (1 - tau)^2*x = x^2", ""},
                      File{"a - b", "x'' + x = x^2 + eps*x*sqrt((a-b)^2)", a_and_b},
                      File{"a - b", "x'' + (a-b)^4*x = x^2", a_and_b},
                      File{"sqrt(a) - sqrt(b)", "x'' + (sqrt(a)-sqrt(b))^2*x = x^2", roots_of_a_and_b},
                      File{"a - b", "x'' + x = x^2 + eps*x*atan(1/(a-b))", a_and_b},
                      File{"b - a", "x'' + ((b-a)^2)^(3/2)*x = x^2", a_and_b},
                      File{"b - a", "x'' + x = x^2/sqrt((b-a)^2)", a_and_b},
                      File{"a - b", "x'' + x = x^2*(a-b)^(2/3)*((a-b)^2)^(1/3)", a_and_b},
                      File{"2 - exp(tau)", "x'' + (2-cos(tau))^2*x = x^2", ""},
                      File{"2 - exp(tau)", "x'' + (3-2*sin(tau))^2*x = x^2", ""},
                      File{"2 - exp(tau)", "x'' + (2-sin(tau)^2)^2*x = x^2", ""},
                      File{"2 - exp(tau)", "x'' + (2-atan(tau))^2*x = x^2", ""},
                      File{"2 - exp(tau)", "x'' + (2-exp(tau))^2*x = x^2", ""},
                      File{"2 - tau^2", "x'' + (2-tau^2)^2*x = x^2", ""},
                      File{"1 - tau", "x'' + 1/(1-tau)^2*x = x^2", ""}));

// Two quotients of one sign or of two.
INSTANTIATE_TEST_SUITE_P(Quotients, Signs,
                         ::testing::Values(File{"a - b\", \"b - c + a",
                                                "x'' + x = x^2 + eps*x*atan((a-b)/(b-c+a))",
                                                "a = {}\nb = {}\nc = {}\n"}));

} // namespace
} // namespace resonform
