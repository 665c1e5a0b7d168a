// SPDX-License-Identifier: GPL-3.0-or-later
// Results are written with names made from those of the variables: a file cannot take them for anything
// else. (A notation s_0 beside a slow variable s once changed numbers in silence.)
#include "messages.hpp"

namespace resonform {
namespace {

TEST(NamesOfResults, AreTakenByNothingElse) {
    const struct {
        const char* from;
        const char* to;
        const char* what;
    } cases[] = {
        {"C_delta =", "xi_0 =", "xi at t = 0"},
        {"C_delta =", "phase_psi =", "phase.psi"},
        {"theta_0 =", "amplitude_psi =", "amplitude.psi"},
        {"theta_0 =", "constant_x =", "constant.x"},
        {"theta_0 =", "z_x =", "the new variable of x"},
        {"theta_0 =", "x_0 =", "x at t = 0"},
    };
    for (const auto& c : cases) {
        const std::string message = system_message(edited(pendulum_system(), c.from, c.to));
        EXPECT_NE(message.find(std::string("results call ") + c.what), std::string::npos) << c.to << message;
        EXPECT_EQ(message.rfind("2 system.toml:", 0), 0U) << message;
        EXPECT_NE(message.find("notation."), std::string::npos) << message;
    }
    const std::string parameter =
        edited(pendulum_system(), "[parameters]", "[parameters]\npsi_0 = { positive = true }");
    EXPECT_NE(system_message(parameter).find("psi at t = 0"), std::string::npos) << system_message(parameter);
}

TEST(NamesOfResults, MayBeGivenToWhatTheyName) {
    EXPECT_EQ(system_message(edited(pendulum_system(), "C_delta =", "amplitude_psi =")), "");
}

TEST(ByteOrderMark, IsNoPartOfTheFile) {
    EXPECT_EQ(system_message("\xEF\xBB\xBF" + pendulum_system()), "");
    EXPECT_EQ(scene_message("\xEF\xBB\xBF"
                            "order = 3\n" +
                            edited(pendulum_scene(), "order = 3", "")),
              "");
}

} // namespace
} // namespace resonform
