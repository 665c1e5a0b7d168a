// SPDX-License-Identifier: GPL-3.0-or-later
// [modes]: what a user gives is proved, and what is wrong with it is said in one message.
#include "expand/refusal.hpp"

#include <gtest/gtest.h>

namespace resonform {

namespace {

// Two coupled oscillators with frequencies w1 and w2 and the modal matrix given.
std::string with_modes(const std::string& modes, const std::string& w2 = "{ positive = true }") {
    return "[system]\nname = \"s\"\n[parameters]\nw1 = { positive = true }\nw2 = " + w2 +
           "\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
           "x = \"x'' + (w1^2 + w2^2)/2*x + (w1^2 - w2^2)/2*y + x^2*y = 0\"\n"
           "y = \"y'' + (w1^2 + w2^2)/2*y + (w1^2 - w2^2)/2*x + y^3 = 0\"\n[modes]\n" +
           modes;
}

const std::string first =
    R"(z1 = { eigenvalue = "I*w1", u = { x = "1/2", y = "1/2", "x'" = "I*w1/2", "y'" = "I*w1/2" } })"
    "\n";
const std::string second =
    R"(z3 = { eigenvalue = "I*w2", u = { x = "1/2", y = "-1/2", "x'" = "I*w2/2", "y'" = "-I*w2/2" } })"
    "\n";

std::string with_bad(const std::string& good, const std::string& what, const std::string& by) {
    std::string text = first + second;
    const std::size_t at = text.find(good) + good.find(what);
    return with_modes(text.replace(at, what.size(), by));
}

} // namespace

TEST(GivenModes, AreTakenWithTheRowsOfTheInverse) {
    const auto field = test::field_from(with_modes(first + second));
    ASSERT_EQ(field->basis.modes.size(), 2U);
    const ModeShape& mode = field->basis.modes[1];
    const GiNaC::ex w2 = field->system().parameters[1].symbol;
    EXPECT_TRUE(mode.eigenvalue.im.is_equal(w2));
    // x - y = (z + zbar), so z = (x - y)/2 - i (x' - y')/(2 w2)
    const GiNaC::ex half = GiNaC::ex(1) / 2;
    const GiNaC::ex expected[] = {half, 0, -half, 0}, imaginary[] = {0, -half / w2, 0, half / w2};
    for (std::size_t s = 0; s < 4; ++s) {
        EXPECT_TRUE((mode.row[s].re - expected[s]).normal().is_zero()) << s;
        EXPECT_TRUE((mode.row[s].im - imaginary[s]).normal().is_zero()) << s;
    }
    EXPECT_EQ(field->modes[1].name, "z3");
}

TEST(GivenModes, HoldUnderRelationsBetweenTheirSymbols) {
    // w2 is given by w1, in the equations and in the modes.
    const std::string relation = "[relations]\nw2 = \"sqrt(1 + w1^2)\"\n";
    EXPECT_EQ(test::field_from(with_modes(first + second + relation))->modes.size(), 2U);
}

TEST(GivenModes, RealModesAndZeroEntries) {
    const auto field = test::field_from(
        "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
        "x = \"x' + 2*x + x*y = 0\"\ny = \"y' + y + x = 0\"\n[modes]\n"
        "z1 = { eigenvalue = -1, u = { y = 3 } }\nz2 = { eigenvalue = \"-2\", u = { x = 1, y = 1 } }\n");
    EXPECT_EQ(field->first_order->states[field->basis.modes[0].pivot].name, "y");
    EXPECT_TRUE(field->basis.modes[0].row[1].re.is_equal(GiNaC::ex(1) / 3));
    EXPECT_TRUE(field->modes[1].is_real());
}

TEST(GivenModes, AResidualIsRefusedWithItsValue) {
    const std::string m = test::refusal(with_bad(first, "I*w1/2", "I*w1"), ErrorKind::bad_input);
    EXPECT_TRUE(test::has(m, "A u - eigenvalue u is zero"));
    EXPECT_TRUE(test::has(m, "for z1, in the rate of x"));
    EXPECT_TRUE(test::has(m, "modes.z1"));
    EXPECT_TRUE(test::has(m, "test/system.toml:13"));
    EXPECT_TRUE(
        test::has(test::refusal(with_bad(second, "\"I*w2\"", "\"I*w1\""), ErrorKind::bad_input), "for z3"));
}

TEST(GivenModes, DependentColumnsAreRefused) {
    const std::string again =
        R"(z3 = { eigenvalue = "I*w1", u = { x = 1, y = 1, "x'" = "I*w1", "y'" = "I*w1" } })";
    EXPECT_TRUE(
        test::has(test::refusal(with_modes(first + again), ErrorKind::bad_input), "linearly independent"));
}

TEST(GivenModes, OfAPairTheFirstIsGiven) {
    const std::string conjugate =
        R"(z1 = { eigenvalue = "-I*w1", u = { x = "1/2", y = "1/2", "x'" = "-I*w1/2", "y'" = "-I*w1/2" } })"
        "\n";
    EXPECT_TRUE(test::has(test::refusal(with_modes(conjugate + second), ErrorKind::bad_input),
                          "positive imaginary part"));
    const std::string m = test::refusal(with_modes(first + second, "{}"), ErrorKind::refused);
    EXPECT_TRUE(test::has(m, "w2 for z3"));
    EXPECT_TRUE(test::has(m, "modes.z3.eigenvalue"));
}

TEST(GivenModes, TheTableIsChecked) {
    EXPECT_TRUE(test::has(test::refusal(with_modes(first), ErrorKind::bad_input), "modes for 2 of 4"));
    EXPECT_TRUE(test::has(test::refusal(with_bad(second, "z3", "z2"), ErrorKind::bad_input), "call it z3"));
    EXPECT_TRUE(test::has(test::refusal(with_bad(first, "\"x'\"", "\"x''\""), ErrorKind::bad_input),
                          "below the highest"));
    EXPECT_TRUE(
        test::has(test::refusal(with_bad(first, "eigenvalue", "value"), ErrorKind::bad_input), "value"));
    EXPECT_TRUE(test::has(test::refusal(with_bad(first, "I*w1/2", "I*w3/2"), ErrorKind::bad_input), "w3"));
    EXPECT_TRUE(test::has(test::refusal(with_bad(first, "I*w1/2", "sqrt(I)*w1"), ErrorKind::bad_input),
                          "outside of roots"));
    EXPECT_TRUE(
        test::has(test::refusal(with_bad(first, "I*w1/2", "w1/(I - I)"), ErrorKind::bad_input), "zero"));
    EXPECT_TRUE(test::has(
        test::refusal(with_modes("z1 = { eigenvalue = \"-1\", u = { x = \"I\" } }\n"), ErrorKind::bad_input),
        "a real mode has a real column"));
    EXPECT_TRUE(test::has(test::refusal(with_modes("z1 = { eigenvalue = \"I*w1\" }\n"), ErrorKind::bad_input),
                          "no u"));
}

} // namespace resonform
