// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled equations against interpreted ones: rates, Taylor coefficients, and the integrators that use them.
#include "verify/function_cases.hpp"
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/first_order.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/tape_code.hpp"
#include "verify/integrate/tape_jacobian.hpp"
#include "verify/integrate/taylor_jet.hpp"
#include "verify/scene_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace resonform {
namespace {

CompiledTape compiled(const Tape& tape, const std::vector<double>& parameters, double eps) {
    return {tape, parameters, eps, test::options().cache, [] {}};
}

std::unique_ptr<Integrator> made(Method method, const CompiledTape& code, const Start& from) {
    return method == Method::taylor ? make_taylor(code, from) : make_integrator(method, code.rates(), from);
}

// u = 0.3 + t is a polynomial in t, v is none; each case is a rate of both, so that its jet is needed.
FirstOrderSystem every_function() {
    test::Builder b;
    const GiNaC::symbol u = b.state("u"), v = b.state("v");
    std::vector<GiNaC::ex> rates{GiNaC::ex(1), cos(v) + b.eps() * v};
    for (const test::FunctionCase& c : test::function_cases())
        for (const GiNaC::ex& at : {GiNaC::ex(u), GiNaC::ex(v), u * u * v / 2}) {
            b.state("w" + std::to_string(rates.size()));
            rates.push_back(c.make(at));
        }
    return b.build(rates);
}

TEST(CompiledTape, JetsAreThoseOfTheInterpreter) {
    const Tape tape = Tape::rates(every_function());
    const CompiledTape code = compiled(tape, {}, 0.25);
    std::vector<double> state(static_cast<std::size_t>(tape.state_count()), 0.0);
    state[0] = 0.3;
    state[1] = 0.35;
    for (const int order : {2, 7, highest_jet_order}) {
        TaylorJet<double> expected(BoundTape<double>(tape, {}, 0.25), order);
        expected.expand(state);
        std::vector<double> rows = code.rows();
        for (int repeated = 0; repeated < 2; ++repeated) { // nothing is left over from the time before
            for (std::size_t i = 0; i < state.size(); ++i) rows[i * jet_stride + jet_pad] = state[i];
            code.expand(order, rows.data());
        }
        for (std::size_t i = 0; i < state.size(); ++i) {
            const double* c = rows.data() + i * jet_stride + jet_pad;
            for (int n = 0; n <= order; ++n) {
                const double wanted = expected.coefficients(static_cast<int>(i))[n];
                EXPECT_NEAR(c[n], wanted, 1e-11 * (1 + std::abs(wanted))) << "state " << i << ", order " << n;
            }
        }
    }
}

TEST(CompiledTape, RatesAreThoseOfTheInterpreter) {
    const Tape tape = Tape::rates(test::almost_holonomic_pendulum());
    BoundTape<double> interpreted(tape, {9.81, 0.7, 1.3}, 0.01);
    const CompiledTape code = compiled(tape, {9.81, 0.7, 1.3}, 0.01);
    const std::vector<double> state{0.1, -0.2, 1.0, 2.0, 0.4};
    std::vector<double> expected(5), rates(5);
    interpreted.evaluate(state.data(), expected.data());
    const RightHandSide f = code.rates();
    f.call(f.context, state.data(), rates.data());
    for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(rates[i], expected[i]);
}

// The compiled Jacobian is that which implicit references are made with.
TEST(CompiledTape, JacobianIsThatOfTheInterpreter) {
    test::Builder b;
    const GiNaC::symbol k = b.parameter("k"), x = b.state("x"), y = b.state("y"), z = b.state("z");
    const Tape tape =
        Tape::rates(b.build({sin(x * y) / (1 + z * z) + tanh(x) - tan(z / 3), pow(x, 3) * sqrt(y + 2) - k,
                             exp(-k * z) * sinh(x) + log(2 + y * y) + atan(z)}));
    const CompiledTape code = compiled(tape, {0.7}, 0.1);
    const std::vector<double> state{0.3, 1.2, -0.4};
    std::vector<double> columns(9), rows(9);
    const RightHandSide rates = code.rates();
    rates.jacobian(rates.context, state.data(), columns.data());
    TapeJacobian(tape, {0.7}, 0.1).evaluate(state.data(), rows.data());
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(columns[k * 3 + i], rows[i * 3 + k], 1e-14) << i << ' ' << k;
    EXPECT_EQ(columns[2 * 3 + 1], 0); // of y' by z
}

// Steps of implicit methods do not shrink with the fast rate; those of explicit ones do, and are given up
// early.
TEST(CompiledTape, ImplicitMethodsPassOverALayer) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), y = b.state("y");
    const CompiledTape code =
        compiled(Tape::rates(b.build({-x, -GiNaC::ex(10000000000) * (y - x)})), {}, 1.0);
    std::vector<std::vector<double>> values(2, std::vector<double>(1));
    for (const Method method : {Method::cvode_bdf, Method::arkode_implicit}) {
        const resonform::Run run = made(method, code, {{1, 0}, 1e-8, {0, 1}})->run({1}, values);
        EXPECT_EQ(run.failure, "") << to_string(method);
        EXPECT_LT(run.steps, 2000U) << to_string(method);
        EXPECT_NEAR(values[0][0], std::exp(-1.0), 1e-6) << to_string(method);
        EXPECT_NEAR(values[1][0], std::exp(-1.0), 1e-6) << to_string(method);
    }
    for (const Method method :
         {Method::arkode_explicit, Method::dopri5, Method::fehlberg78, Method::taylor}) {
        const resonform::Run run = made(method, code, {{1, 0}, 1e-8, {0, 1}})->run({1}, values);
        EXPECT_EQ(run.failure, "more than 10000000 steps") << to_string(method);
        EXPECT_LE(run.steps, 20000U) << to_string(method);
    }
}

// Every method keeps the wanted states only, in the order asked for, and a second run is like the first.
TEST(CompiledTape, IntegratorsRunAgainAndKeepWhatIsWanted) {
    const Tape tape = Tape::rates(test::almost_holonomic_pendulum());
    const double eps = 0.05;
    const std::vector<double> start{eps, 0.0, 1.0, 2.0, 0.0};
    std::vector<double> times;
    for (int i = 0; i <= 50; ++i) times.push_back(i / (50 * eps));
    const auto reference = integrate_taylor<double>(tape, {1, 1, 1}, eps, start, times, 1e-16);
    const CompiledTape code = compiled(tape, {1, 1, 1}, eps);
    for (const Method method :
         {Method::taylor, Method::cvode_adams, Method::cvode_bdf, Method::arkode_explicit,
          Method::arkode_implicit, Method::dopri5, Method::fehlberg78, Method::bulirsch_stoer}) {
        const Start from{start, 1e-11, {3, 0}};
        const bool rough = method == Method::arkode_explicit || method == Method::arkode_implicit;
        const double allowed = rough ? 2e-7 : 1e-8; // dense output of a lower order than steps
        const auto integrator = made(method, code, from);
        std::vector<std::vector<double>> first(2, std::vector<double>(times.size())), second = first;
        const auto run = integrator->run(times, first), again = integrator->run(times, second);
        ASSERT_EQ(run.failure, "") << to_string(method);
        EXPECT_EQ(run.steps, again.steps) << to_string(method);
        EXPECT_EQ(first, second) << to_string(method);
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < times.size(); ++i)
                EXPECT_NEAR(first[k][i], reference.values[from.wanted[k]][i], allowed)
                    << to_string(method) << ", wanted " << k;
    }
}

TEST(CompiledTape, TaylorErrorsFollowTheTolerance) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x"), p = b.state("x'");
    const CompiledTape code = compiled(Tape::rates(b.build({p, -x})), {}, 1.0);
    for (const double tolerance : {1e-4, 1e-8, 1e-13}) {
        std::vector<std::vector<double>> values(1, std::vector<double>(1));
        EXPECT_EQ(make_taylor(code, {{1, 0}, tolerance, {0}})->run({30}, values).failure, "");
        EXPECT_NEAR(values[0][0], std::cos(30.0), 30 * tolerance + 1e-13);
    }
}

TEST(CompiledTape, TaylorStopsWhereTheSolutionEnds) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x");
    const CompiledTape grows = compiled(Tape::rates(b.build({pow(x, 2)})), {}, 1.0); // 1/(1 - t)
    std::vector<std::vector<double>> values(1, std::vector<double>(2));
    EXPECT_NE(make_taylor(grows, {{1}, 1e-12, {0}})->run({0.5, 2}, values).failure, "");
    EXPECT_NEAR(values[0][0], 2, 1e-10);
    const CompiledTape leaves = compiled(Tape::rates(b.build({-sqrt(x)})), {}, 1.0);
    EXPECT_EQ(make_taylor(leaves, {{-1}, 1e-12, {0}})->run({0.5, 2}, values).failure,
              "the steps end near t = 0");
}

} // namespace
} // namespace resonform
