// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose system has a function by samples, taken through the line.
#include "algebra/number/error.hpp"
#include "own_system.hpp"
#include "scene_line.hpp"
#include "support/documented.hpp"
#include "support/error_when.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/report/json.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace resonform {
namespace {

// x'' + omega(s)^2 x + x^3 = 0, s' = +eps or -eps
class SampledFrequency : public test::OwnSystem {
protected:
    using Function = double (*)(double);
    static double smooth(double s) { return 1 + std::exp(-s * s) / 2; }

    std::string domain_; // a table of the system

    Scene scene(const std::string& way, double first, double last, const std::string& more, int degree = 5,
                Function omega = smooth) {
        std::string data = "s,omega\n";
        for (int k = 0; k <= 24; ++k) {
            const double s = first + (last - first) * k / 24;
            data += fmt::format("{},{}\n", s, omega(s));
        }
        write_beside("data.csv", data);
        return written(
            domain_ +
                "[functions]\nomega = { of = [\"s\"], positive = true }\n"
                "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
                "[equations]\nx = \"x'' + omega(s)^2*x + x^3 = 0\"\ns = \"s' = " +
                way + "eps\"\n",
            fmt::format("order = 2\n[functions]\nomega = {{ data = \"data.csv\", columns = [\"s\", "
                        "\"omega\"], degree = {} }}\n[start]\nx = \"eps\"\n\"x'\" = 0\n{}",
                        degree, more));
    }
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

    const std::string line =
        fmt::format("\n  data error of x: {:.2e} at eps = 0.01, by the spline through every "
                    "other sample\n",
                    v.outputs.front().data_error->error);
    EXPECT_NE(to_text(v).find(line), std::string::npos) << to_text(v);
    const nlohmann::ordered_json json = to_json(v);
    EXPECT_EQ(json["outputs"][0]["data_error"]["eps"], 0.01);
    EXPECT_EQ(json["outputs"][0]["data_error"]["error"], v.outputs.front().data_error->error);
    EXPECT_EQ(test::undocumented(json, test::file_formats()), std::set<std::string>());
}

// Of a function that jumps from sample to sample, the third derivative of whose spline is of the size of
// 10^4: a series that is continued over a breakpoint is wrong in the fifth digit. The other integrator takes
// steps of lower order, and finds the breakpoints by its error control.
TEST_F(SampledFrequency, IsIntegratedFromPieceToPiece) {
    const auto rough = [](double s) { return 2 + 0.5 * std::cos(40 * s * s); };
    const Scene s = scene("", 0, 1, "s = 0\n", 3, rough);
    const Tape tape = Tape::rates(solve_for_highest(s.system));
    const std::vector<double> start{1.0, 0.0, 0.0};
    std::vector<double> times;
    for (int k = 0; k <= 40; ++k) times.push_back(k / 4.0);
    const CompiledTape code(tape, {}, 0.1, test::options().cache, [] {});
    const auto integrated = [&](Method method) {
        const Start from{start, 1e-13, {0}};
        const auto integrator =
            method == Method::taylor ? make_taylor(code, from) : make_integrator(method, code.rates(), from);
        std::vector<std::vector<double>> values(1, std::vector<double>(times.size()));
        EXPECT_EQ(integrator->run(times, values).failure, "");
        return values.front();
    };
    const auto other = integrated(Method::fehlberg78), compiled = integrated(Method::taylor);
    const auto exactly = integrate_taylor<DoubleDouble>(tape, {}, DoubleDouble(0.1), {1.0, 0.0, 0.0},
                                                        {times.begin(), times.end()}, 1e-28);
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_NEAR(to_double_value(exactly.values[0][i]), other[i], 1e-8) << times[i];
        EXPECT_NEAR(compiled[i], to_double_value(exactly.values[0][i]), 1e-12) << times[i];
    }
}

TEST_F(SampledFrequency, EndsWhereTheDataEnd) {
    const Scene s = scene("", 0, 1, "s = 0.5\n[verify]\ninterval = \"1/eps\"\n");
    const Interpreter<double> at(test::program_of(s), 0.01, {}, {}, 1.0);
    std::vector<double> x;
    EXPECT_EQ(at.call(49.9, x), Status::ok);
    EXPECT_EQ(at.call(50.1, x), Status::outside_domain);
    EXPECT_STREQ(at.why(Status::outside_domain), "slow flow");
}

// 1 + exp(-s^2)/2 = 5/4 at s = 0.8325...
TEST_F(SampledFrequency, BoundsTheMotionByTheDomain) {
    domain_ = "[domain]\npositive = [\"omega(s) - 5/4\"]\n";
    const std::string interval = "s = 0\n[verify]\neps = [0.04, 0.02, 0.01]\ninterval = ";
    const Scene within = scene("", 0, 1, interval + "\"4/(5*eps)\"\n");
    const Interpreter<double> at(test::program_of(within), 0.01, {}, {}, 1.0);
    std::vector<double> x;
    EXPECT_EQ(at.call(83.2, x), Status::ok);
    EXPECT_EQ(at.call(83.3, x), Status::outside_domain);
    EXPECT_STREQ(at.why(Status::outside_domain), "omega(s) - 5/4");
    EXPECT_TRUE(test::verified(test::line_of(within)).as_expected());
    const Error error = test::error_when(
        [&] { (void)test::verified(test::line_of(scene("", 0, 1, interval + "\"1/eps\"\n"))); });
    EXPECT_NE(std::string(error.what()).find("s = 0.8325"), std::string::npos) << error.what();
    EXPECT_THROW(scene("", 0, 1, "s = 0.9\n"), Error); // starts outside
}

TEST_F(SampledFrequency, IsSmoothEnoughOrRefused) {
    const Error error = test::error_when([&] { test::line_of(scene("", 0, 1, "s = 0\n", 3)); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("degree 3"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("write degree = 5"), std::string::npos) << error.what();
}

} // namespace
} // namespace resonform
