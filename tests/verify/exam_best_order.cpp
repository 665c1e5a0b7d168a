// SPDX-License-Identifier: GPL-3.0-or-later
// The suggested order: of sequences whose continuation is known, and of slow manifolds whose errors can be
// written down.
#include "algebra/number/number.hpp"
#include "own_system.hpp"
#include "verify/report/json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

BestOrder best_of_terms(const std::vector<double>& terms) { return best_of(parse_rational("0.1"), terms); }

// z' = -z + eps*f(tau), tau' = v*eps: z = eps sum (-v eps d/dtau)^n f, without the transient; order n ends at
// eps^n. f and all its derivatives are largest where tau ends.
class SlowManifold : public testing::Test, protected test::WrittenSystem {
protected:
    // f = exp(4*tau), tau = -20 ... 0.
    Scene exponential() { return scene("exp(4*tau)", "1", "-20", ""); }
    // tau = 21 ... 1.
    Scene inverse(const std::string& force = "1/tau") {
        return scene(force, "-1", "21", ", positive = true");
    }
    static std::vector<BestOrder> best(const Scene& scene, const Derive& derive = test::derive) {
        return error_estimates(scene, test::solution_of(scene), scene.verify.eps, derive).at("z").best;
    }

private:
    Scene scene(const std::string& force, const std::string& velocity, const std::string& tau,
                const std::string& declared) {
        return written("[variables]\nz = { role = \"fast\" }\ntau = { role = \"slow\"" + declared +
                           " }\n[equations]\nz = \"z' = -z + eps*" + force +
                           "\"\ntau = \"tau' = " + velocity + "*eps\"\n",
                       "order = 5\noutputs = [\"z\"]\ntransients = false\n[start]\nz = 0\ntau = " + tau +
                           "\n[verify]\neps = [0.5, 0.4, 0.3, 0.15, 0.1, 0.05]\ninterval = \"20/eps\"\n");
    }
};

// int_0^inf e^-s/(1 + eps s) ds, of which sum (-1)^n n! eps^n is the series.
double integral_of_euler(double eps) {
    constexpr int intervals = 4000; // of Simpson's rule
    constexpr double end = 40;
    const auto f = [&](double s) { return std::exp(-s) / (1 + eps * s); };
    double sum = f(0) + f(end);
    for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(end * i / intervals);
    return sum * end / (3 * intervals);
}

// |error| at tau = 1 of the orders 1 ... most, of f = 1/tau.
std::vector<double> errors_of_euler(double eps, int most) {
    std::vector<double> errors;
    double sum = 0, term = eps;
    for (int n = 1; n <= most; ++n) {
        sum += term;
        errors.push_back(std::abs(sum - eps * integral_of_euler(eps)));
        term *= -n * eps;
    }
    return errors;
}

// How much less accurate the suggested order is than the best, at the worst eps.
double worst_loss(const std::vector<BestOrder>& best) {
    double worst = 0;
    for (const BestOrder& b : best) {
        const std::vector<double> errors = errors_of_euler(to_double(b.eps), b.looked_at);
        worst = std::max(worst, errors[static_cast<std::size_t>(b.order - 1)] /
                                    *std::min_element(errors.begin(), errors.end()));
    }
    return worst;
}

} // namespace

TEST(BestOrder, OfTermsThatFallIsTheLast) {
    const BestOrder best = best_of_terms({1e-2, 1e-4, 1e-6});
    EXPECT_EQ(best.order, 4);
    EXPECT_EQ(best.looked_at, 4);
    EXPECT_NEAR(best.accuracy, 2e-8, 1e-12) << "twice that of a geometric series";
    EXPECT_EQ(best_of_terms({1e-2}).order, 2);
    EXPECT_NEAR(best_of_terms({1e-2}).accuracy, 1e-3, 1e-9) << "eps, where there is no quotient";
    EXPECT_NEAR(best_of(parse_rational("0.01"), {1e-2}, 2).accuracy, 1e-3, 1e-9) << "the next is sqrt(eps)";
}

TEST(BestOrder, IsWhereTermsBeginToGrow) {
    EXPECT_EQ(best_of_terms({0.1, 0.2, 0.4}).order, 1);
    const BestOrder best = best_of_terms({0.1, 0.01, 0.005, 0.009, 0.1});
    EXPECT_EQ(best.order, 3);
    EXPECT_EQ(best.accuracy, 0.009) << "what order 4 adds counts, too";
}

// x -> -x takes every other term away.
TEST(BestOrder, ASymmetryDoesNotHideAnError) {
    for (const double none : {0.0, 1e-9}) {
        const BestOrder fall = best_of_terms({1e-2, none, 1e-4});
        EXPECT_EQ(fall.order, 4) << none;
        EXPECT_NEAR(fall.accuracy, 1e-6 * 20 / 6, 1e-10) << none;
        const BestOrder grow = best_of_terms({1e-2, none, 1e-1});
        EXPECT_EQ(grow.order, 1) << none;
        EXPECT_EQ(best_of_terms({1e-1, 1e-2, none, 5e-2}).order, 2) << none;
    }
    const BestOrder last = best_of_terms({0, 1e-2, 0});
    EXPECT_EQ(last.order, 3) << "as good as order 4";
    EXPECT_NEAR(last.accuracy, 1e-4, 1e-8);
}

TEST(BestOrder, OfWhatIsNotKnownIsNotSuggested) {
    for (const double unknown : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(best_of_terms({unknown, 1e-2, 1e-3}).order, 4);
        const BestOrder before = best_of_terms({1e-2, 1e-3, unknown});
        EXPECT_EQ(before.order, 2);
        EXPECT_EQ(before.accuracy, 1e-3);
        EXPECT_EQ(best_of_terms({unknown}).order, 0);
        EXPECT_EQ(best_of_terms({0, unknown}).order, 0);
    }
    EXPECT_EQ(best_of_terms({0, 0, 0}).order, 0);
    EXPECT_EQ(best_of_terms({}).order, 0);
}

TEST_F(SlowManifold, OfAGeometricSeriesItIsTheFirstOrTheLast) {
    const std::vector<BestOrder> found = best(exponential());
    ASSERT_EQ(found.size(), 6U);
    for (const BestOrder& b : found) {
        const double eps = to_double(b.eps), quotient = 4 * eps; // z = eps f sum (-4 eps)^n
        EXPECT_EQ(b.looked_at, 6);
        EXPECT_EQ(b.order, quotient > 1 ? 1 : 6) << eps;
        const double error = eps * std::pow(quotient, b.order) / (1 + quotient);
        EXPECT_GT(b.accuracy, error) << eps;
        EXPECT_LT(b.accuracy, 9 * error) << eps;
    }
}

// sum (-1)^n n! (eps/tau)^(n + 1): its terms fall up to n = tau/eps.
TEST_F(SlowManifold, OfAFactorialSeriesItIsAtTheLeastTerm) {
    const std::vector<BestOrder> found = best(inverse());
    ASSERT_EQ(found.size(), 6U);
    EXPECT_LT(worst_loss(found), 1.5);
    for (std::size_t i = 0; i + 1 < found.size(); ++i) EXPECT_LE(found[i].order, found[i + 1].order);
    EXPECT_EQ(found.front().order, 1);
    EXPECT_EQ(found.back().order, 6);
    for (const BestOrder& b : found) {
        const std::vector<double> errors = errors_of_euler(to_double(b.eps), b.looked_at);
        const double ratio = b.accuracy / errors[static_cast<std::size_t>(b.order - 1)];
        EXPECT_GT(ratio, 0.5) << to_double(b.eps);
        EXPECT_LT(ratio, 4) << to_double(b.eps);
    }
}

// A map whose terms do not grow, for each weight is a quarter of what it is: what is suggested is wrong by
// far.
TEST_F(SlowManifold, ALieOfTheSeriesIsCaught) {
    const Scene honest = inverse();
    const std::vector<BestOrder> found =
        best(honest, [](const std::shared_ptr<const System>& system, int order, int truncation) {
            Solution solution = test::derive(system, order, truncation);
            Normalization lie = *solution.normalization;
            Series& map = lie.map.mode[0];
            Rational share = 1;
            for (int weight = 2; weight <= map.through(); ++weight) {
                share = share / 4;
                map.set(weight, share * map.part(weight));
            }
            solution.normalization = std::make_shared<const Normalization>(std::move(lie));
            return solution;
        });
    EXPECT_GT(worst_loss(found), 1.5);
}

TEST_F(SlowManifold, JsonAndTextHaveIt) {
    test::SceneLine line = test::line_of(exponential());
    VerifyOptions options = test::options();
    options.compiled = false;
    options.estimate = [](const Scene& scene, const Solution& solution, const std::vector<Rational>& eps) {
        return error_estimates(scene, solution, eps, test::derive);
    };
    const Verification v = verify(line.system, line.scene, line.solution, options);
    const auto json = to_json(v)["outputs"][0]["best_order"];
    ASSERT_EQ(json.size(), 6U);
    EXPECT_EQ(json[0]["eps"], 0.5);
    EXPECT_EQ(json[0]["order"], 1);
    EXPECT_EQ(json[3]["order"], 6);
    EXPECT_GT(json[3]["accuracy"], 0);
    EXPECT_NE(to_text(v).find("  best of the orders 1 ... 6 for z, by extrapolation: 1 at eps = 0.5 ... 0.3, "
                              "6 at eps = 0.15 ... 0.05\n"),
              std::string::npos)
        << to_text(v);
}

} // namespace resonform
