// SPDX-License-Identifier: GPL-3.0-or-later
// The pendulum's system file, read: everything in the order of the file, nothing lost.
#include "model/system/system_file.hpp"

#include "messages.hpp"
#include "model/files/read_system.hpp"
#include "model/text/canonical.hpp"
#include "support/error_when.hpp"

namespace resonform {
namespace {

template <typename Named> std::vector<std::string> names(const std::vector<Named>& all) {
    std::vector<std::string> result;
    for (const Named& one : all) result.push_back(one.name);
    return result;
}

using Names = std::vector<std::string>;

TEST(SystemFile, KeepsTheOrderOfTheFile) {
    const System system = read_system(source_dir() / "systems/almost_holonomic_pendulum/system.toml");
    EXPECT_EQ(system.name, "almost_holonomic_pendulum");
    EXPECT_EQ(system.title, "Almost holonomic pendulum");
    EXPECT_EQ(names(system.parameters), (Names{"g", "r", "v"}));
    EXPECT_EQ(names(system.variables), (Names{"psi", "xi", "x", "y"}));
    EXPECT_EQ(names(system.notation), (Names{"C_delta", "theta_0", "C_X", "C_Y"}));
    ASSERT_EQ(system.equations.size(), 4U); // of the variables, in their order
    EXPECT_EQ(system.equations[1].variable, "xi");
    EXPECT_EQ(system.equations[1].text, "xi' = eps*v");
}

TEST(SystemFile, ReadsRolesUnitsAndDomains) {
    const System system = read_system_text(pendulum_system(), "system.toml");
    EXPECT_TRUE(system.parameter("g")->positive);
    EXPECT_TRUE(system.parameter("g")->nonzero);
    EXPECT_FALSE(system.parameter("v")->positive);
    EXPECT_EQ(system.parameter("g")->unit, "m/s^2");
    EXPECT_EQ(system.variable("psi")->role, Role::fast);
    EXPECT_EQ(system.variable("psi")->order, 2);
    EXPECT_EQ(system.variable("psi")->jet.size(), 3U);
    EXPECT_EQ(system.variable("psi")->jet[2].get_name(), "psi''");
    EXPECT_EQ(system.variable("xi")->role, Role::slow);
    EXPECT_EQ(system.variable("y")->role, Role::drift);
    EXPECT_EQ(system.variable("y")->unit, "m");
    EXPECT_EQ(system.variable("z"), nullptr);
}

TEST(SystemFile, NotationNamesTheConstants) {
    const System system = read_system_text(pendulum_system(), "system.toml");
    EXPECT_EQ(system.constant_name("amplitude", "psi"), "C_delta");
    EXPECT_EQ(system.constant_name("constant", "y"), "C_Y");
    const System plain = read_system_text(
        "[system]\nname = \"s\"\n[variables]\nu = { role = \"fast\" }\n[equations]\nu = \"u'' = -u\"\n", "s");
    EXPECT_EQ(plain.constant_name("amplitude", "u"), "amplitude_u");
    EXPECT_EQ(plain.title, "s");
}

TEST(SystemFile, ResidualIsLeftMinusRight) {
    const System system = read_system_text(pendulum_system(), "system.toml");
    const Variable& xi = *system.variable("xi");
    EXPECT_EQ(system.equations[1].residual, xi.jet[1] - system.eps * system.parameter("v")->symbol);
}

TEST(SystemFile, DeclaredExpressionsAreKept) {
    const System system = read_system_text(
        edited(pendulum_system(), "[equations]", "[domain]\npositive = [\"1 + xi/r\"]\n[equations]"), "s");
    ASSERT_EQ(system.positive.size(), 1U);
    EXPECT_EQ(system.positive[0].value, 1 + system.variable("xi")->jet[0] / system.parameter("r")->symbol);
}

TEST(SystemFile, SmallParametersStandForPowersOfEps) {
    const auto file = [](const std::string& domain) {
        return "[system]\nname = \"s\"\n[parameters]\nmu = { weight = 2, positive = true }\nd = { weight = 1 "
               "}\n"
               "k = {}\n[relations]\nk = \"1 + d\"\n[variables]\nx = { role = \"fast\" }\n"
               "[equations]\nx = \"x'' + k*x - mu*x' = 0\"\n[domain]\npositive = [\"" +
               domain + "\"]\n";
    };
    const System system = read_system_text(file("mu"), "system.toml");
    const auto& jet = system.variables[0].jet;
    const GiNaC::ex mu = system.parameters[0].symbol, d = system.parameters[1].symbol, eps = system.eps;
    const GiNaC::ex expected = jet[2] + (1 + eps * d) * jet[0] - eps * eps * mu * jet[1];
    EXPECT_TRUE((system.equations[0].residual - expected).expand().is_zero());
    const Error error = test::error_when([&] { read_system_text(file("3 - d"), "system.toml"); });
    EXPECT_EQ(error.diagnostic().hint, "leave d out");
    EXPECT_EQ(error.diagnostic().place.line, 14);
}

TEST(SystemFile, HoldsFractionsOfWeightsAsIntegers) {
    const System system = read_system_text(
        "[system]\nname = \"s\"\n[parameters]\na = { weight = \"2/3\", positive = true }\n"
        "[variables]\nx = { role = \"fast\", weight = 0.5 }\ny = { role = \"fast\", weight = 2 }\n"
        "[equations]\nx = \"x' = -x*a\"\ny = \"y' = "
        "x*sqrt(3*eps*a)\"\n",
        "system.toml");
    EXPECT_EQ(system.eps_root, 6);
    EXPECT_EQ(system.variables[0].weight, 3);
    EXPECT_EQ(system.variables[1].weight, 12);
    EXPECT_EQ(system.weight(4), Rational(2) / 3);
    const auto &x = system.variables[0].jet, &y = system.variables[1].jet;
    const GiNaC::ex a = system.parameters[0].symbol, root = system.eps;
    const GiNaC::ex expected = y[1] - x[0] * sqrt(GiNaC::ex(3)) * sqrt(a) * pow(root, 5);
    EXPECT_TRUE((system.equations[1].residual - expected).expand().is_zero());
    EXPECT_EQ(spell(pow(root, 5) + root + pow(root, 6) + pow(root, -12)),
              "eps + eps^(-2) + eps^(1/6) + eps^(5/6)");
}

TEST(SystemFile, IsFoundByFolderFileOrName) {
    const std::filesystem::path systems = source_dir() / "systems";
    const std::filesystem::path file = systems / "almost_holonomic_pendulum" / "system.toml";
    EXPECT_EQ(find_system("almost_holonomic_pendulum", systems), file);
    EXPECT_EQ(find_system(file.parent_path().string(), "nowhere"), file);
    EXPECT_EQ(find_system(file.string(), "nowhere"), file);
    const Error error = test::error_when([&] { find_system("almost_holonomic_pendulun", systems); });
    EXPECT_EQ(error.diagnostic().hint.substr(0, 45), "did you mean 'almost_holonomic_pendulum'? Kno");
}

TEST(SystemFile, MissingFilesAndFolders) {
    const auto rule = [](const std::filesystem::path& file) -> std::string {
        const Error error = test::error_when([&] { read_system(file); });
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.diagnostic().rule;
    };
    EXPECT_EQ(rule("no/such/file.toml"), "no such file");
    EXPECT_EQ(rule(source_dir()), "not a regular file");
    EXPECT_EQ(rule("/dev/zero"), "not a regular file");
}

// A number, a comment and an escape do not shift the marked place.
TEST(SystemFile, PlacesSurviveTheSpellingsOfToml) {
    const auto place = [](const std::string& equation) {
        const Error error = test::error_when([&] {
            read_system_text(edited(pendulum_system(), "xi = \"xi' = eps*v\"", equation), "system.toml");
        });
        const Place& p = error.diagnostic().place;
        return std::to_string(p.line) + ":" + std::to_string(p.column) + ": " + p.source_line;
    };
    EXPECT_EQ(place("xi = \"\"\"\nxi' =\n  eps*vv\"\"\""), "23:7:   eps*vv");
    EXPECT_EQ(place("xi = \"\"\"xi' = eps*vv\"\"\""), "21:19: xi = \"\"\"xi' = eps*vv\"\"\"");
    EXPECT_EQ(place("xi = \"xi\\u0027 = eps*vv\""), "21:7: xi = \"xi\\u0027 = eps*vv\"");
    EXPECT_EQ(place("\"xi\" = \"xi' = eps*vv\" # ψ"), "21:19: \"xi\" = \"xi' = eps*vv\" # ψ");
    EXPECT_EQ(place("xi = \"xi' = eps*vv\"\r"), "21:17: xi = \"xi' = eps*vv\"");
}

} // namespace
} // namespace resonform
