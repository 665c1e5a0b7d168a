// SPDX-License-Identifier: GPL-3.0-or-later
// Modes whose growth rate has no declared sign, or passes through zero: statuses on both sides, values
// against direct integration, lies.
#include "solve/flow/slow_flow.hpp"
#include "verify/estimate/times.hpp"
#include "verify/own_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace resonform {
namespace {

class RatesOfAnySign : public test::InterpretedSystem {};

// z' = (mu + i omega) z - b |z|^2 z + eps, z = x + i y, mu = s - 1, s' = eps
std::string slow_spiral(const std::string& omega, const std::string& b) {
    const std::string square = b == "0" ? "" : " - " + b + "*(x^2 + y^2)*";
    return "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\ns = { role = \"slow\" "
           "}\n[equations]\n"
           "x = \"x' = (s - 1)*x - " +
           omega + "*y + eps" + (b == "0" ? "" : square + "x") + "\"\ny = \"y' = " + omega +
           "*x + (s - 1)*y" + (b == "0" ? "" : square + "y") + "\"\ns = \"s' = eps\"\n";
}

std::string started_at(double s) {
    return "order = 3\noutputs = [\"x\", \"y\"]\n[start]\nx = \"eps\"\ny = 0\ns = " + std::to_string(s) +
           "\n";
}

// By the rule of Runge and Kutta, in long double.
std::complex<double> integrated_spiral(double omega, double b, double eps, double s, double t) {
    using Complex = std::complex<long double>;
    const auto rate = [&](const Complex& z, long double now) {
        return (Complex(s + eps * now - 1, omega) - static_cast<long double>(b) * std::norm(z)) * z +
               static_cast<long double>(eps);
    };
    const int steps = static_cast<int>(std::ceil(t * 1000));
    const long double h = static_cast<long double>(t) / steps;
    Complex z = eps;
    for (int i = 0; i < steps; ++i) {
        const long double now = h * i;
        const Complex k1 = rate(z, now), k2 = rate(z + h / 2 * k1, now + h / 2),
                      k3 = rate(z + h / 2 * k2, now + h / 2), k4 = rate(z + h * k3, now + h);
        z += h / 6 * (k1 + 2.0L * k2 + 2.0L * k3 + k4);
    }
    return {static_cast<double>(z.real()), static_cast<double>(z.imag())};
}

const std::string with_undeclared_rate =
    "[parameters]\nk = {}\n[variables]\nx = { role = \"fast\" }\ny = { role = "
    "\"fast\" }\n[equations]\nx = \"x' = k*x - 2*y + eps + x^2\"\n"
    "y = \"y' = 2*x + k*y\"\n";

TEST_F(RatesOfAnySign, FollowAParameterOfEitherSign) {
    for (const std::string k : {"1", "-1"}) {
        const std::string scene =
            "order = 2\noutputs = [\"x\", \"y\"]\n[start]\nx = \"eps\"\ny = 0\n[fix]\nk = " + k +
            "\n[verify]\neps = [0.04, 0.02, 0.01, 0.005]\n";
        const Scene read = written(with_undeclared_rate, scene);
        const Verification v = test::verified(test::line_of(read));
        for (const OutputVerdict& o : v.outputs) EXPECT_EQ(o.verdict, Verdict::pass) << k << o.reason;
        EXPECT_EQ(v.emitted.verdict, Verdict::pass) << to_text(v.emitted);
        EXPECT_EQ(v.conditions.growth_end.has_value(), k == "1");
        EXPECT_EQ(at(with_undeclared_rate, scene, 0.01, 0).status, Status::ok);
        EXPECT_EQ(at(with_undeclared_rate, scene, 0.01, 30).status,
                  k == "1" ? Status::low_precision : Status::ok);
    }
}

// y' = (s - 1) y: a fold ends the domain, from either side.
TEST_F(RatesOfAnySign, AFoldEndsTheDomain) {
    for (const std::string direction : {"", "-"}) {
        const std::string system =
            "[variables]\ny = { role = \"fast\" }\ns = { role = \"slow\" }\n[equations]\n"
            "y = \"y' = " +
            direction + "(s - 1)*y + eps\"\ns = \"s' = eps\"\n";
        const std::string scene = "order = 2\noutputs = [\"y\"]\n[start]\ny = \"eps\"\ns = 0\n";
        EXPECT_EQ(at(system, scene, 0.01, 1).status, Status::ok) << direction;
        const Answer beyond = at(system, scene, 0.01, 101);
        EXPECT_EQ(beyond.status, Status::outside_domain) << direction;
        EXPECT_EQ(beyond.why, "-s + 1");
    }
}

// Counted from the start: e^chi is 1 again at s = 2, and not from the crossing, where 10^3 eps^3 e^chi is 1
// at s = 1 + sqrt(2 eps ln(10^-3 eps^-3)) = 1.46.
TEST_F(RatesOfAnySign, ReturnAfterAsLongAsTheyWereStable) {
    const double eps = 0.03;
    for (const double s : {0.5, 0.999, 1.0, 1.001, 1.5, 1.9, 1.999}) {
        const double t = s / eps;
        const Answer answer = at(slow_spiral("2", "0"), started_at(0), eps, t);
        ASSERT_EQ(answer.status, Status::ok) << s << answer.why;
        const std::complex<double> exact = integrated_spiral(2, 0, eps, 0, t);
        EXPECT_NEAR(answer.values[0], exact.real(), 20 * std::pow(eps, 4)) << s;
        EXPECT_NEAR(answer.values[1], exact.imag(), 20 * std::pow(eps, 4)) << s;
    }
    // e^chi <= 1 + 1/(10^3 eps^3)
    const double last = 1 + std::sqrt(1 + 2 * eps * std::log(1 + 1e-3 / std::pow(eps, 3)));
    EXPECT_EQ(at(slow_spiral("2", "0"), started_at(0), eps, (last - 1e-3) / eps).status, Status::ok);
    const Answer beyond = at(slow_spiral("2", "0"), started_at(0), eps, (last + 1e-3) / eps);
    EXPECT_EQ(beyond.status, Status::low_precision);
    EXPECT_EQ(beyond.why, "chi");
}

// lambda = 0 at s = 1 - i/2: from s = -1 the motion departs at s = 1.5, not at 3. As it leaves, its size is
// eps sqrt(2 pi/eps) e^B.
TEST_F(RatesOfAnySign, DepartAtTheBufferPoint) {
    const double eps = 0.004;
    const auto departure = [&](double s) {
        const double t = (s + 1) / eps;
        const Answer answer = at(slow_spiral("0.5", "0"), started_at(-1), eps, t);
        EXPECT_FALSE(answer.values.empty());
        const std::complex<double> exact = integrated_spiral(0.5, 0, eps, -1, t);
        return std::pair(answer.status, std::abs(std::complex(answer.values[0], answer.values[1]) - exact));
    };
    for (const double s : {-0.5, 0.5, 0.99, 1.01, 1.2, 1.3}) {
        const auto [status, error] = departure(s);
        EXPECT_EQ(status, Status::ok) << s;
        EXPECT_LT(error, 1e-3 * eps) << s;
    }
    for (const double s : {1.45, 1.5, 1.6}) EXPECT_EQ(departure(s).first, Status::low_precision) << s;
    EXPECT_GT(departure(1.6).second, eps) << "it has left";
}

// Monomials such as |z|^2 z are divided by 2 mu. Where it is 0 they are gone, but for a gap.
TEST_F(RatesOfAnySign, PassZerosOfTheirDivisors) {
    const double eps = 0.03;
    for (const double s : {0.5, 0.9, 1.1, 1.5, 1.9}) {
        const double t = s / eps;
        const Answer answer = at(slow_spiral("2", "1"), started_at(0), eps, t);
        ASSERT_EQ(answer.status, Status::ok) << s << answer.why;
        const std::complex<double> exact = integrated_spiral(2, 1, eps, 0, t);
        EXPECT_NEAR(answer.values[0], exact.real(), 100 * std::pow(eps, 4)) << s;
        EXPECT_NEAR(answer.values[1], exact.imag(), 100 * std::pow(eps, 4)) << s;
    }
    const Answer there = at(slow_spiral("2", "1"), started_at(0), eps, (1 + 1e-9) / eps);
    EXPECT_EQ(there.status, Status::low_precision);
}

// What grows first is not believed when it has come back.
TEST_F(RatesOfAnySign, DoNotPassFromAboveZero) {
    std::string system = slow_spiral("2", "0");
    for (std::size_t place = 0; (place = system.find("(s - 1)", place)) != std::string::npos;)
        system.replace(place, 7, "(1 - s)");
    EXPECT_EQ(at(system, started_at(0.9), 0.01, 1).status, Status::ok);
    EXPECT_EQ(at(system, started_at(0.9), 0.01, 50).status, Status::low_precision);
}

// Beside another mode, or where lambda is not linear in time, the buffer point is not known: the sign is
// kept.
TEST_F(RatesOfAnySign, KeepTheirSignWhereTheBufferPointIsNotKnown) {
    const std::string curved =
        "[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n[equations]\n"
        "x = \"x'' - 2*(s - 1)*x' + (4 + (s - 1)^2)*x = eps\"\ns = \"s' = eps*(1 + s^2)\"\n";
    const std::string scene = "order = 2\noutputs = [\"x\"]\n[start]\nx = \"eps\"\n\"x'\" = 0\ns = 0\n";
    EXPECT_EQ(at(curved, scene, 0.01, 50).status, Status::ok);
    EXPECT_EQ(at(curved, scene, 0.01, 100).status, Status::outside_domain);
}

TEST_F(RatesOfAnySign, EndTheirLadderWithTheDigits) {
    const Scene scene = written(slow_spiral("2", "0"),
                                started_at(0) + "[verify]\neps = [\"1/8\", \"1/12\", \"1/16\", \"1/20\", "
                                                "\"1/25\", \"1/40\"]\ninterval = \"9/(5*eps)\"\n");
    const test::SceneLine line = test::line_of(scene);
    const GradedField& field = *line.solution.normalization->normal_form.field;
    EXPECT_NEAR(digits_lost(field, scene, Rational(1) / 20), 20 * 0.82 / std::log(10), 1e-3);
    const Verification v = test::verified(line);
    for (const OutputVerdict& o : v.outputs) EXPECT_EQ(o.verdict, Verdict::pass) << o.reason;
    EXPECT_EQ(v.emitted.verdict, Verdict::pass) << to_text(v.emitted);
    ASSERT_TRUE(v.conditions.ladder_end);
    EXPECT_EQ(v.conditions.ladder_end->eps, Rational(1) / 40);
    EXPECT_EQ(v.outputs.front().ladder.size(), 5U);
}

// An exponent that is wrong by O(eps^2) is seen when the motion comes back, with the same phase 4/eps = 2 pi
// n at each eps.
TEST_F(RatesOfAnySign, AWrongExponentFails) {
    const Scene scene =
        written(slow_spiral("2", "0"),
                started_at(0) + "[verify]\neps = [0.127324, 0.0909457, 0.0707355, 0.0578745, 0.0489708, "
                                "0.0424413]\ninterval = \"2/eps\"\n");
    test::SceneLine line = test::line_of(scene);
    EXPECT_EQ(test::verified(line).outputs.front().verdict, Verdict::pass);
    const Ring& ring = *line.solution.normalization->normal_form.field->ring;
    SlowFlow wrong = *line.solution.flow;
    const Polynomial eps = ring.gen(line.solution.normalization->normal_form.field->eps);
    wrong.decays[0] = wrong.decays[0] + ring.multiply(ring.multiply(eps, eps), eps);
    line.solution.flow = std::make_shared<const SlowFlow>(wrong);
    const OutputVerdict found = test::verified(line).outputs.front();
    EXPECT_EQ(found.verdict, Verdict::fail) << found.reason;
    EXPECT_NEAR(found.slope, 3, 0.1);
}

} // namespace
} // namespace resonform
