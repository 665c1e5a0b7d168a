// SPDX-License-Identifier: GPL-3.0-or-later
// Divisors of products that decay: what is gone does no harm where they vanish, what is there is refused.
#include "support/program.hpp"
#include "verify/evaluate/program_defaults.hpp"
#include "verify/own_system.hpp"
#include "verify/symbolic/evaluator.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

class FadingDivisors : public test::InterpretedSystem {
protected:
    // Emitted formula and exact solution agree about whether there is an answer.
    Status both(const std::string& system, const std::string& text, double eps) {
        const Scene scene = written(system, text);
        const Answer answer = at(system, text, eps, 1);
        const auto program = test::program_of(scene);
        const SymbolicEvaluator exact(
            std::make_shared<const SymbolicSolution>(test::solution_of(scene), scene),
            test::symbolic_inputs(*program, eps, default_start<double>(*program, eps, {}), 4 * eps),
            Wide(4 * eps));
        EXPECT_EQ(exact(Wide(1)).status, answer.status) << eps;
        EXPECT_EQ(answer.why, answer.status == Status::ok ? "" : "y");
        return answer.status;
    }
};

const std::string crossing = "[variables]\nu = { role = \"fast\" }\ny = { role = \"fast\" }\n"
                             "s = { role = \"slow\" }\n[domain]\npositive = [\"1 + s\"]\n[equations]\n"
                             "u = \"u' = -(1 + s)*u\"\ny = \"y' = -2*y + u^2\"\ns = \"s' = -eps\"\n";
const std::string both_in_motion = "order = 2\noutputs = [\"u\", \"y\"]\n"
                                   "[start]\nu = \"eps\"\ny = \"eps/2\"\ns = 1\n";

// e^{-2t} (eps/2 + int e^{2r} u(r)^2 dr), by the rule of Simpson
double exact_y(double eps, double t) {
    const int n = 20000;
    const double h = t / n;
    double sum = 0;
    for (int i = 0; i <= n; ++i) {
        const double r = i * h, u = eps * std::exp(-2 * r + eps * r * r / 2);
        sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * std::exp(-2 * (t - r)) * u * u;
    }
    return eps / 2 * std::exp(-2 * t) + sum * h / 3;
}

TEST_F(FadingDivisors, VanishWhenWhatTheyDivideIsGone) {
    for (const double eps : {0.1, 0.05, 0.01})
        for (const double s : {0.9, 0.2, -0.1, -0.3, -0.45}) {
            const double t = (1 - s) / eps;
            const Answer answer = at(crossing, both_in_motion, eps, t);
            ASSERT_EQ(answer.status, Status::ok) << eps << " " << s << " " << answer.why;
            EXPECT_NEAR(answer.values[1] / exact_y(eps, t), 1, s == 0.9 ? 4 * eps * eps : 6 * eps)
                << eps << s;
        }
}

// e^-30 is left at eps = 1/10, a gap for |s| < 3e-4; at 1/100 not even D = 0 is one.
TEST_F(FadingDivisors, LeaveAGapWhileSomethingIsLeft) {
    for (const double s : {1e-4, 0.0, -1e-4}) {
        const Answer coarse = at(crossing, both_in_motion, 0.1, (1 - s) / 0.1);
        EXPECT_EQ(coarse.status, Status::low_precision) << s;
        EXPECT_EQ(coarse.why, "chi_1");
        EXPECT_TRUE(std::isfinite(coarse.values[1])) << s;
        EXPECT_EQ(at(crossing, both_in_motion, 0.01, (1 - s) / 0.01).status, Status::ok) << s;
    }
    EXPECT_EQ(at(crossing, both_in_motion, 0.1, 9.99).status, Status::ok);
}

std::string with(const std::string& text, const std::string& found, const std::string& instead) {
    return std::string(text).replace(text.find(found), found.size(), instead);
}

// u = z_1 is divided by nothing.
TEST_F(FadingDivisors, AreNothingToOtherOutputs) {
    EXPECT_EQ(at(crossing, with(both_in_motion, "\"u\", \"y\"", "\"u\""), 0.1, 10).status, Status::ok);
}

// Of a manifold alone nothing is divided by s.
TEST_F(FadingDivisors, AreNothingToTheManifold) {
    const std::string driven = with(crossing, "+ u^2", "+ u^2 + eps"),
                      scene = with(both_in_motion, "\"u\", ", "");
    for (const double t : {10.0, 10.00001})
        EXPECT_EQ(at(driven, "transients = false\n" + scene, 0.1, t).status, Status::ok) << t;
    EXPECT_EQ(at(driven, scene, 0.1, 10).status, Status::low_precision);
}

// s is the divisor of a forced oscillation, too: there its layer ends the domain.
TEST_F(FadingDivisors, EndTheDomainWhereWhatTheyDivideLasts) {
    const std::string forced = with(
        with(crossing, "[domain]", "x = { role = \"fast\" }\nphi = { role = \"angle\" }\n[domain]"),
        "s = \"s' = -eps\"", "s = \"s' = -eps\"\nx = \"x'' + x = eps^2*cos(phi)\"\nphi = \"phi' = 1 + s\"");
    const std::string scene = both_in_motion + "x = \"eps\"\n\"x'\" = 0\nphi = 0\n";
    EXPECT_EQ(at(forced, scene, 0.01, 50).status, Status::ok);
    EXPECT_EQ(at(forced, scene, 0.01, 101).status, Status::outside_domain);
    EXPECT_EQ(at(forced, scene, 0.01, 140).status, Status::outside_domain);
}

// y = z_2 + z_1^2/(2 - 2 k): 250 eps is no small correction of a half.
TEST_F(FadingDivisors, MustLeaveTheMapNearTheIdentityAtTheStart) {
    const auto system = [](const std::string& k) {
        return "[variables]\nu = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
               "u = \"u' = -" +
               k + "*u\"\ny = \"y' = -2*y + u^2\"\n";
    };
    for (const int order : {1, 2}) {
        const std::string scene =
            "order = " + std::to_string(order) + "\noutputs = [\"y\"]\n[start]\nu = \"eps\"\ny = \"eps/2\"\n";
        EXPECT_EQ(both(system("1.001"), scene, 0.1), Status::outside_domain);
        EXPECT_EQ(both(system("0.999"), scene, 0.1), Status::outside_domain);
        EXPECT_EQ(both(system("1.001"), scene, 0.0001), Status::ok);
        EXPECT_EQ(both(system("1.1"), scene, 0.01), Status::ok);
        EXPECT_EQ(both(system("1"), scene, 0.1), Status::ok); // kept in the rate
    }
}

} // namespace
} // namespace resonform
