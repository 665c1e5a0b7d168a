// SPDX-License-Identifier: GPL-3.0-or-later
// Integrators against closed solutions, conserved quantities, and each other.
#include "verify/integrate/first_order.hpp"
#include "verify/integrate/integrate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

const std::vector<Method> every_method{Method::taylor,          Method::cvode_adams,     Method::cvode_bdf,
                                       Method::arkode_explicit, Method::arkode_implicit, Method::dopri5,
                                       Method::fehlberg78,      Method::bulirsch_stoer};

// ARKODE's dense output is of a lower order than its steps.
double interpolation(Method method) {
    return method == Method::arkode_explicit || method == Method::arkode_implicit ? 20 : 1;
}

std::vector<double> grid(double end, int points) {
    std::vector<double> times;
    for (int i = 0; i <= points; ++i) times.push_back(end * i / points);
    return times;
}

FirstOrderSystem oscillator() {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("k"), x = b.state("x"), p = b.state("x'");
    return b.build({p, -k * x});
}

FirstOrderSystem pendulum() {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), p = b.state("x'");
    return b.build({p, -sin(x)});
}

template <class Real> class TaylorTypes : public testing::Test {};
using RealTypes = testing::Types<double, long double, Float128, DoubleDouble>;
TYPED_TEST_SUITE(TaylorTypes, RealTypes);

TYPED_TEST(TaylorTypes, HarmonicOscillatorToThePrecisionOfTheType) {
    using Real = TypeParam;
    const double unit = RealTraits<Real>::roundoff();
    std::vector<Real> times;
    for (int i = 0; i <= 100; ++i) times.push_back(Real(i) / Real(4));
    const auto run =
        integrate_taylor<Real>(oscillator(), {Real(4)}, Real(1), {Real(1), Real(0)}, times, unit);
    ASSERT_EQ(run.failure, "");
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Real error = run.values[0][i] - Math<Real>::cos(Real(2) * times[i]);
        EXPECT_LE(std::abs(to_double_value(error)), 200 * unit) << "t = " << to_double_value(times[i]);
    }
}

TYPED_TEST(TaylorTypes, PendulumKeepsItsEnergy) {
    using Real = TypeParam;
    const double unit = RealTraits<Real>::roundoff();
    const std::vector<Real> times{Real(0), Real(50), Real(200)};
    const auto run = integrate_taylor<Real>(pendulum(), {}, Real(1), {Real(2), Real(0)}, times, unit);
    ASSERT_EQ(run.failure, "");
    const auto energy = [&run](std::size_t i) -> Real {
        return run.values[1][i] * run.values[1][i] / Real(2) - Math<Real>::cos(run.values[0][i]);
    };
    for (std::size_t i : {1U, 2U})
        EXPECT_LE(std::abs(to_double_value(Real(energy(i) - energy(0)))), 2000 * unit) << "point " << i;
}

// A step that is one order longer gains the factor of its length: errors follow the tolerance.
TEST(Taylor, ErrorFollowsToleranceAtEveryOrder) {
    for (int order : {8, 16, 30}) {
        for (double tolerance : {1e-6, 1e-9, 1e-12}) {
            const auto run =
                integrate_taylor<double>(oscillator(), {1.0}, 1.0, {1.0, 0.0}, {30.0}, tolerance, order);
            const double error = std::abs(run.values[0][0] - std::cos(30.0));
            EXPECT_LE(error, 30 * tolerance) << "order " << order << ", tolerance " << tolerance;
        }
    }
}

TEST(Taylor, DenseOutputIsAsGoodAsTheSteps) {
    const auto run = integrate_taylor<double>(oscillator(), {1.0}, 1.0, {0.0, 1.0}, grid(20, 2000), 1e-14);
    for (std::size_t i = 0; i <= 2000; ++i)
        EXPECT_NEAR(run.values[0][i], std::sin(0.01 * static_cast<double>(i)), 2e-13);
}

TEST(Taylor, StartsAtZeroValuesAndKeepsPolynomialsExact) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), y = b.state("y");
    const auto run = integrate_taylor<double>(b.build({GiNaC::ex(1), 3 * pow(x, 2) + 0 * y}), {}, 1.0,
                                              {0.0, 0.0}, {0.0, 1.0, 10.0}, 1e-15);
    ASSERT_EQ(run.failure, "");
    EXPECT_EQ(run.values[0], (std::vector<double>{0, 1, 10}));
    EXPECT_NEAR(run.values[1][2], 1000.0, 1e-11);
}

// y' = sin(t)^3: the first derivatives of y that do not vanish are the fourth and later ones.
TEST(Taylor, StartsWithSeveralDerivativesZero) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), p = b.state("x'"), y = b.state("y");
    const FirstOrderSystem system = b.build({p, -x, GiNaC::pow(x, 3)});
    const std::vector<double> times = grid(20, 10);
    const auto run = integrate_taylor<double>(system, {}, 1.0, {0.0, 1.0, 0.0}, times, 1e-15);
    ASSERT_EQ(run.failure, "");
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double c = std::cos(times[i]);
        EXPECT_NEAR(run.values[2][i], c * c * c / 3 - c + 2.0 / 3, 1e-13) << "t = " << times[i];
    }
}

TEST(Taylor, ReportsASingularityInsteadOfRunningForever) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x");
    const auto run =
        integrate_taylor<double>(b.build({pow(x, 2)}), {}, 1.0, {1.0}, {0.5, 2.0}, 1e-14); // 1/(1-t)
    EXPECT_NEAR(run.values[0][0], 2.0, 1e-13);
    EXPECT_NE(run.failure, "");
}

TEST(Taylor, ReportsLeavingTheDomain) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x");
    const auto run = integrate_taylor<double>(b.build({-sqrt(x)}), {}, 1.0, {-1.0}, {1.0}, 1e-14);
    EXPECT_EQ(run.failure, "the solution leaves the domain of the equations near t = 0");
}

TEST(Integrate, EveryMethodFollowsTheHarmonicOscillator) {
    const Tape tape = Tape::rates(oscillator());
    const std::vector<double> times = grid(20, 77);
    for (Method method : every_method) {
        const IntegrationResult run = integrate(method, tape, {1.0}, 1.0, {1.0, 0.0}, times, 1e-10);
        ASSERT_EQ(run.failure, "") << to_string(method);
        ASSERT_GT(run.steps, 0U) << to_string(method);
        for (std::size_t i = 0; i < times.size(); ++i)
            EXPECT_NEAR(run.values[0][i], std::cos(times[i]), 5e-7 * interpolation(method))
                << to_string(method) << ", t = " << times[i];
    }
}

TEST(Integrate, EveryMethodFindsTheSamePendulum) {
    const Tape tape = Tape::rates(test::almost_holonomic_pendulum());
    const double eps = 0.05;
    const std::vector<double> start{eps, 0.0, 1.0, 2.0, 0.0}, times = grid(1 / eps, 50);
    const auto reference = integrate_taylor<double>(tape, {1, 1, 1}, eps, start, times, 1e-16);
    ASSERT_EQ(reference.failure, "");
    for (Method method : every_method) {
        const IntegrationResult run = integrate(method, tape, {1, 1, 1}, eps, start, times, 1e-11);
        ASSERT_EQ(run.failure, "") << to_string(method);
        for (std::size_t s = 0; s < start.size(); ++s)
            for (std::size_t i = 0; i < times.size(); ++i)
                EXPECT_NEAR(run.values[s][i], reference.values[s][i], 1e-8 * interpolation(method))
                    << to_string(method) << ", state " << s;
    }
}

TEST(Integrate, LibrariesComplainInTheResultNotOnStandardError) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x");
    const Tape tape = Tape::rates(b.build({pow(x, 2)})); // ends at t = 1
    for (Method method : every_method) {
        testing::internal::CaptureStderr();
        const IntegrationResult run = integrate(method, tape, {}, 1.0, {1.0}, {2.0}, 1e-8);
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << to_string(method);
        EXPECT_NE(run.failure, "") << to_string(method);
    }
}

// The reference of the ladder: eps = 1e-3 in double-double against Float128 at another order.
TEST(Integrate, ReferencesOfTwoArithmeticsAgree) {
    const Tape tape = Tape::rates(test::almost_holonomic_pendulum());
    const auto run = [&tape]<class Real>(Real, int order) {
        const Real eps = Real(1) / Real(1000);
        return integrate_taylor<Real>(tape, {Real(1), Real(1), Real(1)}, eps,
                                      {eps, Real(0), Real(1), Real(2), Real(0)}, {Real(1000)}, 1e-31, order);
    };
    const auto a = run(DoubleDouble(0), 0);
    const auto b = run(Float128(0), 30);
    for (std::size_t s = 0; s < a.values.size(); ++s)
        EXPECT_LE(std::abs(to_double_value(Float128(convert<Float128>(a.values[s][0]) - b.values[s][0]))),
                  1e-27)
            << s;
}

} // namespace
} // namespace resonform
