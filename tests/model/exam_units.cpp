// SPDX-License-Identifier: GPL-3.0-or-later
// Units that fit together, are found where they are not given, and are refused with the term.
#include "messages.hpp"
#include "model/files/dimension.hpp"
#include "model/files/read_system.hpp"
#include "model/mechanics/derivation.hpp"

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
              "2 system.toml:15:14: energy.potential: units fit together\n"
              "    potential = \"c*x/2\"\n"
              "                 ^\n"
              "  found: the potential is in kg*m/s^2, not in kg*m^2/s^2\n"
              "  hint:  correct the expression or the units; a file without units is not checked");
    EXPECT_EQ(system_message(edited(mechanism_with_units, "eps*x*x'\"", "eps*x*x' + eps*x'\"")),
              "2 system.toml:17:6: constraints.a: units fit together\n"
              "    a = \"y' = eps*x*x' + eps*x'\"\n"
              "         ^\n"
              "  found: beside the term -eps*x', the term -eps*x*x' is in [eps]*m^2/s, not in [eps]*m/s\n"
              "  hint:  correct the expression or the units; a file without units is not checked");
    EXPECT_EQ(
        system_message(edited(mechanism_with_units, "[constraints]", "[forces]\nx = \"m*x\"\n[constraints]")),
        "2 system.toml:17:6: forces.x: units fit together\n"
        "    x = \"m*x\"\n"
        "         ^\n"
        "  found: force times coordinate is in kg*m^2, not in kg*m^2/s^2\n"
        "  hint:  correct the expression or the units; a file without units is not checked");
}

TEST(Units, OfEnergiesNameTheirKey) {
    EXPECT_EQ(system_message(
                  edited(mechanism_with_units, "[constraints]", "dissipation = \"c*x'^2/2\"\n[constraints]")),
              "2 system.toml:16:16: energy.dissipation: units fit together\n"
              "    dissipation = \"c*x'^2/2\"\n"
              "                   ^\n"
              "  found: the dissipation times a second is in kg*m^2/s^3, not in kg*m^2/s^2\n"
              "  hint:  correct the expression or the units; a file without units is not checked");
}

TEST(Units, OfRelationsAndDomain) {
    const std::string related = edited(edited(mechanism_with_units, "[variables]",
                                              "k = { positive = true, unit = \"kg/s^2\" }\n[variables]"),
                                       "c*x^2/2", "(c + k)*x^2/2");
    EXPECT_EQ(system_message(related + "[relations]\nk = \"2*c\"\n"), "");
    EXPECT_EQ(system_message(related + "[relations]\nk = \"2*c*m\"\n"),
              "2 system.toml:20:6: relations.k: units fit together\n"
              "    k = \"2*c*m\"\n"
              "         ^\n"
              "  found: the relation is in kg^2/s^2, not in kg/s^2\n"
              "  hint:  correct the expression or the units; a file without units is not checked");
    EXPECT_EQ(system_message(related + "[domain]\npositive = [\"c + 2*k\"]\n"), "");
    EXPECT_EQ(system_message(related + "[domain]\npositive = [\"c + 2*m\"]\n"),
              "2 system.toml:20:14: domain.positive[0]: units fit together\n"
              "    positive = [\"c + 2*m\"]\n"
              "                 ^\n"
              "  found: beside the term 2*m, the term c is in kg/s^2, not in kg\n"
              "  hint:  correct the expression or the units; a file without units is not checked");
}

TEST(Units, OfVariableAndCoordinateAgree) {
    EXPECT_EQ(system_message(edited(mechanism_with_units, "[coordinates]\nx = {}",
                                    "[coordinates]\nx = { unit = \"J/N\" }")),
              "");
    EXPECT_EQ(system_message(edited(mechanism_with_units, "[coordinates]\nx = {}",
                                    "[coordinates]\nx = { unit = \"cm\" }")),
              "2 system.toml:10:15: coordinates.x.unit: the coordinate has two units\n"
              "    x = { unit = \"cm\" }\n"
              "                  ^\n"
              "  found: 'cm' here, 'm' under [variables]\n"
              "  hint:  correct one of the two");
}

// In every file, with equations or with a mechanism.
TEST(Units, ThatAreMalformedAreNamed) {
    EXPECT_EQ(system_message(edited(pendulum_system(), "unit = \"m/s^2\"", "unit = \"2*m\"")),
              "2 system.toml:7:32: parameters.g.unit: a unit is a product of powers of units\n"
              "    g = { positive = true, unit = \"2*m\" }\n"
              "                                   ^\n"
              "  found: '2*m'\n"
              "  hint:  write it as in \"kg*m^2/s^2\"; \"1\" is none");
    EXPECT_EQ(system_message(edited(pendulum_system(), "xi = { role = \"slow\", unit = \"m\" }",
                                    "xi = { role = \"slow\", unit = \"m/\" }"))
                  .find("2 system.toml:13:32: variables.xi.unit: "),
              0U);
}

TEST(Units, ThatWereFoundAreSaid) {
    const auto remarks = [](const std::string& file) {
        return read_system_text(file, "system.toml").derivation->remarks.back();
    };
    EXPECT_EQ(remarks(mechanism_with_units), "units found: eps in 1/m");
    EXPECT_EQ(remarks(edited(mechanism_with_units, "c = { positive = true, unit = \"N/m\" }",
                             "c = { positive = true }")),
              "units found: eps in 1/m, c in kg/s^2");
}

TEST(Units, OfNothingAreNotChecked) {
    std::string bare = mechanism_with_units;
    for (const char* unit : {", unit = \"kg\"", ", unit = \"N/m\"", ", unit = \"m\"", " unit = \"m\" "})
        bare = edited(bare, unit, "");
    EXPECT_EQ(system_message(edited(bare, "c*x^2/2", "c*x^2*(1 + x)/2")), "");
}

} // namespace
} // namespace resonform
