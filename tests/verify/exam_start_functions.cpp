// SPDX-License-Identifier: GPL-3.0-or-later
// Start values hold every function of parameters that have no value yet: interpreted and emitted.
#include "algebra/number/functions.hpp"
#include "algebra/number/real_ball.hpp"
#include "emit/program/build_program.hpp"
#include "model/files/read_scene.hpp"
#include "support/program.hpp"
#include "support/shell.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/evaluate/program_defaults.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

class StartFunctions : public testing::Test {
protected:
    std::shared_ptr<const Program> from(const std::string& start) {
        test::write(systems_ / "s/system.toml",
                    "[system]\nname = \"s\"\n[parameters]\na = {}\n[variables]\nx = { role = \"fast\" }\n"
                    "[equations]\nx = \"x'' + x = 0\"\n");
        test::write(systems_ / "s/scenes/s.toml", "order = 2\n[start]\nx = \"" + start + "\"\n\"x'\" = 0\n");
        const Scene scene = read_scene(systems_ / "s/scenes/s.toml", systems_);
        return std::make_shared<const Program>(build_program(test::solution_of(scene), scene));
    }
    static double at(const std::shared_ptr<const Program>& program, double eps, double a) {
        const Interpreter<double> interpreter(program, eps, {a}, default_start<double>(*program, eps, {a}),
                                              1);
        std::vector<double> values(program->outputs.size());
        EXPECT_EQ(interpreter.call(0, values), Status::ok);
        return values[0];
    }
    static double exact(const FunctionRow& row, double a) {
        RealBall x, value;
        arb_set_d(x.get(), a);
        row.enclose(value.get(), x.get(), 128);
        return nearest_double(value);
    }

private:
    test::Scratch scratch_;
    std::filesystem::path systems_ = scratch_.path() / "systems";
};

// Small arguments, too: tanh(1e-9) has all its digits.
TEST_F(StartFunctions, KeepTheirDigits) {
    constexpr double eps = 1e-3;
    for (const FunctionRow& row : function_rows()) {
        const auto program = from(fmt::format("eps*{}(a)", row.name));
        for (const double a : {1e-9, 0.125, 0.75, -0.3, 1.5, 6.0}) {
            const double truth = exact(row, a);
            if (!std::isfinite(truth)) continue; // outside its domain
            EXPECT_NEAR(at(program, eps, a), eps * truth, 1e-15 * eps * std::abs(truth) + 1e-20)
                << row.name << " of " << a;
        }
    }
}

TEST_F(StartFunctions, AreEmitted) {
    const auto program =
        from("eps/20*(sin(a) + cos(a) + tan(a) + exp(a) + log(a) + sinh(a) + cosh(a) + tanh(a) + "
             "asin(a) + acos(a) + atan(a) + asinh(a) + acosh(1 + a) + atanh(a) + erf(a))");
    constexpr double eps = 1e-3, a = 0.4;
    const auto library =
        EvaluatorLibrary::build(*program, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache", {});
    const Evaluator<double> emitted(library, eps, {a}, default_start<double>(*program, eps, {a}), 1.0);
    std::vector<double> values(program->outputs.size());
    ASSERT_EQ(emitted.call(0.0, values.data()), Status::ok);
    double sum = 0;
    for (const FunctionRow& row : function_rows())
        sum += exact(row, row.argument == Argument::at_least_one ? 1 + a : a);
    EXPECT_NEAR(values[0], eps / 20 * sum, 1e-18);
    EXPECT_NEAR(at(program, eps, a), values[0], 1e-18);
}

} // namespace
} // namespace resonform
