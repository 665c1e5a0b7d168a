// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit integrator against closed solutions, and against the Taylor series where that can.
#include "verify/function_cases.hpp"
#include "verify/integrate/first_order.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/radau.hpp"
#include "verify/integrate/tape_jacobian.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace resonform {
namespace {

using Dd = DoubleDouble;

std::vector<Dd> even_grid(double end, int points) {
    std::vector<Dd> times;
    for (int i = 0; i <= points; ++i) times.push_back(Dd(end) * Dd(i) / Dd(points));
    return times;
}

// The lengths of a layer 1/K, and of what comes after it.
std::vector<Dd> layer_and_rest(double k, double end) {
    std::vector<Dd> times{Dd(0)};
    for (double t = 0.01 / k; t < end; t *= 1.3) times.emplace_back(t);
    times.emplace_back(end);
    return times;
}

template <class Real>
Integration<Real> run_implicit(const FirstOrderSystem& system, const std::vector<Real>& parameters,
                               const std::vector<Real>& start, const std::vector<Real>& times,
                               double tolerance) {
    return integrate_implicit<Real>(Tape::rates(system), parameters, Real(0.01), start, times, tolerance);
}

// The largest error of a state; exact: a function of t.
template <class Real, class Exact>
double largest_error(const Integration<Real>& run, std::size_t state, const std::vector<Real>& times,
                     Exact exact) {
    double most = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        most = std::max(most, std::abs(to_double_value(Real(run.values[state][i] - exact(times[i])))));
    return most;
}

double difference(const Integration<Dd>& a, const Integration<Dd>& b, std::size_t state) {
    double most = 0;
    for (std::size_t i = 0; i < a.values[state].size(); ++i)
        most = std::max(most, std::abs(to_double_value(Dd(a.values[state][i] - b.values[state][i]))));
    return most;
}

FirstOrderSystem unit_oscillator() {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), p = b.state("x'");
    return b.build({p, -x});
}

FirstOrderSystem decay() {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("K"), y = b.state("y");
    return b.build({-k * y});
}

// A spring with a stiff follower: x'' + x + eps x^3 = 0, y' = -K y + K eps x^2.
FirstOrderSystem stiff_spring() {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("K"), x = b.state("x"), p = b.state("x'"), y = b.state("y");
    return b.build({p, -x - b.eps() * pow(x, 3), -k * y + k * b.eps() * pow(x, 2)});
}

template <class Real> class ImplicitTypes : public testing::Test {};
using ImplicitRealTypes = testing::Types<double, Float128, DoubleDouble>;
TYPED_TEST_SUITE(ImplicitTypes, ImplicitRealTypes);

// int_0^1 c^k and, from the matrix, int_0^{c_i} c^k: exact through degrees 2s - 2 and s - 1.
TYPED_TEST(ImplicitTypes, TheRuleIntegratesPolynomials) {
    using Real = TypeParam;
    for (const int stages : {2, 3, 9, 16, 30}) {
        const RadauRule<Real> rule(stages);
        const std::size_t s = rule.stages;
        EXPECT_TRUE(rule.nodes.back() == Real(1));
        EXPECT_TRUE(rule.nodes.front() > Real(0));
        EXPECT_TRUE(std::is_sorted(rule.nodes.begin(), rule.nodes.end()));
        std::vector<Real> power(s, Real(1)); // c_j^k
        for (std::size_t k = 0; k < 2 * s - 1; ++k) {
            for (std::size_t i = k < s ? 0 : s - 1; i < s; ++i) {
                Real sum(0);
                for (std::size_t j = 0; j < s; ++j) sum += rule.matrix[i * s + j] * power[j];
                const Real exact = power[i] * rule.nodes[i] / Real(static_cast<double>(k + 1));
                EXPECT_LE(std::abs(to_double_value(Real(sum - exact))), 50 * RealTraits<Real>::roundoff())
                    << stages << " stages, degree " << k << ", node " << i;
            }
            for (std::size_t j = 0; j < s; ++j) power[j] *= rule.nodes[j];
        }
    }
}

TYPED_TEST(ImplicitTypes, FiftyPeriodsOfAnOscillator) {
    using Real = TypeParam;
    const double unit = RealTraits<Real>::roundoff();
    std::vector<Real> times;
    for (int i = 0; i <= 1000; ++i) times.push_back(Real(i) * Real(315) / Real(1000));
    const auto run = run_implicit<Real>(unit_oscillator(), {}, {Real(1), Real(0)}, times, 0);
    ASSERT_EQ(run.failure, "");
    EXPECT_LT(largest_error(run, 0, times, [](const Real& t) { return Math<Real>::cos(t); }), 20000 * unit);
    EXPECT_LT(run.steps, 700U);
}

TYPED_TEST(ImplicitTypes, DecaysAtEveryRate) {
    using Real = TypeParam;
    for (const double k : {1.0, 1e3, 1e8}) {
        std::vector<Real> times;
        for (const Dd& t : layer_and_rest(k, 100)) times.push_back(convert<Real>(t));
        const auto run = run_implicit<Real>(decay(), {Real(k)}, {Real(1)}, times, 0);
        ASSERT_EQ(run.failure, "") << k;
        const auto exact = [k](const Real& t) { return Math<Real>::exp(Real(-k) * t); };
        EXPECT_LT(largest_error(run, 0, times, exact), 2000 * RealTraits<Real>::roundoff()) << k;
        EXPECT_LT(run.steps, 250U) << k;
    }
}

// y' = -K (y - cos t) - sin t (A. Prothero and A. Robinson, Mathematics of Computation 28 (1974) 145-162):
// methods of low stage order lose their order here.
TEST(Implicit, ProtheroAndRobinson) {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("K"), y = b.state("y"), tau = b.state("tau");
    const FirstOrderSystem system = b.build({-k * (y - cos(tau)) - sin(tau), GiNaC::ex(1)});
    for (const double rate : {1e3, 1e8})
        for (const double offset : {0.0, 1.0}) {
            const std::vector<Dd> times = layer_and_rest(rate, 50);
            const auto run = run_implicit<Dd>(system, {Dd(rate)}, {Dd(1 + offset), Dd(0)}, times, 1e-28);
            ASSERT_EQ(run.failure, "");
            const auto exact = [&](const Dd& t) { return Dd(cos(t) + Dd(offset) * exp(Dd(-rate) * t)); };
            EXPECT_LT(largest_error(run, 0, times, exact), 1e-27) << rate << " " << offset;
        }
}

// Eigenvalues -1 and -K, no eigenvector along an axis: rates of size K cancel, and what cancels leaves K t
// units in the last place.
TEST(Implicit, ObliqueExponentials) {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("K"), u = b.state("u"), v = b.state("v");
    const FirstOrderSystem system = b.build({(k - 2) * u + 2 * (k - 1) * v, -(k - 1) * u - (2 * k - 1) * v});
    for (const double rate : {1e3, 1e8}) {
        const std::vector<Dd> times = layer_and_rest(rate, 20);
        const auto run = run_implicit<Dd>(system, {Dd(rate)}, {Dd(1), Dd(0)}, times, 1e-28);
        ASSERT_EQ(run.failure, "");
        const double bound = std::max(1e-26, 20 * rate * RealTraits<Dd>::roundoff());
        EXPECT_LT(largest_error(run, 0, times,
                                [rate](const Dd& t) { return Dd(2 * exp(-t) - exp(Dd(-rate) * t)); }),
                  bound)
            << rate;
        EXPECT_LT(
            largest_error(run, 1, times, [rate](const Dd& t) { return Dd(exp(Dd(-rate) * t) - exp(-t)); }),
            bound)
            << rate;
    }
}

// y = x/(1 + x) attracts at the rate K (M. J. Davis and R. T. Skodje, Journal of Chemical Physics 111 (1999)
// 859-874).
TEST(Implicit, DavisAndSkodje) {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("K"), x = b.state("x"), y = b.state("y");
    const FirstOrderSystem system = b.build({-x, -k * y + ((k - 1) * x + k * pow(x, 2)) / pow(1 + x, 2)});
    for (const double rate : {10.0, 1e5, 1e8}) {
        const std::vector<Dd> times = layer_and_rest(rate, 10);
        const auto run = run_implicit<Dd>(system, {Dd(rate)}, {Dd(1), Dd(2)}, times, 1e-28);
        ASSERT_EQ(run.failure, "");
        const auto exact = [rate](const Dd& t) {
            const Dd slow = exp(-t);
            return Dd(slow / (1 + slow) + Dd(1.5) * exp(Dd(-rate) * t));
        };
        EXPECT_LT(largest_error(run, 0, times, [](const Dd& t) { return Dd(exp(-t)); }), 1e-27) << rate;
        EXPECT_LT(largest_error(run, 1, times, exact), 1e-27) << rate;
    }
}

TEST(Implicit, AgreesWithTheTaylorSeries) {
    const std::vector<Dd> times = even_grid(100, 5000), start{Dd(1), Dd(0), Dd(1)};
    const auto taylor = integrate_taylor<Dd>(stiff_spring(), {Dd(100)}, Dd(0.01), start, times, 1e-32);
    const auto run = run_implicit<Dd>(stiff_spring(), {Dd(100)}, start, times, 1e-28);
    ASSERT_EQ(run.failure, "");
    for (std::size_t s = 0; s < 3; ++s) EXPECT_LT(difference(run, taylor, s), 1e-27) << s;
}

TEST(Implicit, ErrorFollowsTolerance) {
    const std::vector<Dd> times = even_grid(30, 1000), start{Dd(1), Dd(0), Dd(1)};
    const auto exact = run_implicit<Dd>(stiff_spring(), {Dd(1e8)}, start, times, 1e-28);
    for (const double tolerance : {1e-6, 1e-10, 1e-15, 1e-20, 1e-25}) {
        const auto run = run_implicit<Dd>(stiff_spring(), {Dd(1e8)}, start, times, tolerance);
        ASSERT_EQ(run.failure, "");
        for (std::size_t s = 0; s < 3; ++s) {
            EXPECT_LT(difference(run, exact, s), 100 * tolerance) << s << ", tolerance " << tolerance;
        }
        EXPECT_LT(run.steps, exact.steps);
    }
}

// Layers in the midst of the way: y'' = mu ((1 - y^2) y' - y), in the time of the slow parts.
TEST(Implicit, RelaxationOscillation) {
    test::Builder b;
    const GiNaC::symbol mu = b.parameter("mu"), y = b.state("y"), z = b.state("y'");
    const FirstOrderSystem system = b.build({z, mu * ((1 - pow(y, 2)) * z - y)});
    const std::vector<Dd> times = even_grid(3, 1000), start{Dd(2), Dd(0)};
    const auto fine = run_implicit<Dd>(system, {Dd(1e6)}, start, times, 1e-28);
    const auto coarse = run_implicit<Dd>(system, {Dd(1e6)}, start, times, 1e-22);
    ASSERT_EQ(fine.failure, "");
    ASSERT_EQ(coarse.failure, "");
    EXPECT_LT(difference(fine, coarse, 0), 1e-12);
}

TEST(Implicit, StartsAtZeroAndKeepsPolynomials) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), y = b.state("y"), rest = b.state("rest");
    const auto run = run_implicit<double>(b.build({GiNaC::ex(1), 3 * pow(x, 2), -rest}), {}, {0.0, 0.0, 0.0},
                                          {0.0, 1.0, 10.0}, 1e-13);
    ASSERT_EQ(run.failure, "");
    EXPECT_NEAR(run.values[0][2], 10.0, 1e-13);
    EXPECT_NEAR(run.values[1][2], 1000.0, 1e-10);
    EXPECT_EQ(run.values[2][2], 0);
    EXPECT_EQ(run_implicit<double>(decay(), {2.0}, {3.0}, {0.0, 0.0}, 1e-13).values[0],
              (std::vector<double>{3, 3}));
}

TEST(Implicit, FailuresAreToldApart) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x");
    const auto blown = run_implicit<double>(b.build({pow(x, 2)}), {}, {1.0}, {0.5, 2.0}, 1e-13); // 1/(1 - t)
    EXPECT_NEAR(blown.values[0][0], 2.0, 1e-12);
    EXPECT_EQ(blown.failure.substr(0, 19), "the steps shrink to") << blown.failure;
    EXPECT_FALSE(blown.too_far);
    test::Builder c;
    const GiNaC::symbol z = c.state("z");
    EXPECT_EQ(run_implicit<double>(c.build({-sqrt(z)}), {}, {-1.0}, {1.0}, 1e-13).failure,
              "the solution leaves the domain of the equations near t = 0");
    const auto far =
        integrate_implicit<double>(Tape::rates(unit_oscillator()), {}, 1, {1, 0}, {1e9}, 1e-13, 10000);
    EXPECT_TRUE(far.too_far);
    EXPECT_EQ(far.steps, 3000U);
    EXPECT_EQ(far.failure.substr(0, 43), "it takes more than 10000 implicit steps: th") << far.failure;
}

// Of every function, at a point where two states enter.
TEST(TapeJacobian, IsTheDerivative) {
    for (const test::FunctionCase& c : test::function_cases()) {
        test::Builder b;
        const GiNaC::symbol k = b.parameter("k"), u = b.state("u"), w = b.state("w");
        const std::vector<GiNaC::ex> rates{c.make(u), k * w * c.make(u - w)};
        TapeJacobian jacobian(Tape::rates(b.build(rates)), {3.0}, 0.0);
        const std::vector<double> state{0.5, 0.2};
        std::vector<double> matrix(4);
        jacobian.evaluate(state.data(), matrix.data());
        const auto exact = [&](const GiNaC::ex& rate, const GiNaC::symbol& by) {
            const GiNaC::ex value = rate.diff(by).subs(GiNaC::lst{u == 0.5, w == 0.2, k == 3});
            return GiNaC::ex_to<GiNaC::numeric>(value.evalf()).to_double();
        };
        const std::vector<double> expected{exact(rates[0], u), exact(rates[0], w), exact(rates[1], u),
                                           exact(rates[1], w)};
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(matrix[i], expected[i], 1e-13 * std::max(1.0, std::abs(expected[i])))
                << c.name << ", entry " << i;
    }
}

} // namespace
} // namespace resonform
