// SPDX-License-Identifier: GPL-3.0-or-later
// The method whose cost does not grow with the frequency, against closed solutions; and which systems it
// takes.
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/first_order.hpp"
#include "verify/integrate/linear_oscillator.hpp"
#include "verify/integrate/riccati.hpp"
#include "verify/scene_line.hpp"

#include <boost/math/special_functions/airy.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace resonform {
namespace {

// u'' = rate(u, u', s), s' = eps
FirstOrderSystem driven(
    const std::function<GiNaC::ex(const GiNaC::symbol&, const GiNaC::symbol&, const GiNaC::symbol&)>& rate) {
    test::Builder b;
    const GiNaC::symbol u = b.state("u"), v = b.state("u'"), s = b.state("s");
    return b.build({v, rate(u, v, s), b.eps()});
}

std::optional<LinearOscillator> found_in(const FirstOrderSystem& system) {
    return linear_oscillator(Tape::rates(system));
}

TEST(LinearOscillators, AreFoundByTheirOperations) {
    const auto airy = found_in(driven([](auto& u, auto&, auto& s) { return -s * u; }));
    ASSERT_TRUE(airy);
    EXPECT_EQ(airy->u, 0U);
    EXPECT_EQ(airy->v, 1U);
    EXPECT_TRUE(found_in(driven([](auto& u, auto& v, auto& s) { return -u - s * v / (1 + s * s); })));
    EXPECT_TRUE(found_in(driven([](auto& u, auto&, auto& s) { return -u * GiNaC::pow(2 + cos(s), 2); })));
    EXPECT_TRUE(found_in(driven([](auto& u, auto& v, auto& s) { return (s * u - 3 * (u + v)) / exp(s); })));
}

TEST(LinearOscillators, AreNotFoundInOtherSystems) {
    EXPECT_FALSE(found_in(driven([](auto& u, auto&, auto&) { return -sin(u); })));
    EXPECT_FALSE(found_in(driven([](auto& u, auto& v, auto&) { return -u * (1 + v); })));
    EXPECT_FALSE(found_in(driven([](auto& u, auto&, auto&) { return -1 / u; })));
    EXPECT_FALSE(found_in(driven([](auto& u, auto&, auto& s) { return s - u; })));
    EXPECT_FALSE(found_in(driven([](auto&, auto&, auto& s) { return s; })));
    EXPECT_FALSE(found_in(driven([](auto& u, auto&, auto&) { return -GiNaC::pow(u, GiNaC::ex(1) / 3); })));
    test::Builder two;
    const GiNaC::symbol a = two.state("a"), p = two.state("a'"), b = two.state("b"), q = two.state("b'");
    EXPECT_FALSE(found_in(two.build({p, -a, q, -b})));
    test::Builder slow;
    const GiNaC::symbol u = slow.state("u"), v = slow.state("u'"), s = slow.state("s");
    EXPECT_FALSE(found_in(slow.build({v, -u, slow.eps() * s})));
}

// u and u' at times 0 ... end, and what they should be.
struct Course {
    std::vector<double> times;
    std::vector<std::vector<double>> values;
    Run run;
};

Course course(const FirstOrderSystem& system, double eps, const std::vector<double>& start, double end,
              double tolerance) {
    const Tape tape = Tape::rates(system);
    const CompiledTape code(tape, {}, eps, test::options().cache, [] {});
    Course c;
    for (int i = 0; i <= 1000; ++i) c.times.push_back(end * i / 1000);
    c.values.assign(3, std::vector<double>(c.times.size()));
    c.run = make_riccati(code.rates(), *linear_oscillator(tape), {start, tolerance, {0, 1, 2}})
                ->run(c.times, c.values);
    EXPECT_EQ(c.run.failure, "");
    return c;
}

double largest_error(const Course& c, std::size_t k, const std::function<double(double)>& exact) {
    double error = 0, scale = 0;
    for (std::size_t i = 0; i < c.times.size(); ++i) {
        error = std::max(error, std::abs(c.values[k][i] - exact(c.times[i])));
        scale = std::max(scale, std::abs(exact(c.times[i])));
    }
    return error / scale;
}

// u'' + eps t u = 0: Ai(-eps^(1/3) t), from where it grows, through the turning point, to its fast waves.
TEST(Riccati, AiryThroughItsTurningPoint) {
    const FirstOrderSystem airy = driven([](auto& u, auto&, auto& s) { return -s * u; });
    for (const double eps : {1.0, 1e-2, 1e-4}) {
        const double k = std::cbrt(eps), from = -2 / k, end = 20 / eps - from;
        const auto u = [&](double t) { return boost::math::airy_ai(-k * (from + t)); };
        const auto v = [&](double t) { return -k * boost::math::airy_ai_prime(-k * (from + t)); };
        for (const double tolerance : {1e-5, 1e-9, 1e-13}) {
            const Course c = course(airy, eps, {u(0), v(0), eps * from}, end, tolerance);
            // Solutions that grow towards the turning point multiply errors; phases of 10^6 radians have
            // 10^-10.
            const double allowed = 30 * tolerance + 1e-12 + 2e-15 * std::pow(20.0, 1.5) / eps;
            EXPECT_LE(largest_error(c, 0, u), allowed) << eps << " " << tolerance;
            EXPECT_LE(largest_error(c, 1, v), 3 * allowed) << eps << " " << tolerance;
            EXPECT_LE(largest_error(c, 2, [&](double t) { return eps * (from + t); }), 1e-15);
        }
    }
}

// u'' + u/(1 + s^2)^2 = 0, s = eps t: sqrt(1 + s^2) cos(sqrt(1 + eps^-2) atan s)
TEST(Riccati, CostsNoMoreAtHighFrequency) {
    const FirstOrderSystem burst =
        driven([](auto& u, auto&, auto& s) { return -u / GiNaC::pow(1 + s * s, 2); });
    std::vector<std::size_t> steps;
    for (const double eps : {1e-3, 1e-5, 1e-7}) {
        const double q = std::sqrt(1 + 1 / (eps * eps)), first = std::atan(-3.0);
        const auto u = [&](double t) {
            const double s = eps * t - 3;
            return std::sqrt(1 + s * s) * std::cos(q * (std::atan(s) - first));
        };
        const Course c =
            course(burst, eps, {std::sqrt(10.0), -3 * eps / std::sqrt(10.0), -3}, 6 / eps, 1e-10);
        EXPECT_LE(largest_error(c, 0, u), 1e-9 + 4e-16 / eps) << eps;
        steps.push_back(c.run.steps);
    }
    EXPECT_LE(steps.front(), 12U);
    EXPECT_EQ(steps[1], steps[0]);
    EXPECT_EQ(steps[2], steps[0]);
}

// u'' + 2 g u' + u = 0
TEST(Riccati, DampingIsInTheExponent) {
    const FirstOrderSystem damped =
        driven([](auto& u, auto& v, auto&) { return -u - GiNaC::ex(1) / 50 * v; });
    const double g = 0.01, w = std::sqrt(1 - g * g);
    const Course c = course(damped, 0.1, {1, 0, 0}, 400, 1e-11);
    EXPECT_LE(
        largest_error(
            c, 0, [&](double t) { return std::exp(-g * t) * (std::cos(w * t) + g / w * std::sin(w * t)); }),
        1e-11);
}

} // namespace
} // namespace resonform
