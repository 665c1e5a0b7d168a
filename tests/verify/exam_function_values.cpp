// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that give their system's functions a value: derived, emitted and verified as if it had been written.
#include "emit/cpp/cpp.hpp"
#include "own_system.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace resonform {
namespace {

// x'' + 2 eps damping(s) x' + stiffness x + x^3 = 0
class FunctionValues : public test::OwnSystem {
protected:
    Scene scene(const std::string& declared, const std::string& damping, const std::string& stiffness,
                const std::string& values) {
        return read("[parameters]\nk = { positive = true }\n" + declared +
                        "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\", positive = true }\n"
                        "[equations]\nx = \"x'' + 2*eps*" +
                        damping + "*x' + " + stiffness + "*x + x^3 = 0\"\ns = \"s' = eps*k\"\n",
                    values + "[fix]\nk = 0.5\n[start]\nx = \"eps\"\n\"x'\" = 0\ns = 0.25\n"
                             "[verify]\neps = [0.04, 0.02, 0.01, 0.005]\n");
    }

    Scene read(const std::string& system, const std::string& scene) {
        return written(system, "order = 2\n" + scene);
    }

    Scene given(const std::string& d, const std::string& w) {
        return scene("[functions]\nd = { of = [\"s\"] }\nw = { of = [\"k\"], positive = true }\n", "d(2*s)",
                     "w(k)^2*(2 + d'(s))", "[functions]\nd = \"" + d + "\"\nw = \"" + w + "\"\n");
    }
};

std::string without_notes(const std::string& header) {
    std::string text;
    std::istringstream lines(header);
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("//", 0) != 0) text += line + "\n";
    return text;
}

TEST_F(FunctionValues, GiveTheCodeOfWhatIsWritten) {
    const std::string bound = emit_cpp(*test::program_of(given("sin(s)/2", "sqrt(1 + k^2)")), {});
    const std::string written =
        emit_cpp(*test::program_of(scene("", "sin(2*s)/2", "(1 + k^2)*(2 + cos(s)/2)", "")), {});
    EXPECT_EQ(without_notes(bound), without_notes(written));
    EXPECT_NE(bound.find("\n// d(s) = 1/2*sin(s)\n// w(k) = (1 + k^2)^(1/2)\n// with k = 1/2\n"),
              std::string::npos)
        << bound.substr(0, 2000);
    EXPECT_EQ(written.find("// d(s)"), std::string::npos);
}

// One after the other: nothing that is kept of the first serves the second.
TEST_F(FunctionValues, AreInTheReferenceToo) {
    for (const char* d : {"sin(s)/2", "s^2/4"}) {
        const Verification v = test::verified(test::line_of(given(d, "sqrt(1 + k^2)")));
        EXPECT_TRUE(v.as_expected()) << to_text(v);
        EXPECT_EQ(v.outputs.front().found_order, 3) << d;
        EXPECT_NE(to_text(v).find("\n  w(k) = (1 + k^2)^(1/2)\n"), std::string::npos) << to_text(v);
    }
}

// Also with a parameter that a relation gives, or that the equations of a mechanism do not hold.
TEST_F(FunctionValues, StandInStartValues) {
    const std::string named = "[functions]\nf = { of = [\"s\"], positive = true }\n"
                              "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n";
    const auto scene_with = [](const std::string& fix) {
        return "[functions]\nf = \"m*(1 + s^2)\"\n[fix]\n" + fix +
               "[start]\nx = \"eps\"\n\"x'\" = \"eps*f(2)\"\ns = 0\n";
    };
    const std::string related = "[parameters]\nm = { positive = true }\nk = { positive = true }\n"
                                "[relations]\nm = \"2*k\"\n" +
                                named + "[equations]\nx = \"x'' + f(s)*x = 0\"\ns = \"s' = eps\"\n";
    const std::string cancelled = "[parameters]\nm = { positive = true }\n" + named +
                                  "[coordinates]\nx = {}\n[prescribed]\ns = \"s' = eps\"\n"
                                  "[particles]\nq = { mass = \"m\", position = [\"x\", \"s\"] }\n"
                                  "[energy]\npotential = \"f(s)*x^2/2\"\n";
    for (const Scene& scene : {read(related, scene_with("k = 3\n")), read(cancelled, scene_with("m = 6\n"))})
        EXPECT_TRUE(scene.fixed(scene.start_of("x'")->value).is_equal(30 * scene.system->eps));
    const Error error = test::error_when([&] { read(cancelled, scene_with("")); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.diagnostic().value, "f");
}

} // namespace
} // namespace resonform
