// SPDX-License-Identifier: GPL-3.0-or-later
// Ladders of a system that only the implicit integrator can follow.
#include "model/files/read_scene.hpp"
#include "support/shell.hpp"
#include "verify/scene_line.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// x is a spring, y follows its square at the rate K = 10^8: a Taylor series would take 10^8 steps and more.
class StiffLadder : public testing::Test {
protected:
    test::SceneLine line() {
        const std::filesystem::path systems = scratch_.path() / "systems";
        test::write(systems / "s/system.toml",
                    "[system]\nname = \"s\"\n[parameters]\nK = { positive = true }\n[variables]\n"
                    "x = { role = \"fast\", weight = 0 }\ny = { role = \"fast\", weight = 0 }\n[equations]\n"
                    "x = \"x'' + x + eps*x^3 = 0\"\ny = \"y' = -K*y + K*eps*x^2\"\n");
        test::write(systems / "s/scenes/s.toml",
                    "order = 2\n[fix]\nK = 100000000\n[start]\nx = 1\n\"x'\" = 0\ny = 1\n"
                    "[verify]\neps = [0.05, 0.02, 0.01, 0.005, 0.002]\n");
        return test::line_of(read_scene(systems / "s/scenes/s.toml", systems));
    }

private:
    test::Scratch scratch_;
};

TEST_F(StiffLadder, HasAReference) {
    const Verification v = test::verified(line());
    EXPECT_FALSE(v.conditions.ladder_end);
    ASSERT_EQ(v.outputs.size(), 2U);
    for (const OutputVerdict& o : v.outputs) {
        EXPECT_EQ(o.verdict, Verdict::pass) << o.name << ": " << o.reason;
        EXPECT_EQ(o.found_order, 3) << o.name;
        for (const LadderRung& rung : o.ladder) EXPECT_LT(rung.reference_error, 1e-24) << o.name;
    }
}

TEST_F(StiffLadder, AWrongSignIsFound) {
    test::SceneLine lying = line();
    SlowFlow wrong = *lying.solution.flow;
    for (FlowOutput& output : wrong.outputs)
        if (output.name == "y") output.value.set(2, -output.value.part(2));
    lying.solution.flow = std::make_shared<const SlowFlow>(wrong);
    const Verification v = test::verified(lying);
    EXPECT_EQ(v.outputs[0].verdict, Verdict::pass) << v.outputs[0].reason;
    EXPECT_EQ(v.outputs[1].verdict, Verdict::fail) << v.outputs[1].reason;
    EXPECT_EQ(v.outputs[1].found_order, 2);
}

} // namespace
} // namespace resonform
