// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose system has a function by samples, taken through the line.
#include "algebra/number/error.hpp"
#include "model/files/read_scene.hpp"
#include "scene_line.hpp"
#include "support/shell.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace resonform {
namespace {

// x'' + omega(s)^2 x + x^3 = 0, s' = +eps or -eps
class SampledFrequency : public testing::Test {
protected:
    Scene scene(const std::string& way, double first, double last, const std::string& more, int degree = 5) {
        std::string data = "s,omega\n";
        for (int k = 0; k <= 24; ++k) {
            const double s = first + (last - first) * k / 24;
            data += fmt::format("{},{}\n", s, 1 + std::exp(-s * s) / 2);
        }
        test::write(systems_ / "s/system.toml",
                    "[system]\nname = \"s\"\n[functions]\nomega = { of = [\"s\"], positive = true }\n"
                    "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
                    "[equations]\nx = \"x'' + omega(s)^2*x + x^3 = 0\"\ns = \"s' = " +
                        way + "eps\"\n");
        test::write(systems_ / "s/scenes/data.csv", data);
        test::write(systems_ / "s/scenes/s.toml",
                    fmt::format("order = 2\n[functions]\nomega = {{ data = \"data.csv\", columns = [\"s\", "
                                "\"omega\"], degree = {} }}\n[start]\nx = \"eps\"\n\"x'\" = 0\n{}",
                                degree, more));
        return read_scene(systems_ / "s/scenes/s.toml", systems_);
    }

private:
    test::Scratch scratch_;
    std::filesystem::path systems_ = scratch_.path() / "systems";
};

const std::string four_eps = "[verify]\neps = [0.08, 0.04, 0.02, 0.01]\n";

// The slow variable falls, and passes the pieces from the last to the first.
TEST_F(SampledFrequency, IsVerifiedWithACubicTerm) {
    const Verification v = test::verified(test::line_of(scene("-", 0.3, 1.3 + 1e-9, "s = 1.3\n" + four_eps)));
    EXPECT_TRUE(v.as_expected()) << to_text(v);
    EXPECT_EQ(v.outputs.front().found_order, 3) << to_text(v);
    ASSERT_TRUE(v.outputs.front().data_error);
    EXPECT_GT(v.outputs.front().data_error->error, 1e-12);
    EXPECT_LT(v.outputs.front().data_error->error, 1e-6);
}

TEST_F(SampledFrequency, EndsWhereTheDataEnd) {
    const Scene s = scene("", 0, 1, "s = 0.5\n[verify]\ninterval = \"1/eps\"\n");
    const Interpreter<double> at(test::program_of(s), 0.01, {}, {}, 1.0);
    std::vector<double> x;
    EXPECT_EQ(at.call(49.9, x), Status::ok);
    EXPECT_EQ(at.call(50.1, x), Status::outside_domain);
    EXPECT_STREQ(at.why(Status::outside_domain), "slow flow");
}

TEST_F(SampledFrequency, IsSmoothEnoughOrRefused) {
    try {
        test::line_of(scene("", 0, 1, "s = 0\n", 3));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::refused);
        EXPECT_NE(std::string(error.what()).find("degree 3"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("write degree = 5"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace resonform
