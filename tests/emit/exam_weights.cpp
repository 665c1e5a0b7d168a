// SPDX-License-Identifier: GPL-3.0-or-later
// Fractions of weights and of powers of eps, in every format.
#include "printed.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace resonform::test {
namespace {

std::shared_ptr<const GradedField> strongly_damped() {
    return field_from("[system]\nname = \"damped\"\n[parameters]\nd = { positive = true }\n[variables]\n"
                      "x = { role = \"fast\", weight = \"1/2\" }\n[equations]\n"
                      "x = \"x'' + 2*d*sqrt(eps)*x' + x + x^3 = 0\"\n");
}

TEST(Weights, InText) {
    const auto n = certified(strongly_damped(), 3);
    const std::string text = print_normal_form(*n, 3, Format::text);
    test::expect_part(text, "normal form of damped through weight 3/2 (style poincare)\n");
    test::expect_part(text, "z1' = I*z1 - d*z1*sqrt(eps) - I*d^2/2*z1*eps + 3*I/8*z1^2*z2\n");
    test::expect_part(text, "  z1 = x - I*x'/omega + O(eps)\n");
    test::expect_part(text, "certificate: holds through weight 3/2 (");
    EXPECT_EQ(print_expansion(*n->normal_form.field, 2, Format::text),
              "equations of damped, expanded through weight 1\n\n"
              "x'' + x + 2*d*x'*sqrt(eps) + O(eps^(3/2)) = 0\n");
    test::expect_part(print_divisors(*n->normal_form.field, n->divisors, 3, Format::text),
                      "  D(z2*sqrt(eps)) = -2*I\n");
}

TEST(Weights, InLatexMaximaAndSympy) {
    const auto n = certified(strongly_damped(), 4);
    test::expect_part(print_normal_form(*n, 4, Format::latex), R"(z_{1} \sqrt{\varepsilon})");
    test::expect_part(print_expansion(*n->normal_form.field, 2, Format::latex),
                      R"(O\left(\varepsilon^{3/2}\right))");
    test::expect_part(print_normal_form(*n, 4, Format::maxima), "z1*sqrt(eps)");
    const Scratch scratch;
    write(scratch.path() / "script.py", print_normal_form(*n, 4, Format::sympy));
    const Outcome outcome =
        run("python3 -c \"import script as s; print(s.normal_form['z1']"
            "[(1, 0, s.Rational(1, 2))], s.series(s.normal_form['z1']).coeff(s.eps, 1))\"",
            scratch.path());
    EXPECT_EQ(outcome.out, "-d -I*d**2*z1/2\n") << outcome.err;
}

TEST(Weights, InJson) {
    const auto n = certified(strongly_damped(), 4);
    const auto document = nlohmann::json::parse(print_normal_form(*n, 3, Format::json));
    EXPECT_EQ(document["order"], "3/2");
    EXPECT_EQ(document["truncation"], 2);
    EXPECT_EQ(document["certificate"]["through_weight"], 2);
    const auto& terms = document["normal_form"];
    ASSERT_EQ(terms.size(), 4U);
    EXPECT_EQ(terms[0]["weight"], "1/2");
    EXPECT_EQ(terms[1]["weight"], 1);
    EXPECT_EQ(terms[1]["exponents"].dump(), R"({"eps":"1/2","z1":1})");
    EXPECT_EQ(terms[2]["exponents"]["eps"], 1);
    const auto expansion = nlohmann::json::parse(print_expansion(*n->normal_form.field, 2, Format::json));
    EXPECT_EQ(expansion["order"], 1);
    EXPECT_EQ(expansion["equations"][0]["next_weight"], "3/2");
}

} // namespace
} // namespace resonform::test
