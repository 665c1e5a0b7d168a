// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted code against the interpreter, the interpreter against the printed formulas, and the statuses
// of both outside their domain.
#include "runtime/math.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"

#include "model/files/read_scene.hpp"
#include "support/program.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace resonform {

namespace {

using Fifty = boost::multiprecision::cpp_bin_float_50;

// The third-order scene with its parameters left open and all states kept, compiled once.
class ThirdOrder : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        program_ = test::program_of(test::pendulum_scene("third_order"), {false, true});
        library_ = EvaluatorLibrary::build(
            *program_, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache", {}, "dlq");
    }
    static void TearDownTestSuite() {
        program_.reset();
        library_.reset();
    }

    template <class Real> static void expect_agreement() {
        std::mt19937_64 generator(7);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int sample = 0; sample < 5; ++sample) {
            const Real eps = Real(0.2 * unit(generator));
            const std::vector<Real> parameters{Real(0.5 + unit(generator)), Real(0.5 + unit(generator)),
                                               Real(unit(generator) - 0.5)};
            const std::vector<Real> start{Real(2 * unit(generator) - 1), Real(unit(generator)),
                                          Real(unit(generator)), Real(unit(generator)),
                                          Real(unit(generator))};
            const Interpreter<Real> interpreter(program_, eps, parameters, start, Real(1));
            const Evaluator<Real> emitted(library_, eps, parameters, start, Real(1));
            for (int point = 0; point < 20; ++point) {
                const Real t = Real(unit(generator)) / eps;
                std::vector<Real> expected, scale, found(3), states(4), expected_states;
                ASSERT_EQ(interpreter.call(t, expected), Status::ok);
                ASSERT_EQ(interpreter.scale(t, scale), Status::ok);
                ASSERT_EQ(emitted.call(t, found.data()), Status::ok);
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_LT(static_cast<double>(math::magnitude(Real(found[k] - expected[k])) /
                                                  (scale[k] * math::epsilon<Real>())),
                              8)
                        << program_->outputs[k].name;
                ASSERT_EQ(interpreter.state(t, expected_states), Status::ok);
                ASSERT_EQ(emitted.state(t, states.data()), Status::ok);
                for (std::size_t k = 0; k < 4; ++k)
                    EXPECT_LT(static_cast<double>(math::magnitude(Real(states[k] - expected_states[k])) /
                                                  math::epsilon<Real>()),
                              64)
                        << program_->state[k].name;
            }
        }
    }

    static std::shared_ptr<const Program> program_;
    static std::shared_ptr<const EvaluatorLibrary> library_;
};
using SlowThirdOrder = ThirdOrder;
std::shared_ptr<const Program> ThirdOrder::program_;
std::shared_ptr<const EvaluatorLibrary> ThirdOrder::library_;

} // namespace

TEST_F(ThirdOrder, EmittedEqualsInterpretedInDouble) { expect_agreement<double>(); }
TEST_F(SlowThirdOrder, EmittedEqualsInterpretedInLongDouble) { expect_agreement<long double>(); }
TEST_F(ThirdOrder, EmittedEqualsInterpretedInFloat128) { expect_agreement<Float128>(); }

TEST_F(ThirdOrder, OutsideItsDomainItAnswersWithAStatus) {
    const std::vector<double> parameters{1, 1, 1}, start{0, 1, 0, 1, 1};
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const auto both = [&](double eps, std::vector<double> p, double t) {
        std::vector<double> values(3);
        const Status emitted = Evaluator<double>(library_, eps, p, start, 1.0).call(t, values.data());
        std::vector<double> interpreted;
        EXPECT_EQ(Interpreter<double>(program_, eps, p, start, 1.0).call(t, interpreted), emitted);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(std::isnan(values[k]), emitted != Status::ok);
            EXPECT_EQ(std::isnan(interpreted[k]), emitted != Status::ok);
        }
        return emitted;
    };
    EXPECT_EQ(both(0.1, parameters, 0), Status::ok);
    EXPECT_EQ(both(0.1, parameters, 10), Status::ok);
    EXPECT_EQ(both(1e-3, parameters, 1 / 1e-3), Status::ok);
    EXPECT_EQ(both(0.1, parameters, 10.1), Status::outside_interval);
    EXPECT_EQ(both(0.1, parameters, -0.1), Status::outside_interval);
    EXPECT_EQ(both(0.1, parameters, nan), Status::bad_argument);
    EXPECT_EQ(both(0.1, parameters, inf), Status::bad_argument);
    for (const double eps : {0.0, -0.1, nan, inf})
        EXPECT_EQ(both(eps, parameters, 1), Status::bad_argument) << eps;
    EXPECT_EQ(both(0.1, {nan, 1, 1}, 1), Status::bad_argument);
    EXPECT_EQ(both(0.1, {-1, 1, 1}, 1), Status::outside_domain); // g is declared positive
    EXPECT_EQ(both(0.1, {1, 0, 1}, 1), Status::outside_domain);  // so is r
}

// The motion leaves 2 - tau > 0 at T = 1, and the interval ends at T = 3: the table of the phase ends
// between.
TEST(DomainLeft, AnswersUpToThePlaceAndAStatusBeyond) {
    const std::filesystem::path system = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache/bounded";
    std::filesystem::create_directories(system / "scenes");
    std::ofstream(system / "system.toml")
        << "[system]\nname = \"bounded\"\n[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
           "[domain]\npositive = [\"2 - tau\"]\n"
           "[equations]\nx = \"x'' + x + x^3/(2 - tau) = 0\"\ntau = \"tau' = eps\"\n";
    std::ofstream(system / "scenes/s.toml")
        << "order = 2\n[start]\ntau = 1\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = \"3/eps\"\n";
    const auto program = test::program_of(read_scene(system / "scenes/s.toml", system.parent_path()));
    const auto library = EvaluatorLibrary::build(*program, system.parent_path(), {});
    const double eps = 0.1;
    const Interpreter<double> interpreter(program, eps, {}, {}, 3);
    const Evaluator<double> emitted(library, eps, {}, default_start<double>(*program, eps, {}), 3);
    for (const auto& [t, status] :
         {std::pair(0.0, Status::ok), std::pair(9.9, Status::ok), std::pair(10.01, Status::outside_domain),
          std::pair(29.0, Status::outside_domain), std::pair(30.1, Status::outside_interval)}) {
        std::vector<double> expected, found(1);
        EXPECT_EQ(interpreter.call(t, expected), status) << t;
        EXPECT_EQ(emitted.call(t, found.data()), status) << t;
        if (status == Status::ok) {
            EXPECT_NEAR(found[0], expected[0], 1e-13 * std::abs(expected[0])) << t;
        }
    }
}

TEST_F(ThirdOrder, BatchesEqualCalls) {
    const Evaluator<double> emitted(library_, 0.1, {1, 1, 1}, {0, 1, 0, 1, 1}, 1.0);
    const std::vector<double> t{0.0, 1.5, 11.0, 10.0};
    std::vector<std::vector<double>> columns(3, std::vector<double>(t.size()));
    std::vector<unsigned char> status(t.size());
    emitted.batch(t, {columns[0].data(), columns[1].data(), columns[2].data()}, status);
    for (std::size_t i = 0; i < t.size(); ++i) {
        std::vector<double> values(3);
        EXPECT_EQ(static_cast<Status>(status[i]), emitted.call(t[i], values.data()));
        for (std::size_t k = 0; k < 3; ++k) {
            if (t[i] <= 10)
                EXPECT_EQ(columns[k][i], values[k]);
            else
                EXPECT_TRUE(std::isnan(columns[k][i]));
        }
    }
}

// Physical start values become constants of the solution through the inverse map at its full weight 4:
// the solution at t = 0 gives them back up to O(eps^5).
TEST(Interpreter, PhysicalStartValuesComeBackAtTheStart) {
    Scene scene = test::pendulum_scene("third_order");
    const GiNaC::symbol& eps_symbol = scene.system->eps;
    scene.start = {{"xi", GiNaC::numeric(1, 4), "1/4", {}},
                   {"psi", GiNaC::numeric(3, 10) * eps_symbol, "3/10*eps", {}},
                   {"psi'", GiNaC::numeric(1, 7) * eps_symbol, "eps/7", {}},
                   {"x", GiNaC::numeric(1, 2), "1/2", {}},
                   {"C_Y", GiNaC::numeric(2), "2", {}}};
    const auto program = test::program_of(scene, {true, true});
    double error[2] = {0, 0};
    for (int k = 0; k < 2; ++k) {
        const Fifty eps = k == 0 ? Fifty(1) / 1000 : Fifty(1) / 2000;
        std::vector<Fifty> state;
        ASSERT_EQ(Interpreter<Fifty>(program, eps, {}, {}, Fifty(1)).state(0, state), Status::ok);
        ASSERT_EQ(program->state[0].name, "psi");
        ASSERT_EQ(program->state[2].name, "x");
        const Fifty psi = abs(state[0] - 3 * eps / 10), rate = abs(state[1] - eps / 7),
                    x = abs(state[2] - Fifty(1) / 2);
        error[k] = static_cast<double>(psi + rate + x);
    }
    EXPECT_LT(error[0], 1e-13);
    EXPECT_GT(error[0], 0);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 5, 0.1);
}

// (22) and (23) with the values (24), in 50 digits; the quadratures of the paper by another route: as
// theta' and the integrand of x are elementary here only numerically, the trapezoidal rule in tanh-sinh
// form on [0, T] serves.
TEST(Interpreter, AsPublishedIsEquations22And23) {
    const auto program = test::program_of(test::pendulum_scene("as_published"));
    const Fifty eps = Fifty(1) / 10, t = 7, xi = eps * t, s = xi * xi + 1;
    const auto integral = [](const Fifty& to, const auto& f) {
        Fifty sum(0);
        const Fifty step = Fifty(1) / 32, half_pi = boost::math::constants::half_pi<Fifty>();
        for (int k = -160; k <= 160; ++k) {
            const Fifty u = step * k, v = half_pi * sinh(u), c = cosh(v);
            const Fifty x = to / 2 * (1 + tanh(v)), weight = to / 2 * half_pi * cosh(u) / (c * c);
            sum += step * weight * f(x);
        }
        return sum;
    };
    const Fifty theta = integral(xi,
                                 [&](const Fifty& z) {
                                     const Fifty w = z * z + 1;
                                     return Fifty(pow(w, Fifty(-1) / 4) - eps * eps / (16 * sqrt(w)) -
                                                  eps * eps * z * z / (32 * pow(w, Fifty(7) / 4)));
                                 }) /
                        eps;
    const Fifty q = integral(xi, [](const Fifty& z) {
        const Fifty w = z * z + 1;
        return Fifty(z * z / (w * w) + 1 / (4 * pow(w, Fifty(3) / 4)));
    });
    const Fifty c = cos(theta), d = sin(theta), e2 = eps * eps, p58 = pow(s, Fifty(5) / 8),
                p34 = pow(s, Fifty(3) / 4);
    const Fifty front = e2 / pow(s, Fifty(3) / 8);
    const Fifty psi = eps * c / pow(s, Fifty(1) / 8) + e2 * xi * (8 + d * p58) / (8 * pow(s, Fifty(3) / 2)) +
                      e2 * eps * c * (pow(s, Fifty(5) / 4) * (5 + 4 * d * d) + 6 * (2 - xi * xi)) /
                          (192 * pow(s, Fifty(13) / 8));
    const Fifty x =
        1 + log(xi + sqrt(s)) - e2 * q - front * (xi * d + eps * c * (8 + xi * xi + 2 * d * p58) / (8 * p34));
    const Fifty y = 1 + sqrt(s) - e2 / 2 * (1 / s + pow(s, Fifty(1) / 4)) +
                    front * (d - eps * xi * c * (7 + 2 * d * p58) / (8 * p34));

    std::vector<Fifty> found;
    ASSERT_EQ(Interpreter<Fifty>(program, eps, {}, {}, Fifty(1)).call(t, found), Status::ok);
    const std::vector<Fifty> expected{psi, x, y};
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LT(static_cast<double>(abs(found[k] - expected[k])), 1e-45) << program->outputs[k].name;
}

} // namespace resonform
