// SPDX-License-Identifier: GPL-3.0-or-later
// Units that fit together, are found where they are not given, and are refused with the term.
#include "messages.hpp"
#include "model/dimension.hpp"

namespace resonform {
namespace {

std::string unit(const std::string& text) { return to_string(read_unit(text, {})); }

TEST(Units, AreProductsOfPowers) {
    EXPECT_EQ(unit("N/m"), "kg/s^2");
    EXPECT_EQ(unit("m^(1/2)*s^-1"), "m^(1/2)/s");
    EXPECT_EQ(unit("J/(N*m)"), "1");
    EXPECT_EQ(unit("furlong/fortnight"), "furlong/fortnight");
    EXPECT_THROW(unit("m + s"), Error);
    EXPECT_THROW(unit("2*m"), Error);
}

TEST(Units, AreFoundFromEquations) {
    Dimensions known;
    const Dimension m = read_unit("m", {}), eps = Dimensions::unknown("eps");
    EXPECT_TRUE(known.equate(m, product(eps, power(m, 2))));
    EXPECT_EQ(to_string(known.resolved(eps)), "1/m");
    EXPECT_FALSE(known.equate(eps, m));
}

const std::string mechanism_with_units =
    "[system]\nname = \"mechanism\"\n[parameters]\nm = { positive = true, unit = \"kg\" }\n"
    "c = { positive = true, unit = \"N/m\" }\n[variables]\nx = { role = \"fast\", unit = \"m\" }\n"
    "y = { unit = \"m\" }\n[coordinates]\nx = {}\ny = {}\n[particles]\n"
    "p = { mass = \"m\", position = [\"x\", \"y\"] }\n[energy]\npotential = \"c*x^2/2\"\n"
    "[constraints]\na = \"y' = eps*x*x'\"\n";

TEST(Units, OfAMechanismFitTogether) { EXPECT_EQ(system_message(mechanism_with_units), ""); }

TEST(Units, OfAMechanismMayBeWrong) {
    EXPECT_EQ(system_message(edited(mechanism_with_units, "c*x^2/2", "c*x/2")),
              "2 system.toml:14:1: energy: units fit together\n"
              "    [energy]\n"
              "    ^\n"
              "  found: the potential is in kg*m/s^2, not in kg*m^2/s^2\n"
              "  mend:  correct the expression or the units; a file without units is not checked");
    EXPECT_EQ(system_message(edited(mechanism_with_units, "eps*x*x'\"", "eps*x*x' + eps*x'\"")),
              "2 system.toml:17:6: constraints.a: units fit together\n"
              "    a = \"y' = eps*x*x' + eps*x'\"\n"
              "         ^\n"
              "  found: beside the term -eps*x', the term -eps*x*x' is in [eps]*m^2/s, not in [eps]*m/s\n"
              "  mend:  correct the expression or the units; a file without units is not checked");
    EXPECT_EQ(
        system_message(edited(mechanism_with_units, "[constraints]", "[forces]\nx = \"m*x\"\n[constraints]")),
        "2 system.toml:17:6: forces.x: units fit together\n"
        "    x = \"m*x\"\n"
        "         ^\n"
        "  found: force times coordinate is in kg*m^2, not in kg*m^2/s^2\n"
        "  mend:  correct the expression or the units; a file without units is not checked");
}

TEST(Units, OfNothingAreNotChecked) {
    std::string bare = mechanism_with_units;
    for (const char* unit : {", unit = \"kg\"", ", unit = \"N/m\"", ", unit = \"m\"", " unit = \"m\" "})
        bare = edited(bare, unit, "");
    EXPECT_EQ(system_message(edited(bare, "c*x^2/2", "c*x^2*(1 + x)/2")), "");
}

} // namespace
} // namespace resonform
