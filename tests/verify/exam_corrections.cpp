// SPDX-License-Identifier: GPL-3.0-or-later
// Along the motion the near-identity map stays near the identity: evaluators end where amplitudes have grown
// beyond it, interpreted and emitted, in what they are held against as well.
#include "emit/program/build_program.hpp"
#include "own_system.hpp"
#include "support/program.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/symbolic/evaluator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace resonform {
namespace {

class MapAlong : public test::OwnSystem {
protected:
    void read(const std::string& system, const std::string& scene) {
        scene_ = written(system, scene);
        solution_ = test::solution_of(scene_);
        program_ = std::make_shared<const Program>(build_program(solution_, scene_));
    }
    [[nodiscard]] const Program& program() const { return *program_; }

    // The first output at t, or NaN where the status is outside_domain and `why` says so.
    std::vector<double> at(const std::vector<double>& times, double eps, double end, const std::string& why) {
        const Evaluator<double> emitted(
            EvaluatorLibrary::build(*program_, std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache",
                                    [](const std::string&) {}),
            eps, {}, default_start<double>(*program_, eps, {}), end);
        return at(times, eps, end, why, [&](double t, Status status) {
            std::vector<double> values(program_->outputs.size());
            EXPECT_EQ(emitted.call(t, values.data()), status) << t;
        });
    }

    // The same where emitted code is not compiled, but `check` called with each time and its status.
    template <class Check>
    std::vector<double> at(const std::vector<double>& times, double eps, double end, const std::string& why,
                           const Check& check) {
        const std::vector<double> start = default_start<double>(*program_, eps, {});
        const Interpreter<double> interpreter(program_, eps, {}, start, end);
        const SymbolicEvaluator exact(std::make_shared<const SymbolicSolution>(solution_, scene_),
                                      test::symbolic_inputs(*program_, eps, start, end), Wide(end));
        std::vector<double> found;
        for (const double t : times) {
            std::vector<double> values(program_->outputs.size());
            const Status status = interpreter.call(t, values);
            check(t, status);
            EXPECT_EQ(exact(Wide(t)).status, status) << t;
            if (status == Status::outside_domain) {
                EXPECT_EQ(interpreter.why(status), why) << t;
            } else {
                EXPECT_TRUE(status == Status::ok || status == Status::low_precision) << t;
            }
            found.push_back(status == Status::outside_domain ? NAN : values[0]);
        }
        return found;
    }

private:
    Scene scene_;
    Solution solution_;
    std::shared_ptr<const Program> program_;
};

const std::string from_eps = "[start]\nx = \"eps\"\n\"x'\" = 0\n";
std::string oscillator(const std::string& equation) {
    return "[variables]\nx = { role = \"fast\" }\n[equations]\nx = \"" + equation + " = 0\"\n";
}
std::string beside_slow(const std::string& equation) {
    return "[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n[domain]\n"
           "positive = [\"1 + tau\"]\n[equations]\nx = \"" +
           equation + " = 0\"\ntau = \"tau' = eps\"\n";
}

// x(t) of x'' = rate(t, x, x') by Runge and Kutta.
template <class Rate> double integrated(const Rate& rate, double x, double t) {
    const int steps = static_cast<int>(100 * t);
    const double h = t / steps;
    std::array<double, 2> y{x, 0};
    for (int n = 0; n < steps; ++n) {
        const auto slope = [&](double ahead, const std::array<double, 2>& by) {
            const double p = y[0] + ahead * by[0], q = y[1] + ahead * by[1];
            return std::array<double, 2>{q, rate(n * h + ahead, p, q)};
        };
        const auto a = slope(0, {}), b = slope(h / 2, a), c = slope(h / 2, b), d = slope(h, c);
        for (const std::size_t k : {0U, 1U}) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return y[0];
}

using SlowMapAlong = MapAlong; // minutes under sanitizers

// 1.5e6 came out at t = 1000, where the motion has an amplitude of 21.
TEST_F(MapAlong, AClosedAmplitudeThatGrows) {
    read(oscillator("x'' - 2*eps*x' + x + x^3"), "order = 3\n" + from_eps);
    ASSERT_TRUE(program().flow.empty());
    const double eps = 0.01;
    const auto rate = [&](double, double x, double v) { return 2 * eps * v - x - x * x * x; };
    const std::vector<double> x = at({0, 100, 200, 300, 400, 480, 490, 1000, 2000}, eps, 20.5, "x");
    EXPECT_NEAR(x[1], integrated(rate, eps, 100), 1e-6);
    EXPECT_NEAR(x[2], integrated(rate, eps, 200), 1e-4);
    EXPECT_NEAR(x[3], integrated(rate, eps, 300), 2e-3);
    EXPECT_NEAR(x[4], integrated(rate, eps, 400), 0.05);
    EXPECT_LT(std::abs(x[5]), 1.4);
    for (const std::size_t k : {6U, 7U, 8U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

// x x x' drives it to infinity at t = 4/eps^2; -12 came out there.
TEST_F(SlowMapAlong, AFlowThatComesNearItsSingularity) {
    read(oscillator("x'' + x - x^2*x'"), "order = 2\ntime_scale = 2\n" + from_eps);
    ASSERT_FALSE(program().flow.empty());
    const double eps = 0.02;
    const auto rate = [](double, double x, double v) { return x * x * v - x; };
    const std::vector<double> x = at({0, 1000, 5000, 9950, 9999.975, 11000}, eps, 240, "x");
    EXPECT_NEAR(x[1], integrated(rate, eps, 1000), 1e-5);
    EXPECT_NEAR(x[2], integrated(rate, eps, 5000), 1e-5);
    EXPECT_NEAR(x[3], integrated(rate, eps, 9950), 4e-3);
    for (const std::size_t k : {4U, 5U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

// 0.02 (1 + tau)^3 = 2 (1 + |a|) at tau = 4.85, with |a| = 1.
TEST_F(MapAlong, AForcedMotionThatGrows) {
    read(beside_slow("x'' + x + x^3 - eps^2*(1 + tau)^3"), "order = 2\n" + from_eps + "tau = 0\n");
    const double eps = 0.02;
    const auto rate = [&](double t, double x, double) {
        return eps * eps * std::pow(1 + eps * t, 3) - x - x * x * x;
    };
    const std::vector<double> x = at({0, 100, 240, 245, 300}, eps, 8, "x");
    EXPECT_NEAR(x[1], integrated(rate, eps, 100), 5e-5);
    EXPECT_NEAR(x[2], integrated(rate, eps, 240), 1e-2);
    for (const std::size_t k : {3U, 4U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

TEST_F(MapAlong, AGrowingAmplitudeWithAFrequencyThatMoves) {
    read(beside_slow("x'' - 2*eps*x' + (1 + tau)*x + x^3"), "order = 2\n" + from_eps + "tau = 0\n");
    const double eps = 0.01;
    const auto rate = [&](double t, double x, double v) {
        return 2 * eps * v - (1 + eps * t) * x - x * x * x;
    };
    const std::vector<double> x = at({0, 100, 300, 1200, 2000}, eps, 20.5, "x");
    EXPECT_NEAR(x[1], integrated(rate, eps, 100), 2e-4);
    EXPECT_NEAR(x[2], integrated(rate, eps, 300), 2e-2);
    for (const std::size_t k : {3U, 4U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

// The amplitude is e to an integral that has no closed form: what depends on it is looked at in every call,
// but that it has not been gone for long is looked at before, from its rate.
TEST_F(SlowMapAlong, AnAmplitudeThatIsAQuadrature) {
    read(beside_slow("x'' - 2*eps*tau^2/(1 + tau^2)*x' + x + x^3"), "order = 2\n" + from_eps + "tau = 0\n");
    ASSERT_FALSE(program().tables.empty());
    ASSERT_EQ(program().layers.size(), 1U);
    EXPECT_EQ(program().layers.front().quantity.substr(0, 4), "exp(");
    const std::vector<double> x = at({0, 300, 900, 1500}, 0.01, 20.5, "x or 1 + tau");
    EXPECT_LT(std::abs(x[1]), 0.1);
    for (const std::size_t k : {2U, 3U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

// The square of x that drives y outgrows both.
TEST_F(SlowMapAlong, TwoModesOfWhichOneGrows) {
    read("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
         "x = \"x'' - 2*eps*x' + x + x*y = 0\"\ny = \"y'' + 2*y + 3*x^2 = 0\"\n",
         "order = 2\n" + from_eps + "y = 0\n\"y'\" = 0\n");
    const std::vector<double> x = at({0, 100, 200, 600, 1000}, 0.01, 10.5, "y");
    EXPECT_LT(std::abs(x[2]), 0.1);
    for (const std::size_t k : {3U, 4U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

// Nothing is sampled where nothing moves.
TEST_F(SlowMapAlong, AConstantAmplitudeHasNoLayer) {
    read(oscillator("x'' + x + x^3"), "order = 3\n" + from_eps);
    EXPECT_TRUE(program().layers.empty());
    read("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
         "x = \"x'' + x + x*y = 0\"\ny = \"y'' + 2*y + x^2 = 0\"\n",
         "order = 2\n" + from_eps + "y = 0\n\"y'\" = 0\n");
    EXPECT_TRUE(program().layers.empty());
    for (const double x : at({0, 50, 100}, 0.01, 1.5, "")) EXPECT_LT(std::abs(x), 0.02);
}

// An oscillator at rest stays there; finite ones are as large as they like while eps is small.
TEST_F(SlowMapAlong, AmplitudesThatAreNotTooLarge) {
    read("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
         "x = \"x'' - 2*eps*x' + x + x*y = 0\"\ny = \"y'' + 2*y + x^2 = 0\"\n",
         "order = 2\n[start]\nx = 0\n\"x'\" = 0\ny = 0\n\"y'\" = 0\n");
    for (const double x : at({0, 50, 1000}, 0.01, 10.5, "")) EXPECT_EQ(x, 0);
    read("[variables]\nx = { role = \"fast\", weight = 0 }\n[equations]\n"
         "x = \"x'' + x = eps*(1 - x^2)*x'\"\n",
         "order = 1\n[start]\nx = 3\n\"x'\" = 0\n");
    for (const double x : at({0, 50, 100}, 0.1, 10.5, "")) EXPECT_FALSE(std::isnan(x));
}

// s = s(0) + eps sin t turns negative, though its mean does not; -0.0026 came out at t = 4.
TEST_F(MapAlong, ASlowVariableThatOscillatesOutOfItsDomain) {
    const std::string system = "[variables]\nphi = { role = \"angle\" }\n"
                               "s = { role = \"slow\", positive = true }\nz = { role = \"drift\" }\n"
                               "[equations]\nphi = \"phi' = 1\"\ns = \"s' = eps*cos(phi)\"\n"
                               "z = \"z' = eps*sqrt(s)\"\n";
    const auto from = [](const std::string& s) {
        return "order = 2\noutputs = [\"s\"]\n[start]\nphi = 0\ns = \"" + s + "\"\nz = 0\n";
    };
    read(system, from("eps/2"));
    for (const double s : at({0, 1, 4, 50}, 0.01, 1, "s")) EXPECT_TRUE(std::isnan(s)) << s;
    read(system, from("3*eps"));
    const std::vector<double> s = at({0, 1, 4, 50}, 0.01, 1, "");
    for (const std::size_t k : {0U, 1U, 2U, 3U})
        EXPECT_NEAR(s[k], 0.03 + 0.01 * std::sin(std::array{0., 1., 4., 50.}[k]), 1e-15);
}

// The same with a sign that is kept, and in a declaration that holds more than the variable.
TEST_F(SlowMapAlong, ADeclaredQuantityThatIsLeft) {
    const std::string equations = "[equations]\nphi = \"phi' = 1\"\ns = \"s' = eps*sin(phi)\"\n"
                                  "z = \"z' = eps/";
    const auto scene = [](const std::string& s) {
        return "order = 2\noutputs = [\"z\"]\n[start]\nphi = 0\ns = \"" + s + "\"\nz = 0\n";
    };
    const std::string variables = "[variables]\nphi = { role = \"angle\" }\nz = { role = \"drift\" }\ns = ";
    read(variables + "{ role = \"slow\", nonzero = true }\n" + equations + "s\"\n", scene("-eps/2"));
    EXPECT_TRUE(std::isnan(at({3}, 0.01, 1, "s")[0]));
    read(variables + "{ role = \"slow\", nonzero = true }\n" + equations + "s\"\n", scene("-8*eps"));
    EXPECT_FALSE(std::isnan(at({3}, 0.01, 1, "")[0]));
    read(variables + "{ role = \"slow\" }\n[domain]\npositive = [\"1 - s\"]\n" + equations + "(1 - s)\"\n",
         scene("1 - eps/2"));
    EXPECT_TRUE(std::isnan(at({3}, 0.01, 1, "-s + 1")[0]));
}

// 1 + s is the square of a frequency, and x x' moves s by what grows; -97 came out at t = 1000.
TEST_F(MapAlong, ASlowVariableThatAGrowingModeMoves) {
    read("[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n[domain]\npositive = [\"1 + s\"]\n"
         "[equations]\nx = \"x'' - 2*eps*x' + (1 + s)*x = 0\"\ns = \"s' = -eps*s + x*x'\"\n",
         "order = 2\noutputs = [\"x\"]\n" + from_eps + "s = 0\n");
    const std::vector<double> x = at({0, 100, 300, 600, 1000}, 0.01, 10.5, "s + 1");
    EXPECT_LT(std::abs(x[2]), 0.3);
    for (const std::size_t k : {3U, 4U}) EXPECT_TRUE(std::isnan(x[k])) << x[k];
}

// phi' = 1 + eps J cos(phi) stops turning where eps J = 1; its map is eps J sin(phi).
TEST_F(MapAlong, AnAngleThatIsLocked) {
    read("[variables]\nphi = { role = \"angle\" }\nJ = { role = \"slow\" }\nz = { role = \"drift\" }\n"
         "[equations]\nphi = \"phi' = 1 + eps*J*cos(phi)\"\nJ = \"J' = eps*J\"\n"
         "z = \"z' = eps*sin(phi)\"\n",
         "order = 2\noutputs = [\"z\"]\n[start]\nphi = 0\nJ = 1\nz = 0\n");
    const std::vector<double> z = at({0, 200, 380, 400, 800}, 0.01, 8.5, "phi");
    for (const std::size_t k : {0U, 1U, 2U}) EXPECT_FALSE(std::isnan(z[k]));
    for (const std::size_t k : {3U, 4U}) EXPECT_TRUE(std::isnan(z[k])) << z[k];
}

// d/ds of 1 + s^2 is zero at the mean, s = 0, where its second derivative counts; -214 came out at t = 800.
TEST_F(SlowMapAlong, AQuantityWithoutASlopeAtTheMean) {
    read("[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\nz = { role = \"drift\" }\n"
         "[equations]\nx = \"x'' - 2*eps*x' + x = 0\"\ns = \"s' = x'\"\nz = \"z' = eps/(1 + s^2)\"\n",
         "order = 2\noutputs = [\"z\"]\n" + from_eps + "s = \"eps\"\nz = 0\n");
    const std::vector<double> z = at({0, 300, 600, 800}, 0.01, 15, "s^2 + 1");
    EXPECT_NEAR(z[1], 3, 0.05);
    for (const std::size_t k : {2U, 3U}) EXPECT_TRUE(std::isnan(z[k])) << z[k];
}

// x is lighter and dies out, y grows: each counts by itself.
TEST_F(SlowMapAlong, AHeavyModeBesideALightOne) {
    read("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\", weight = 2 }\n"
         "s = { role = \"slow\", positive = true }\nz = { role = \"drift\" }\n"
         "[equations]\nx = \"x'' + 2*eps*x' + x = 0\"\ny = \"y'' - 2*eps*y' + 2*y = 0\"\n"
         "s = \"s' = x' + y'\"\nz = \"z' = eps/s\"\n",
         "order = 2\noutputs = [\"s\"]\n" + from_eps + "y = \"eps^2\"\n\"y'\" = 0\ns = 1\nz = 0\n");
    const std::vector<double> s = at({0, 500, 950, 1200}, 0.01, 15, "s");
    EXPECT_NEAR(s[1], 1, 0.05);
    for (const std::size_t k : {2U, 3U}) EXPECT_TRUE(std::isnan(s[k])) << s[k];
}

// Divisors such as 3 K - 2 J are made by normalisation, at the mean, and ask for nothing. (At order 2 the
// header has 400 kB, which compile in minutes: interpreted only.)
TEST_F(SlowMapAlong, ADivisorOfTheNormalForm) {
    const std::string system = "[variables]\np = { role = \"angle\" }\nq = { role = \"angle\" }\n"
                               "K = { role = \"slow\" }\nJ = { role = \"slow\" }\n[domain]\n"
                               "positive = [\"J - K\"]\n[equations]\np = \"p' = K\"\nq = \"q' = J\"\n"
                               "K = \"K' = eps*(sin(p) + sin(p - q))\"\nJ = \"J' = -eps*sin(p - q)\"\n";
    const std::string rest = "\noutputs = [\"J\"]\n[start]\np = \"1/10\"\nq = \"2/5\"\nK = 1\nJ = \"1.62\"\n";
    const std::vector<double> times{0, 50, 100};
    read(system, "order = 1" + rest);
    for (const double J : at(times, 0.02, 2.5, "")) EXPECT_NEAR(J, 1.62, 0.1);
    read(system, "order = 2" + rest);
    for (const double J : at(times, 0.02, 2.5, "", [](double, Status) {})) EXPECT_NEAR(J, 1.62, 0.1);
}

} // namespace
} // namespace resonform
