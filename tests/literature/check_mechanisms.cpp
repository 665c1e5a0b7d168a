// SPDX-License-Identifier: GPL-3.0-or-later
// Along a trajectory in numbers: the constraints hold, and energy changes by the work done. Energies and
// reactions are written down by hand.
#include "literature/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace resonform {
namespace {

using test::Trajectory;

constexpr double h = 0.01;
constexpr int steps = 200;
constexpr double tolerance = 1e-8;

double square(double x) { return x * x; }

// Homogeneous constraints that do not depend on time do no work.
void expect_conserved(const std::string& system, const Trajectory::Values& start,
                      const std::function<double(const Trajectory&)>& energy) {
    Trajectory at(*test::first_order_named(system), start);
    const double first = energy(at);
    for (int k = 0; k < steps; ++k) {
        at.step(h);
        ASSERT_NEAR(energy(at), first, tolerance) << system << " after step " << k;
    }
}

double energy_of_particle(const Trajectory& at, double b) {
    const double kinetic = square(at["x'"]) + square(at["y'"]) + square(at.rate("z"));
    return at["m"] / 2 * kinetic + at["c"] / 2 * (square(at["x"]) + square(at["y"])) +
           b / 4 * (std::pow(at["x"], 4) + std::pow(at["y"], 4));
}

TEST(WorkAndEnergy, OfTheParticle) {
    const Trajectory::Values start = {{"eps", 0.3}, {"m", 1.5}, {"c", 2},  {"x", 0.7},
                                      {"x'", -0.4}, {"y", 0.2}, {"y'", 1}, {"z", 0}};
    expect_conserved("nonholonomic_particle", start,
                     [](const Trajectory& at) { return energy_of_particle(at, 0); });
    Trajectory::Values anharmonic = start;
    anharmonic["b"] = 0.8;
    expect_conserved("anharmonic_particle", anharmonic, // b stands for eps*b
                     [](const Trajectory& at) { return energy_of_particle(at, at["eps"] * at["b"]); });
}

TEST(WorkAndEnergy, OfTheKnifeEdge) {
    expect_conserved("steered_knife_edge",
                     {{"eps", 0.3},
                      {"m", 1.5},
                      {"c", 2},
                      {"J", 0.4},
                      {"x", 0.7},
                      {"x'", -0.4},
                      {"theta", 0.9},
                      {"theta'", 0.5},
                      {"y", 0}},
                     [](const Trajectory& at) {
                         EXPECT_NEAR(at.rate("y") * std::cos(at["eps"] * at["theta"]),
                                     at["x'"] * std::sin(at["eps"] * at["theta"]), 1e-12);
                         return at["m"] / 2 * (square(at["x'"]) + square(at.rate("y"))) +
                                at["J"] / 2 * square(at["theta'"]) + at["c"] / 2 * square(at["x"]) +
                                at["J"] * at["c"] / at["m"] / 2 * square(at["theta"]);
                     });
}

TEST(WorkAndEnergy, OfTheDisc) {
    expect_conserved("disc_on_a_track",
                     {{"eps", 0.3},
                      {"m", 1.5},
                      {"c", 2},
                      {"J", 0.4},
                      {"I_a", 0.6},
                      {"r", 0.8},
                      {"x", 0.7},
                      {"x'", -0.4},
                      {"theta", 0.9},
                      {"theta'", 0.5},
                      {"y", 0},
                      {"R", 0}},
                     [](const Trajectory& at) {
                         const double rolling = at.rate("R") + at["x'"] / at["r"];
                         EXPECT_NEAR(square(at["r"] * rolling), square(at["x'"]) + square(at.rate("y")),
                                     1e-12);
                         const double k = at["J"] * at["c"] / (at["m"] + at["I_a"] / square(at["r"]));
                         return at["m"] / 2 * (square(at["x'"]) + square(at.rate("y"))) +
                                at["I_a"] / 2 * square(rolling) + at["J"] / 2 * square(at["theta'"]) +
                                at["c"] / 2 * square(at["x"]) + k / 2 * square(at["theta"]);
                     });
}

// The string pulls with m*(l*phi'^2 + g*cos(phi)) and takes in -l' of itself.
TEST(WorkAndEnergy, OfTheLengtheningPendulum) {
    Trajectory at(*test::first_order_named("lengthening_pendulum"),
                  {{"eps", 0.3}, {"g", 9}, {"v", 1}, {"phi", 0.8}, {"phi'", 0.3}, {"l", 1.2}});
    const auto energy = [&] {
        return square(at["l"] * at["phi'"]) / 2 - at["g"] * at["l"] * std::cos(at["phi"]);
    };
    const auto power = [&] {
        return -(at["l"] * square(at["phi'"]) + at["g"] * std::cos(at["phi"])) * at.rate("l");
    };
    const double first = energy();
    double work = 0;
    for (int k = 0; k < steps; k += 2) { // by Simpson's rule
        double sum = power();
        at.step(h);
        sum += 4 * power();
        at.step(h);
        work += h / 3 * (sum + power());
        ASSERT_NEAR(energy() - first, work, 1e-6);
    }
}

// The blades act through the centre C = (x, y) of the massless lamina: what the particle needs has no moment
// about it, and C moves over the lamina along the transversal blade.
TEST(WorkAndEnergy, OfThePendulumOfThePaper) {
    constexpr double small = 1e-3;
    Trajectory at(*test::first_order_named("pendulum_mechanism"), {{"eps", 0.3},
                                                                   {"g", 9},
                                                                   {"r", 0.8},
                                                                   {"v", 0.7},
                                                                   {"psi", 0.5},
                                                                   {"psi'", 0.4},
                                                                   {"xi", 0.3},
                                                                   {"x", 0},
                                                                   {"y", 0}});
    struct Place {
        double x, y;
    };
    const auto angle = [&] { return at["psi"] + std::atan(at["xi"] / at["r"]); };
    const auto particle = [&]() -> Place {
        const double c = std::cos(angle()), s = std::sin(angle());
        return {at["x"] - at["xi"] * c + at["r"] * s, at["y"] - at["xi"] * s - at["r"] * c};
    };
    for (int k = 0; k < 20; ++k) {
        const Place before = particle();
        at.step(small);
        const Place now = particle();
        const double slide = at["eps"] * at["v"];
        EXPECT_NEAR(at.rate("x"), slide * std::cos(angle()), 1e-12);
        EXPECT_NEAR(at.rate("y"), slide * std::sin(angle()), 1e-12);
        const Place arm{now.x - at["x"], now.y - at["y"]};
        at.step(small);
        const Place after = particle();
        const double ax = (after.x - 2 * now.x + before.x) / square(small);
        const double ay = (after.y - 2 * now.y + before.y) / square(small) + at["g"];
        EXPECT_NEAR(arm.x * ay - arm.y * ax, 0, 1e-5);
    }
}

} // namespace
} // namespace resonform
