// SPDX-License-Identifier: GPL-3.0-or-later
// Constants of the construction: exact numbers with many digits, powers of parameters that leave the range of
// the real type, what has no place there, and what an evaluator says of it.
#include "emit/cpp/cpp.hpp"
#include "emit/cpp/plan.hpp"
#include "own_system.hpp"
#include "support/program.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

using Fifty = boost::multiprecision::cpp_bin_float_50;
using Hundred = boost::multiprecision::cpp_bin_float_100;

class ConstantsOf : public test::OwnSystem {
protected:
    std::shared_ptr<const Program> program(const std::string& system, const std::string& scene,
                                           const ProgramOptions& options = {}) {
        return test::program_of(written(system, scene), options);
    }
    static std::shared_ptr<const EvaluatorLibrary> library(const std::shared_ptr<const Program>& program) {
        return EvaluatorLibrary::build(*program, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache",
                                       {}, "dlq");
    }
    // The outputs at t in 100 digits, interpreted.
    static std::vector<double> exact(const std::shared_ptr<const Program>& program, double eps, double t,
                                     const std::vector<Hundred>& parameters = {}) {
        std::vector<Hundred> values;
        const Interpreter<Hundred> evaluator(program, Hundred(eps), parameters, {}, Hundred(1));
        EXPECT_EQ(evaluator.call(Hundred(t), values), Status::ok) << evaluator.why(Status::overflow);
        std::vector<double> result;
        for (const Hundred& x : values) result.push_back(static_cast<double>(x));
        return result;
    }
    // Interpreted and emitted in Real.
    template <class Real>
    static void expect_values(const std::shared_ptr<const Program>& program,
                              const std::shared_ptr<const EvaluatorLibrary>& library, double eps, double t,
                              const std::vector<double>& expected,
                              const std::vector<double>& parameters = {}) {
        const std::vector<Real> p(parameters.begin(), parameters.end());
        const std::vector<Real> start = default_start<Real>(*program, Real(eps), p);
        std::vector<Real> interpreted, emitted(expected.size());
        EXPECT_EQ(Interpreter<Real>(program, Real(eps), p, start, Real(1)).call(Real(t), interpreted),
                  Status::ok);
        EXPECT_EQ(Evaluator<Real>(library, Real(eps), p, start, Real(1)).call(Real(t), emitted.data()),
                  Status::ok);
        for (std::size_t k = 0; k < expected.size(); ++k) {
            EXPECT_NEAR(static_cast<double>(interpreted[k]), expected[k], 1e-13 * std::abs(expected[k]));
            EXPECT_NEAR(static_cast<double>(emitted[k]), expected[k], 1e-13 * std::abs(expected[k]));
        }
    }
};

const std::string many_digits =
    "[parameters]\nw = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
    "y = { role = \"drift\" }\n[equations]\nx = \"x'' + x = 0\"\n"
    "y = \"y' = eps*15000*x/w^19\"\n";
const std::string many_digits_scene = "order = 2\n[fix]\nw = 1.6812345678901237\n[start]\nx = \"eps\"\n"
                                      "\"x'\" = 0\ny = 0\n";

// Of numerator and denominator each is beyond 2^1024. y = 15000 eps^2 sin(t)/w^19
TEST_F(ConstantsOf, ANumberOfManyDigitsDoesNotVanish) {
    const auto drift = program(many_digits, many_digits_scene);
    const std::vector<double> expected = exact(drift, 0.2, 1);
    const double y = 15000 * 0.2 * 0.2 * std::sin(1.0) / std::pow(1.6812345678901237, 19);
    EXPECT_NEAR(expected[1], y, 1e-13 * y);
    EXPECT_NEAR(y, 0.0261, 5e-5);
    const auto emitted = library(drift);
    expect_values<double>(drift, emitted, 0.2, 1, expected);
    expect_values<long double>(drift, emitted, 0.2, 1, expected);
    expect_values<Float128>(drift, emitted, 0.2, 1, expected);
}

// What is emitted, compiled for types of 50 and 100 digits: the same to their last digits.
TEST_F(ConstantsOf, SlowManyDigitsInWideTypes) {
    const auto drift = program(many_digits, many_digits_scene);
    const test::Scratch scratch;
    test::write(scratch.path() / "scene.hpp", emit_cpp(*drift));
    test::write(scratch.path() / "main.cpp", R"(
#include <boost/multiprecision/cpp_bin_float.hpp>
#include "scene.hpp"
#include <cstdio>
template <class Real> double lost_digits() {
    const Real eps = Real(1) / 5;
    const resonform::generated::s::s::Evaluator<Real> evaluator(eps, {}, {eps, Real(0), Real(0)}, Real(1));
    typename resonform::generated::s::s::Evaluator<Real>::Values values;
    if (evaluator(Real(1), values) != resonform::Status::ok) return 1000;
    const Real w = Real("16812345678901237") / Real("10000000000000000");
    const Real y = 15000 * eps * eps * sin(Real(1)) / pow(w, 19);
    return static_cast<double>(abs(values.y - y) / (y * std::numeric_limits<Real>::epsilon()));
}
int main() {
    std::printf("%d\n", lost_digits<boost::multiprecision::cpp_bin_float_50>() < 64 &&
                            lost_digits<boost::multiprecision::cpp_bin_float_100>() < 64);
}
)");
    const test::Outcome outcome = test::run(std::string(RESONFORM_CXX_COMPILER) + " -std=c++20 -I'" +
                                                RESONFORM_SOURCE_DIR + "/engine' main.cpp -o main && ./main",
                                            scratch.path());
    EXPECT_EQ(outcome.out, "1\n") << outcome.err.substr(0, 2000);
}

// 16 digits of a frequency are as good as 12.
TEST_F(ConstantsOf, AFrequencyOfManyDigits) {
    const auto started = [&](const std::string& n) {
        return program("[parameters]\nn = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                       "y = { role = \"fast\" }\n[equations]\nx = \"x'' + 3*n^2*x + n^2*x*y + x^3/n = 0\"\n"
                       "y = \"y'' + (1 + n)^2*y + n*x^2 + y^2/n^3 = 0\"\n",
                       "order = 3\n[fix]\nn = " + n +
                           "\n[start]\nx = \"eps\"\n\"x'\" = 0\ny = \"eps/2\"\n\"y'\" = \"eps\"\n");
    };
    const auto all = started("0.8660254037844386");
    const std::vector<double> expected = exact(all, 0.01, 50),
                              nearly = exact(started("0.866025403784"), 0.01, 50);
    for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(nearly[k], expected[k], 1e-9 * std::abs(expected[k]));
    std::vector<double> found;
    ASSERT_EQ(Interpreter<double>(all, 0.01, {}, {}, 1).call(50, found), Status::ok);
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-13);
}

const std::string coupled = "[parameters]\nK = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                            "y = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x*y = 0\"\n"
                            "y = \"y'' + K^2*y + K^2*x^2 = 0\"\n";
const std::string coupled_scene = "[start]\namplitude.x = 1\nphase.x = 1\namplitude.y = 0.5\nphase.y = 0\n";

// Coefficients are quotients of polynomials in K: their powers are no doubles, the quotients are.
using SlowConstantsOf = ConstantsOf; // in all real types; minutes under sanitizers
TEST_F(SlowConstantsOf, PowersOfAParameter) {
    const auto open = program(coupled, "order = 3\n" + coupled_scene);
    ASSERT_EQ(open->parameters.size(), 1U);
    const auto emitted = library(open);
    for (const double K : {3.0, 1e8}) {
        const std::vector<double> expected = exact(open, 0.125, 1, {Hundred(K)});
        expect_values<double>(open, emitted, 0.125, 1, expected, {K});
        expect_values<long double>(open, emitted, 0.125, 1, expected, {K});
        expect_values<Float128>(open, emitted, 0.125, 1, expected, {K});
    }
}

// At weights 6 and 7 the degrees are beyond 38: 1e8^39 is no double. (K = 3 is a resonance there.)
TEST_F(SlowConstantsOf, SlowPowersOfAParameterAtHighOrder) {
    for (const int order : {5, 6}) {
        const auto open = program(coupled, fmt::format("order = {}\n", order) + coupled_scene);
        for (const double K : {3.3, 1e8}) {
            const std::vector<double> expected = exact(open, 0.125, 1, {Hundred(K)});
            std::vector<double> found;
            const std::vector<double> parameters{K}, start = default_start<double>(*open, 0.125, parameters);
            ASSERT_EQ(Interpreter<double>(open, 0.125, parameters, start, 1).call(1, found), Status::ok);
            for (std::size_t k = 0; k < expected.size(); ++k)
                EXPECT_NEAR(found[k], expected[k], 1e-13 * std::abs(expected[k])) << order << " " << K;
        }
    }
}

// Interpreted and emitted say the same of the same status.
void expect_reason(const std::shared_ptr<const Program>& program,
                   const std::shared_ptr<const EvaluatorLibrary>& library, double eps,
                   const std::vector<double>& parameters, const std::vector<double>& start, double t,
                   Status status, const std::string& why) {
    const Interpreter<double> interpreter(program, eps, parameters, start, 1);
    const Evaluator<double> emitted(library, eps, parameters, start, 1);
    std::vector<double> values(program->outputs.size());
    EXPECT_EQ(emitted.call(t, values.data()), status) << why;
    EXPECT_EQ(interpreter.call(t, values), status) << why;
    EXPECT_EQ(interpreter.why(status), why);
    EXPECT_EQ(emitted.why(status), why);
}

// A coefficient that is no double is refused by name, whether it is too large or too small.
TEST_F(ConstantsOf, WhatHasNoPlaceIsNamed) {
    const auto open = program("[parameters]\nK = { positive = true }\nL = {}\n[variables]\n"
                              "x = { role = \"fast\" }\ny = { role = \"drift\" }\n"
                              "[equations]\nx = \"x'' + x + L*x^2 = 0\"\ny = \"y' = eps*K^7*x^2\"\n",
                              "order = 2\n[start]\namplitude.x = 1\nphase.x = 0\nconstant.y = 0\n");
    const auto emitted = library(open);
    const std::vector<double> start{1, 0, 0};
    expect_reason(open, emitted, 0.125, {1e30, 1}, start, 1, Status::ok, "");
    for (const double K : {1e60, 1e-60}) {
        const Interpreter<double> interpreter(open, 0.125, {K, 1}, start, 1);
        EXPECT_EQ(interpreter.construction_status(), Status::overflow);
        const std::string why = interpreter.why(Status::overflow);
        EXPECT_FALSE(why.empty());
        expect_reason(open, emitted, 0.125, {K, 1}, start, 1, Status::overflow, why);
    }
    expect_reason(open, emitted, 0.125, {1, NAN}, start, 1, Status::bad_argument, "L");
    expect_reason(open, emitted, 0.125, {-1, 1}, start, 1, Status::outside_domain, "K");
    expect_reason(open, emitted, -1, {1, 1}, start, 1, Status::bad_argument, "eps");
    expect_reason(open, emitted, 0.125, {1, 1}, start, -1, Status::outside_interval, "t");
    expect_reason(open, emitted, 0.125, {1, 1}, start, NAN, Status::bad_argument, "t");
}

// Where the motion ends: a condition at each point, or a divisor that the construction finds too small.
TEST_F(ConstantsOf, ThePlaceWhereTheDomainEndsIsNamed) {
    const auto turning = program("[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
                                 "[domain]\npositive = [\"2 - tau\"]\n[equations]\n"
                                 "x = \"x'' + (2 - tau)*x + x^3 = 0\"\ntau = \"tau' = eps\"\n",
                                 "order = 2\n[start]\ntau = 1.5\namplitude.x = 1\nphase.x = 0\n");
    std::vector<double> values;
    const Interpreter<double> interpreter(turning, 0.01, {}, {}, 1);
    EXPECT_EQ(interpreter.call(99, values), Status::outside_domain);
    const std::string why = interpreter.why(Status::outside_domain);
    EXPECT_EQ(why, "2*sqrt(-tau + 2)"); // the frequency turns within a period
    expect_reason(turning, library(turning), 0.01, {}, default_start<double>(*turning, 0.01, {}), 99,
                  Status::outside_domain, why);
}

// (2 + d)^2: the divisor d stands still. From constants as from values, a map that leaves the weights of the
// system, or does not lead back, is no answer.
TEST_F(SlowConstantsOf, NearAResonanceThatStandsStill) {
    const auto close = [&](const std::string& d, const std::string& start) {
        return program("[parameters]\nd = { positive = true }\n[variables]\nx = { role = \"fast\" }\n"
                       "y = { role = \"fast\" }\n[equations]\nx = \"x'' + x + x*y = 0\"\n"
                       "y = \"y'' + (2 + d)^2*y + x^2 = 0\"\n",
                       "order = 2\n[fix]\nd = " + d + "\n[start]\n" + start);
    };
    const std::string constants = "amplitude.x = 1\nphase.x = 0\namplitude.y = 1\nphase.y = 0\n",
                      physical = "x = \"eps\"\n\"x'\" = 0\ny = \"eps\"\n\"y'\" = 0\n";
    for (const std::string& start : {constants, physical}) {
        const auto near = close("1e-12", start);
        expect_reason(near, library(near), 0.01, {}, default_start<double>(*near, 0.01, {}), 0,
                      Status::outside_domain, "d");
        std::vector<double> values;
        EXPECT_EQ(Interpreter<double>(close("1e-3", start), 0.01, {}, {}, 1).call(0, values),
                  Status::outside_domain)
            << "2.5 amplitudes are added to one";
        EXPECT_EQ(Interpreter<double>(near, 1e-14, {}, {}, 1).call(0, values), Status::ok);
    }
    std::vector<double> values;
    ASSERT_EQ(Interpreter<double>(close("0.02", constants), 0.01, {}, {}, 1).call(0, values), Status::ok);
    EXPECT_NEAR(values[0], 0.01 * (1 + 0.01 / (4 * 0.02)), 4e-4);
}

// Products of two arguments and more are watched: natively, they keep within bounds that are checked.
TEST(ConstantRangeOf, ThePendulumIsNative) {
    const auto program = test::program_of(test::pendulum_scene("third_order"));
    const CppPlan plan(*program);
    EXPECT_TRUE(plan.range.native);
    EXPECT_GE(plan.range.bound, 100);
    EXPECT_EQ(plan.range.limited.size(), 2U); // eps, C_delta
    std::vector<double> values;
    std::vector<double> start = default_start<double>(*program, 0.1, {});
    for (const double C : {1e-200, 1e200}) { // C_delta^3 would be 0, or no number
        start[1] = C;
        const Interpreter<double> interpreter(program, 0.1, {}, start, 1);
        EXPECT_EQ(interpreter.call(1, values), Status::overflow);
        EXPECT_STREQ(interpreter.why(Status::overflow), "C_delta");
    }
    start[1] = 0;
    EXPECT_EQ(Interpreter<double>(program, 0.1, {}, start, 1).call(1, values), Status::ok);
}

} // namespace
} // namespace resonform
