// SPDX-License-Identifier: GPL-3.0-or-later
// Which stage is printed in which format, and the messages about the rest.
#include "printed.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "no error";
}

std::string message(const Diagnostic& diagnostic) { return to_string(diagnostic); }

TEST(Document, NamesAreReadBack) {
    for (Format f : {Format::text, Format::latex, Format::json, Format::sympy, Format::maxima})
        EXPECT_EQ(parse_format(to_string(f)), f);
    for (Stage s : {Stage::constraints, Stage::accelerations, Stage::equations, Stage::expand,
                    Stage::normal_form, Stage::solution, Stage::transgression})
        EXPECT_EQ(parse_stage(to_string(s)), s);
    EXPECT_EQ(message_of([] { parse_format("latx"); }),
              message({"a format is one of text, latex, json, sympy, maxima", "latx", "write latex", {}}));
    EXPECT_EQ(
        message_of([] { parse_stage("zzzzzz"); }),
        message({"a stage is one of constraints, accelerations, equations, expand, normal_form, divisors, "
                 "manifold, solution, transgression",
                 "zzzzzz",
                 "name one of these",
                 {}}));
}

TEST(Document, ScriptsExistForNormalFormsOnly) {
    EXPECT_NO_THROW(require_printable(Stage::normal_form, Format::maxima));
    EXPECT_EQ(message_of([] { require_printable(Stage::expand, Format::maxima); }),
              message({"the formats of stage expand are text, latex, json",
                       "maxima",
                       "choose one of these, or stage normal_form",
                       {}}));
}

TEST(Document, OrdersBeyondTheNormalisationAreRefused) {
    const auto normalization = pendulum(2);
    for (int order : {0, -1, 3})
        EXPECT_EQ(message_of([&] { print_normal_form(*normalization, order, Format::text); }),
                  message({"1 <= order <= 2 (weight of the normal form)",
                           std::to_string(order),
                           "choose an order in this range",
                           {}}));
    EXPECT_NE(message_of([&] { print_expansion(*normalization->normal_form.field, 0, Format::text); }),
              "no error");
}

TEST(Document, EndsWithANewlineAndIsTheSameEveryTime) {
    const auto first = pendulum(3), second = pendulum(3);
    for (Format f : {Format::text, Format::latex, Format::json, Format::sympy, Format::maxima}) {
        const std::string text = print_normal_form(*first, 3, f);
        EXPECT_EQ(text, print_normal_form(*second, 3, f)) << to_string(f);
        EXPECT_EQ(text.back(), '\n');
    }
}

} // namespace
} // namespace resonform::test
