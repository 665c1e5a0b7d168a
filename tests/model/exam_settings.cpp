// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in place of parameters.
#include "model/files/settings.hpp"

#include "messages.hpp"

#include "model/files/read_scene.hpp"
#include "model/files/read_system.hpp"
#include "model/text/canonical.hpp"
#include "support/error_when.hpp"

namespace resonform {
namespace {

System set(const std::vector<std::string>& texts, const std::string& file = pendulum_system()) {
    std::vector<Setting> settings;
    for (const std::string& text : texts) settings.push_back(read_setting(text, "--set"));
    return with_settings(read_system_text(file, "system.toml"), settings, "--set");
}

std::string complaint(const std::vector<std::string>& texts) {
    try {
        set(texts);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "";
}

TEST(Settings, TakeTheParametersOut) {
    const System whole = read_system_text(pendulum_system(), "system.toml");
    const System system = with_settings(whole, {{"g", "1"}, {"r", "4/5"}}, "--set");
    ASSERT_EQ(system.parameters.size(), 1U);
    EXPECT_EQ(system.parameters.front().name, "v");
    EXPECT_TRUE(whole.equations.front().residual.has(whole.parameter("g")->symbol));
    for (std::size_t k = 0; k < system.equations.size(); ++k) {
        EXPECT_FALSE(system.equations[k].residual.has(whole.parameter("g")->symbol));
        EXPECT_EQ(system.equations[k].text, whole.equations[k].text);
    }
}

TEST(Settings, AreExact) {
    const std::string file = edited(pendulum_system(), "psi = \"(xi^2", "psi = \"v*psi'' + (xi^2");
    const System a = set({"v=0.1"}, file), b = set({"v=1/10"}, file);
    const GiNaC::ex of_a = a.equations.front().residual.coeff(a.variable("psi")->jet[2]);
    const GiNaC::ex of_b = b.equations.front().residual.coeff(b.variable("psi")->jet[2]);
    const auto at_zero = [](const System& system, const GiNaC::ex& e) {
        return e.subs(GiNaC::lst{system.variable("xi")->jet[0] == 0, system.parameter("r")->symbol == 0});
    };
    EXPECT_TRUE(at_zero(a, of_a).is_equal(GiNaC::numeric(1, 10)));
    EXPECT_TRUE(at_zero(b, of_b).is_equal(GiNaC::numeric(1, 10)));
}

TEST(Settings, MakeNoDenominatorZero) {
    const std::string file = edited(pendulum_system(), "psi = \"(xi^2", "psi = \"psi''/(1 - v) + (xi^2");
    EXPECT_NO_THROW(set({"v=2"}, file));
    const Error error = test::error_when([&] { set({"v=1"}, file); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(std::string(error.what()).find("equations.psi: the values of --set make no denominator zero"),
              std::string::npos)
        << error.what();
}

TEST(Settings, ThatAreWrongAreNamed) {
    EXPECT_NE(complaint({"g=1/(1-1)"}).find("--set: a denominator is zero\n    g=1/(1-1)\n"),
              std::string::npos)
        << complaint({"g=1/(1-1)"});
    EXPECT_NE(complaint({"g"}).find("--set: the setting is not NAME=VALUE"), std::string::npos)
        << complaint({"g"});
    EXPECT_NE(complaint({"=1"}).find("NAME=VALUE"), std::string::npos);
    EXPECT_NE(complaint({"g="}).find("NAME=VALUE"), std::string::npos);
    EXPECT_NE(complaint({"psi=1"}).find("does not name a parameter of the system"), std::string::npos);
    EXPECT_NE(complaint({"gg=1"}).find("did you mean 'g'"), std::string::npos) << complaint({"gg=1"});
    EXPECT_NE(complaint({"g=1", "g=2"}).find("set twice"), std::string::npos);
    EXPECT_NE(complaint({"g=-1"}).find("declares g positive"), std::string::npos);
    EXPECT_NE(complaint({"g=0"}).find("declares g positive"), std::string::npos);
    EXPECT_NE(complaint({"g=r"}).find("r"), std::string::npos); // numbers only
    EXPECT_NE(complaint({"g=ln(2)"}).find("write log"), std::string::npos);
    EXPECT_NE(complaint({"g=1/0"}).find("zero"), std::string::npos);
    EXPECT_NE(complaint({"g=nan"}).find("nan"), std::string::npos);
    EXPECT_EQ(complaint({"v=-3/2"}), "");
}

TEST(Settings, SignsOfConstantsAreDecidedByIntervals) {
    for (const char* positive : {"g=log(2)", "g=sin(1)", "g=1e400", "g=exp(1)-2", "g=atan(5000)-3/2",
                                 "g=exp(-5000)", "g=-sin(1e30)"})
        EXPECT_NO_THROW(set({positive})) << positive;
    for (const char* negative : {"g=cos(2)", "g=log(1/2)", "g=1-1"})
        EXPECT_NE(complaint({negative}).find("declares g positive"), std::string::npos) << negative;
    const Error error = test::error_when([&] { set({"g=sin(1)^2+cos(1)^2-1"}); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("may be zero"), std::string::npos) << error.what();
}

TEST(Settings, MustLieInTheDeclaredDomain) {
    const std::string file =
        edited(pendulum_system(), "[equations]", "[domain]\npositive = [\"g - r\"]\n\n[equations]");
    EXPECT_NO_THROW(set({"g=2", "r=1"}, file));
    EXPECT_EQ(set({"g=2", "r=1"}, file).positive.size(), 0U);
    EXPECT_EQ(set({"g=2"}, file).positive.size(), 1U);
    EXPECT_THROW(set({"g=1", "r=2"}, file), Error);
}

// The mass of the pendulum is in no equation of motion.
TEST(Settings, TakeWhatCancelled) {
    const std::string file = read_text(source_dir() / "systems/pendulum_mechanism/system.toml");
    EXPECT_EQ(set({"M=2", "g=1"}, file).parameters.size(), 2U);
    const auto complaint_of = [&](const std::vector<std::string>& texts) {
        return test::message_when([&] { set(texts, file); });
    };
    EXPECT_NE(complaint_of({"M=-1"}).find("declares M positive"), std::string::npos);
    EXPECT_NE(complaint_of({"M=1", "M=1"}).find("set twice"), std::string::npos);
    EXPECT_NE(complaint_of({"Q=1"}).find("does not name a parameter"), std::string::npos);
}

TEST(Settings, OfASceneTakeWhatCancelled) {
    const std::filesystem::path file = source_dir() / "systems/pendulum_mechanism/scenes/third_order.toml";
    const std::string scene = read_text(file);
    const auto read = [&](const std::string& text) {
        try {
            return spell(read_scene_text(text, file, source_dir() / "systems").fix.at("M"));
        } catch (const Error& error) {
            return std::string(error.what());
        }
    };
    const std::string heavy = edited(scene, "[fix]\n", "[fix]\nM = 2.5\n");
    EXPECT_EQ(read(heavy), "5/2");
    EXPECT_NE(read(edited(scene, "[fix]\n", "[fix]\nM = 0\n")).find("'M' is declared positive"),
              std::string::npos);
    // Where it has a value, a start value may hold it.
    EXPECT_EQ(read(edited(heavy, "xi = ", "xi = \"0*M\" # ")), "5/2");
    EXPECT_NE(read(edited(scene, "xi = ", "xi = \"0*M\" # ")).find("found: M"), std::string::npos);
}

} // namespace
} // namespace resonform
