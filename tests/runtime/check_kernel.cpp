// SPDX-License-Identifier: GPL-3.0-or-later
// The evaluator kernel in every width against the formula in 50 digits.
#include "runtime/batch.hpp"
#include "runtime/kernel/tables.hpp"
#include "runtime/kernel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace resonform::test {

namespace {

// Every test runs in each width that the processor has.
class Kernel : public ::testing::TestWithParam<Simd> {
protected:
    void SetUp() override {
        if (!force_simd(GetParam())) GTEST_SKIP() << "the processor lacks this width";
    }
    void TearDown() override { force_simd(Simd::baseline); }
};
INSTANTIATE_TEST_SUITE_P(Widths, Kernel, ::testing::Values(Simd::baseline, Simd::avx2, Simd::avx512));

struct Outputs {
    std::vector<std::vector<double>> values;
    std::vector<double*> to;
    Outputs(std::size_t count, std::size_t n) : values(count, std::vector<double>(n, -77)) {
        for (auto& v : values) to.push_back(v.data());
    }
};

std::vector<double> times_of(const kernel::View& w, std::size_t n) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part(0, 1);
    std::vector<double> t{0, -0.0, 5e-324, 1e-300, w.reach};
    for (int k = 1; k <= w.last; ++k)
        for (const double at : {std::nextafter(k / w.per_width, 0.0), k / w.per_width})
            if (t.size() + 2 < n) t.push_back(std::min(at, w.reach));
    while (t.size() < n) t.push_back(part(random) * w.reach);
    return t;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// The size that errors at t are compared with. A scene whose outputs decay gives their size at t, which is
// not taken to be less than 1e-290: there the kernel may answer 0.
template <class Scene> auto scale_at(const Scene& scene, const Fifty& t) {
    if constexpr (requires { scene.scale_at(t); }) {
        auto scale = scene.scale_at(t);
        for (double& s : scale) s = std::max(s, 1e-290);
        return scale;
    } else {
        return scene.scale;
    }
}

// The worst error, in 2^-52 of the scale of each output.
template <class Scene, class Formula, class Values>
double worst(const Scene& scene, const Formula& exact, const Fifty& t, const Values& at) {
    const auto truth = exact(t);
    const auto scale = scale_at(scene, t);
    double most = 0;
    for (std::size_t o = 0; o < truth.size(); ++o)
        most = std::max(most, std::abs(static_cast<double>(Fifty(at(o) - truth[o]))) / scale[o] * 0x1p52);
    return most;
}

template <template <class> class Scene> void agrees(double eps) {
    const Scene<double> scene(eps);
    kernel::Tables tables;
    ASSERT_EQ(tables.build(scene), Status::ok);
    const kernel::View& w = tables.view();
    const Exact<Scene> exact(eps);
    const auto t = times_of(w, 700);
    Outputs out(Scene<double>::outputs, t.size());
    const BatchReport report = kernel::loops().batch(w, t.data(), t.size(), out.to.data(), nullptr, nullptr);
    EXPECT_EQ(report.count, 0U);
    EXPECT_EQ(report.first, t.size());
    double most = 0;
    for (std::size_t i = 0; i < t.size(); ++i)
        most =
            std::max(most, worst(scene, exact, Fifty(t[i]), [&](std::size_t o) { return out.values[o][i]; }));
    EXPECT_LE(most, 4) << eps;
    // the same bits sorted, and one by one
    std::vector<double> sorted = t;
    std::sort(sorted.begin(), sorted.end());
    Outputs again(Scene<double>::outputs, t.size());
    kernel::loops().batch(w, sorted.data(), t.size(), again.to.data(), nullptr, nullptr);
    for (std::size_t i = 0; i < t.size(); ++i) {
        const auto at =
            static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), t[i]) - sorted.begin());
        std::array<double, 8> one{};
        ASSERT_EQ(kernel::loops().one(w, t[i], one.data()), Status::ok);
        for (std::size_t o = 0; o < out.values.size(); ++o) {
            ASSERT_TRUE(same_bits(out.values[o][i], one[o])) << t[i] << ' ' << o;
            ASSERT_TRUE(same_bits(out.values[o][i], again.values[o][at])) << t[i] << ' ' << o;
        }
    }
}

template <template <class> class Scene> void grid_agrees(double eps, double t0, double dt, std::size_t n) {
    const Scene<double> scene(eps);
    kernel::Tables tables;
    ASSERT_EQ(tables.build(scene), Status::ok);
    const Exact<Scene> exact(eps);
    Outputs out(Scene<double>::outputs, n);
    std::vector<Status> status(n, Status::no_memory);
    const auto report = kernel::loops().grid(tables.view(), t0, dt, n, out.to.data(), status.data(), nullptr);
    std::size_t bad = 0;
    for (std::size_t i = 0; i < n; i += 1 + (n > 1000 ? n / 701 : 0)) {
        const Fifty t = Fifty(t0) + Fifty(dt) * Fifty(i);
        const bool inside = t >= 0 && t <= tables.view().reach;
        ASSERT_EQ(status[i] == Status::ok, inside) << i;
        ASSERT_EQ(std::isnan(out.values[0][i]), !inside) << i;
        if (!inside) continue;
        ASSERT_LE(worst(scene, exact, t, [&](std::size_t o) { return out.values[o][i]; }), 4.3)
            << eps << ' ' << t0 << ' ' << dt << ' ' << i;
    }
    for (const Status s : status) bad += s == Status::ok ? 0 : 1;
    EXPECT_EQ(report.count, bad);
}

} // namespace

TEST_P(Kernel, IsGoodToFourUnitsAndTheSameInAnyOrder) {
    for (const double eps : {0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) agrees<Pendulum>(eps);
    for (const double eps : {1e-2, 1e-3, 1e-6}) {
        agrees<TwoPhases>(eps);
        agrees<ThreePhases>(eps);
    }
    agrees<Mean>(1e-3);
}

TEST_P(Kernel, WhatDecaysKeepsItsDigitsUntilItIsGone) {
    for (const double eps : {0.5, 0.1, 1e-2, 1e-3, 1e-6}) agrees<Layers>(eps);
    for (const double eps : {0.5, 0.1, 1e-2, 1e-3, 1e-6}) agrees<Atoms>(eps);
    grid_agrees<Layers>(1e-2, 0, 1e-4, 1000001);
    grid_agrees<Layers>(1e-2, 99, -1e-3, 98000);
    grid_agrees<Layers>(1e-3, 0, 0.37, 2000);
    grid_agrees<Layers>(0.5, 0, 1e-5, 100000);
}

TEST_P(Kernel, OutputsOfAtomsAreTheSameAloneAndOnGrids) {
    kernel::Tables tables;
    ASSERT_EQ(tables.build(Atoms<double>(1e-2)), Status::ok);
    EXPECT_EQ(tables.view().rows, 2U); // the third is 0
    const auto t = times_of(tables.view(), 300);
    Outputs all(4, t.size());
    kernel::loops().batch(tables.view(), t.data(), t.size(), all.to.data(), nullptr, nullptr);
    for (std::size_t o = 0; o < 4; ++o) {
        Outputs alone(4, t.size());
        std::array<double*, 4> to{};
        to[o] = alone.to[o];
        kernel::loops().batch(tables.view(), t.data(), t.size(), to.data(), nullptr, nullptr);
        for (std::size_t i = 0; i < t.size(); ++i)
            ASSERT_TRUE(same_bits(alone.values[o][i], all.values[o][i])) << o << ' ' << t[i];
    }
    grid_agrees<Atoms>(1e-2, 0, 1e-4, 1000001);
    grid_agrees<Atoms>(1e-3, 0, 0.37, 2000);
}

TEST_P(Kernel, PhasesOfTenToTheTwelfthCostNoDigits) {
    for (const double eps : {1e-7, 1e-9, 1e-12}) {
        agrees<Pendulum>(eps);
        agrees<TwoPhases>(eps);
    }
}

TEST_P(Kernel, GridsAreExact) {
    grid_agrees<Pendulum>(1e-3, 0, 1e-3, 1000001);
    grid_agrees<Pendulum>(1e-3, 1000, -1.7e-3, 600000);
    grid_agrees<Pendulum>(1e-3, -1, 0.37, 3000);
    grid_agrees<Pendulum>(1e-3, 1001, -0.37, 3000);
    grid_agrees<Pendulum>(1e-3, 123.456, 0, 100);
    grid_agrees<Pendulum>(1e-2, 3.3, 1e-7, 5000);
    grid_agrees<Pendulum>(0.1, -0.5, 1e-3, 12000);
    grid_agrees<Pendulum>(1e-9, 7e8, 1e-4, 20000);
    grid_agrees<TwoPhases>(1e-2, 0, 1e-3, 100001);
    grid_agrees<ThreePhases>(1e-3, 1, 1e-4, 100000);
    grid_agrees<Mean>(1e-3, 0, 1, 1001);
}

TEST_P(Kernel, SaysWhatItCannotAnswer) {
    kernel::Tables tables;
    ASSERT_EQ(tables.build(Pendulum<double>(1e-3)), Status::ok);
    const double none = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const std::size_t n : {9UL, 40UL, 9000UL})
        for (const bool sorted : {true, false}) {
            std::vector<double> t;
            for (std::size_t i = 0; i < n; ++i)
                t.push_back(sorted ? 0.1 * static_cast<double>(i) : 7.0 * static_cast<double>(i * 37 % 101));
            t[3] = -1;
            t[5] = none;
            t[7] = inf;
            t[8] = 1001;
            Outputs out(3, n), all(3, n);
            std::vector<Status> status(n);
            const auto report =
                kernel::loops().batch(tables.view(), t.data(), n, out.to.data(), status.data(), nullptr);
            EXPECT_EQ(report.worst, Status::bad_argument);
            EXPECT_EQ(report.count, 4U);
            EXPECT_EQ(report.first, 5U);
            for (std::size_t i = 0; i < n; ++i) {
                std::array<double, 3> one{};
                EXPECT_EQ(status[i], kernel::loops().one(tables.view(), t[i], one.data()));
                for (std::size_t o = 0; o < 3; ++o)
                    EXPECT_TRUE(std::isnan(one[o]) ? std::isnan(out.values[o][i])
                                                   : same_bits(one[o], out.values[o][i]));
            }
            // a null output is not computed, the others keep their bits; nothing at all is allowed, too
            std::array<double*, 3> some{nullptr, all.to[1], nullptr}, nothing{};
            kernel::loops().batch(tables.view(), t.data(), n, some.data(), nullptr, nullptr);
            for (std::size_t i = 0; i < n; ++i)
                EXPECT_TRUE(status[i] != Status::ok || same_bits(all.values[1][i], out.values[1][i]));
            EXPECT_EQ(
                kernel::loops().batch(tables.view(), t.data(), n, nothing.data(), nullptr, nullptr).count,
                4U);
        }
    const auto empty =
        kernel::loops().batch(tables.view(), nullptr, 0, Outputs(3, 1).to.data(), nullptr, nullptr);
    EXPECT_EQ(empty.worst, Status::ok);
    EXPECT_EQ(empty.count + empty.first, 0U);
}

TEST(KernelWidths, AreNeverRaised) {
    EXPECT_TRUE(force_simd(Simd::baseline));
    EXPECT_EQ(simd(), Simd::baseline);
    EXPECT_FALSE(force_simd(Simd::neon));
    EXPECT_EQ(simd(), Simd::baseline);
}

} // namespace resonform::test
