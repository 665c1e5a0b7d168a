// SPDX-License-Identifier: GPL-3.0-or-later
// Terms that may cancel by an identity which the ring does not know are refused by name, not printed.
#include "emit/display/decided.hpp"
#include "printed.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

std::string message_of(const std::string& cubic) {
    const auto field =
        test::field_from("[system]\nname = \"test\"\n[parameters]\na = { positive = true }\n[variables]\n"
                         "x = { role = \"fast\" }\n[equations]\nx = \"x'' + x + (" +
                         cubic + ")*x^3 = 0\"\n");
    try {
        require_decided(normalize_poincare(field, 3).normal_form);
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::refused);
        return e.what();
    }
    return "";
}

TEST(Undecided, ComplementaryArcTangents) {
    const std::string message = message_of("atan(a) + atan(1/a) - pi/2");
    EXPECT_NE(message.find("each coefficient of a normal form is proved to be zero or to be different"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("-3*I*(pi - 2*atan(a) - 2*atan(1/a))/16 of z1^2*z2 in z1'\n"), std::string::npos)
        << message;
}

TEST(Undecided, NotWhatDiffersFromZero) {
    EXPECT_EQ(message_of("atan(a) + atan(1/a)"), "");
    EXPECT_EQ(message_of("log(2) + log(3)"), "");
    EXPECT_EQ(message_of("atan(a) - atan(2*a) + exp(1/3) - exp(1/2)"), "");
}

} // namespace
} // namespace resonform
