// SPDX-License-Identifier: GPL-3.0-or-later
// [change] beside [equations], from the file to numbers.
#include "support/command.hpp"

#include <nlohmann/json.hpp>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

class ChangedVariables : public Command {
protected:
    void system(const std::string& equations) const {
        write(scratch_.path() / "systems/s/system.toml",
              "[system]\nname = \"s\"\n[parameters]\nr = { positive = true }\n[variables]\n"
              "psi = { role = \"fast\" }\nxi = { role = \"slow\" }\n[equations]\n" +
                  equations);
        write(scratch_.path() / "systems/s/scenes/a.toml",
              "order = 2\n[fix]\nr = 2\n[start]\npsi = \"eps/2\"\n\"psi'\" = 0\nxi = 1\n");
    }
    [[nodiscard]] std::string values() const {
        return printed("evaluate systems/s/scenes/a.toml --eps 0.1 --t 0,1,7");
    }
};

const std::string changed = "phi = \"phi'' + sin(phi) - xi/r*cos(phi) = 0\"\nxi = \"xi' = eps\"\n"
                            "[change]\nphi = \"psi + atan(xi/r)\"\n",
                  by_hand =
                      "psi = \"psi'' - 2*r*xi*xi'^2/(r^2 + xi^2)^2 + sqrt(r^2 + xi^2)/r*sin(psi) = 0\"\n"
                      "xi = \"xi' = eps\"\n";

} // namespace

TEST_F(ChangedVariables, ASceneIsThatOfTheEquationsByHand) {
    system(changed);
    const std::string values_of_change = values(), form = printed("derive s --order 3");
    system(by_hand);
    EXPECT_EQ(values_of_change, values());
    EXPECT_EQ(form, printed("derive s --order 3"));
}

TEST_F(ChangedVariables, AreBothInTheDocumentOfEquations) {
    system(changed);
    const Json document = Json::parse(printed("derive s --stage equations --format json"));
    EXPECT_EQ(document["variables"][0]["name"], "psi");
    EXPECT_EQ(document["change"]["values"], Json({{"phi", "psi + atan(xi/r)"}}));
    EXPECT_EQ(document["change"]["equations"][0],
              Json({{"variable", "phi"}, {"equation", "phi'' + sin(phi) - xi/r*cos(phi) = 0"}}));
    const std::string text = printed("derive s --stage equations --set r=2");
    EXPECT_NE(text.find("before the change of variables:\n  phi'' + sin(phi) - xi*cos(phi)/2 = 0\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("change of variables:\n  phi = psi + atan(xi/2)\n"), std::string::npos) << text;
    system(by_hand);
    EXPECT_FALSE(Json::parse(printed("derive s --stage equations --format json")).contains("change"));
    const Outcome stage = said("derive s --stage constraints");
    EXPECT_EQ(stage.code, 2);
}

} // namespace resonform::test
