// SPDX-License-Identifier: GPL-3.0-or-later
// Slow flows from physical starts: two modes of one block, starts that the series do not reach, large angles.
#include "own_system.hpp"
#include "support/error_when.hpp"
#include "support/program.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

class FlowFrom : public test::OwnSystem {
protected:
    std::shared_ptr<const Program> program(const std::string& system, const std::string& scene) {
        return test::program_of(written(system, scene));
    }
    // Of each output at t, or the status.
    static std::vector<double> values(const std::shared_ptr<const Program>& program, double eps, double t) {
        const Interpreter<double> evaluator(program, eps, {}, {}, 10);
        std::vector<double> result;
        EXPECT_EQ(evaluator.call(t, result), Status::ok);
        return result;
    }
    static Status status(const std::shared_ptr<const Program>& program, double eps) {
        const Interpreter<double> evaluator(program, eps, {}, {}, 2);
        std::vector<double> result;
        return evaluator.call(0, result);
    }
};

// p'' + eps p' + w^2 p = 0
double damped(double p, double rate, double w, double eps, double t) {
    const double turn = std::sqrt(w * w - eps * eps / 4);
    return std::exp(-eps * t / 2) *
           (p * std::cos(turn * t) + (rate + eps * p / 2) / turn * std::sin(turn * t));
}

// Both modes of a coupled block belong to x; the sum and the difference of x and y decay by themselves.
TEST_F(FlowFrom, TwoModesOfOneBlock) {
    const auto motion =
        program("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                "x = \"x'' + 3*x - y + eps*x' = 0\"\ny = \"y'' + 3*y - x + eps*y' = 0\"\n",
                "order = 2\n[start]\nx = \"eps\"\n\"x'\" = 0\ny = \"eps/2\"\n\"y'\" = \"eps\"\n");
    EXPECT_EQ(motion->flow.size(), 4U);
    const double eps = 1e-3;
    for (const double t : {0.0, 1.0, 50.0, 1000.0}) {
        const double sum = damped(1.5 * eps, eps, std::sqrt(2.0), eps, t);
        const double difference = damped(0.5 * eps, -eps, 2, eps, t);
        const std::vector<double> found = values(motion, eps, t);
        EXPECT_NEAR(found[0], (sum + difference) / 2, 10 * std::pow(eps, 3)) << t;
        EXPECT_NEAR(found[1], (sum - difference) / 2, 10 * std::pow(eps, 3)) << t;
    }
}

// 2 + 2 s = sqrt(3) at T = 0.28, where the rates are infinite; the layer around it begins before, and names
// it.
TEST_F(FlowFrom, AFlowEndsAtTheLayerOfADivisor) {
    const auto motion = program(
        "[variables]\nx = { role = \"fast\", weight = 0 }\nz = { role = \"fast\" }\ns = { role = \"slow\" }\n"
        "[domain]\npositive = [\"1 + s\"]\n[equations]\nx = \"x'' + (1+s)^2*x + eps*x^3 + eps*x*z = 0\"\n"
        "z = \"z'' + 3*z + z*eps*x^2 = eps*x^2\"\ns = \"s' = eps*(x^2 - 1)/(1+s)\"\n",
        "order = 1\noutputs = [\"x\"]\n[start]\nx = 1\n\"x'\" = 0\nz = 0\n\"z'\" = 0\ns = 0\n");
    ASSERT_FALSE(motion->layers.empty());
    const double eps = 1e-4;
    const Interpreter<double> evaluator(motion, eps, {}, {}, 1);
    std::vector<double> result;
    EXPECT_EQ(evaluator.call(0.2 / eps, result), Status::ok);
    EXPECT_EQ(evaluator.call(0.279 / eps, result), Status::outside_domain);
    EXPECT_STREQ(evaluator.why(Status::outside_domain), "sqrt(3) - 2*(s + 1)");
}

// J^2/2 is of the size of eps: the motion librates, and the inverse map leads to J = 14.
TEST_F(FlowFrom, AStartInsideTheLayerHasAStatus) {
    const std::string system =
        "[variables]\nJ = { role = \"slow\", positive = true }\nphi = { role = \"angle\" }\n"
        "[equations]\nJ = \"J' = eps*cos(phi)\"\nphi = \"phi' = J\"\n";
    const auto started = [&](const std::string& J) {
        return program(system, "order = 2\noutputs = [\"J\"]\n[start]\nJ = \"" + J + "\"\nphi = 0\n");
    };
    for (const double eps : {0.002, 0.005, 0.02}) EXPECT_NE(status(started("1/20"), eps), Status::ok) << eps;
    for (const double eps : {1e-5, 1e-6}) EXPECT_EQ(status(started("1/20"), eps), Status::ok) << eps;
}

// 2 w1 - w2 = -1e-6 stands still and has no layer; what is divided by it is larger than the start.
TEST_F(FlowFrom, ADivisorTooSmallForEpsHasAStatus) {
    const auto close = program("[parameters]\nw1 = { positive = true }\nw2 = { positive = true "
                               "}\n[variables]\nx = { role = \"fast\" }\n"
                               "y = { role = \"fast\" }\n[equations]\nx = \"x'' + w1^2*x = x*y\"\ny = \"y'' "
                               "+ w2^2*y = x^2 + y^3\"\n",
                               "order = 2\n[fix]\nw1 = 1\nw2 = \"2000001/1000000\"\n[start]\nx = "
                               "\"eps\"\n\"x'\" = 0\ny = \"eps/2\"\n"
                               "\"y'\" = 0\n");
    EXPECT_EQ(status(close, 0.002), Status::outside_domain);
    EXPECT_EQ(status(close, 1e-9), Status::ok);
}

// Damped by e^-37 and driven by as much: x'' - 2*eps*300*(tau - 1/2)*x' + x + x^3 = 0 ends where it began,
// but for the phase, which the amplitude e^(-150 tau (1 - tau)) of x moves by 3/8 eps times the integral of
// its square.
TEST_F(FlowFrom, AnAmplitudeThatFallsAndRisesAgain) {
    const auto motion = program(
        "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
        "[equations]\nx = \"x'' - 2*eps*300*(tau - 1/2)*x' + x + x^3 = 0\"\ny = \"y'' + 2*y + x^2 = 0\"\n"
        "tau = \"tau' = eps\"\n",
        "order = 1\ntime_scale = 1\noutputs = [\"x\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\ny = 0\n"
        "\"y'\" = 0\ntau = 0\n");
    for (const double eps : {1e-4, 1e-6})
        EXPECT_NEAR(values(motion, eps, 1 / eps)[0], eps * std::cos(1 / eps), 4e-2 * eps) << eps;
    const double dip = values(motion, 1e-4, 5000)[0];
    EXPECT_LT(std::abs(dip), 1e-20);
    EXPECT_GT(std::abs(dip), 1e-22);
}

// 1 - 10003/10000 stands still between 1e-4 eps and eps: what is forced is many amplitudes, and so much the
// more if the cubic term sees it; as long as it is small against eps nothing is wrong with it.
TEST_F(FlowFrom, AForcedMotionOfManyAmplitudesHasAStatus) {
    const std::string system = "[variables]\nx = { role = \"fast\" }\nphi = { role = \"angle\" }\n"
                               "[equations]\nx = \"x'' + x + 5*x^3 = eps^2*cos(phi)\"\n"
                               "phi = \"phi' = 10003/10000\"\n";
    for (const std::string start : {"x = \"eps\"\n\"x'\" = 0\n", "\"amplitude.x\" = 1\n\"phase.x\" = 0\n"})
        for (const std::string turned : {"0", "1.5707963267948966"}) {
            const auto forced =
                program(system, "order = 2\noutputs = [\"x\"]\n[start]\n" + start + "phi = " + turned + "\n");
            EXPECT_EQ(status(forced, 0.01), Status::outside_domain) << start << turned;
            EXPECT_EQ(status(forced, 1e-4), Status::ok) << start << turned;
        }
}

// w_y - w_x = 2e-4 sqrt(s) at eps = 0.01: s would start 4 % beside its start value.
TEST_F(FlowFrom, ASlowVariableThatIsNotGivenBackHasAStatus) {
    const auto close =
        program("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
                "s = { role = \"slow\", positive = true }\n[equations]\nx = \"x'' + s*x = 0\"\n"
                "y = \"y'' + s*(1 + 2/10000)^2*y = 0\"\ns = \"s' = x*y\"\n",
                "order = 2\noutputs = [\"s\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\n"
                "y = 0\n\"y'\" = \"eps\"\ns = 1\n");
    EXPECT_EQ(status(close, 0.01), Status::outside_domain);
    EXPECT_NEAR(values(close, 1e-4, 0)[0], 1, 1e-9);
}

// At rest nothing is added and nothing is missed.
TEST_F(FlowFrom, RestIsAStart) {
    const auto rest = program("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                              "x = \"x'' + x = x*y\"\ny = \"y'' + 4*y = x^2\"\n",
                              "order = 2\n[start]\nx = 0\n\"x'\" = 0\ny = 0\n\"y'\" = 0\n");
    EXPECT_EQ(values(rest, 0.1, 3.0), std::vector<double>({0, 0}));
}

// Turned by what the map adds, an angle of 10^13 keeps its digits: they are those of its place on the circle.
TEST_F(FlowFrom, LargeAngles) {
    const std::string system =
        "[variables]\nJ = { role = \"slow\", positive = true }\nphi = { role = \"angle\" }\n"
        "[equations]\nJ = \"J' = eps*cos(phi)\"\nphi = \"phi' = J\"\n";
    const auto started = [&](const std::string& phi) {
        return program(system, "order = 3\noutputs = [\"J\"]\n[start]\nJ = 1\nphi = " + phi + "\n");
    };
    const double large = 1e13, place = std::atan2(std::sin(large), std::cos(large));
    for (const double t : {0.0, 1.0, 10.0})
        EXPECT_NEAR(values(started("1e13"), 0.1, t)[0],
                    values(started(fmt::format("{:.17g}", place)), 0.1, t)[0], 1e-14);
    const Error e = test::error_when([&] { started("1e15"); });
    EXPECT_EQ(e.diagnostic().hint, "give its remainder by 2*pi");
}

} // namespace
} // namespace resonform
