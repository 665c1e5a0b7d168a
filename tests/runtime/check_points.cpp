// SPDX-License-Identifier: GPL-3.0-or-later
// Many points of emitted evaluators, from tables, in every width: against the same evaluator in 113 bits.
#include "generated/almost_holonomic_pendulum/third_order.hpp"
#include "generated/henon_heiles/third_order.hpp"
#include "generated/nonholonomic_particle/uniform_rise.hpp"
#include "generated/spring_pendulum/exchange.hpp"
#include "generated/three_oscillators_chain/third_order.hpp"
#include "runtime/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace {
std::atomic<long> allocations{0};
}

// Counted, so that a test can say that a call allocates nothing.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
    if (void* memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace resonform::test {

namespace {

struct Pendulum { // one phase, a quadrature
    template <class Real>
    using Evaluator = generated::almost_holonomic_pendulum::third_order::Evaluator<Real>;
};
struct HenonHeiles { // one phase, a slow flow
    template <class Real> using Evaluator = generated::henon_heiles::third_order::Evaluator<Real>;
};
struct Spring { // two phases, a slow flow
    template <class Real> using Evaluator = generated::spring_pendulum::exchange::Evaluator<Real>;
};
struct Chain { // three phases
    template <class Real> using Evaluator = generated::three_oscillators_chain::third_order::Evaluator<Real>;
};
struct Rise { // z begins with 0
    template <class Real> using Evaluator = generated::nonholonomic_particle::uniform_rise::Evaluator<Real>;
};

using Columns = std::vector<std::vector<double>>;

template <class Scene> class ManyPoints : public ::testing::Test {
protected:
    using Double = typename Scene::template Evaluator<double>;
    using Quad = typename Scene::template Evaluator<Float128>;
    static constexpr std::size_t count = sizeof(typename Double::Values) / sizeof(double);
    static constexpr auto places = std::make_index_sequence<count>();

    void TearDown() override { force_simd(Simd::baseline); }

    static Columns columns(std::size_t n) { return Columns(count, std::vector<double>(n, -77)); }
    template <std::size_t... I>
    static BatchReport batch(const Double& e, const std::vector<double>& t, Columns& to, Status* status,
                             std::index_sequence<I...>) {
        return e.batch(t.data(), t.size(), to[I].data()..., status);
    }
    template <std::size_t... I>
    static BatchReport grid(const Double& e, double t0, double dt, Columns& to, Status* status,
                            std::index_sequence<I...>) {
        return e.grid(t0, dt, to[0].size(), to[I].data()..., status);
    }
    static double end_of(double eps) { return Double::default_slow_time_end(eps, {}) / eps; }

    template <class Test> static void in_every_width(const Test& test) {
        int seen = 0;
        for (const Simd width : {Simd::baseline, Simd::avx2, Simd::avx512})
            if (force_simd(width)) {
                SCOPED_TRACE(static_cast<int>(width));
                test();
                ++seen;
            }
        EXPECT_GT(seen, 0);
    }

    // The error of values[k] at t in 2^-52 of the largest of each output within about a period.
    static double error(const Quad& exact, Float128 t, const Columns& values, std::size_t i) {
        std::array<double, count> scale{};
        typename Quad::Values at{};
        const auto* numbers = reinterpret_cast<const Float128*>(&at);
        for (int j = 8; j >= 0; --j) {
            if (exact(t + Float128(0.8 * j), at) != Status::ok) exact(t - Float128(0.8 * j), at);
            for (std::size_t k = 0; k < count; ++k)
                scale[k] = std::max(scale[k], std::abs(static_cast<double>(numbers[k])));
        }
        double worst = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const double wrong = std::abs(static_cast<double>(Float128(values[k][i]) - numbers[k]));
            if (wrong > 0) worst = std::max(worst, wrong / scale[k] * 0x1p52);
        }
        return worst;
    }
};

using Scenes = ::testing::Types<Pendulum, HenonHeiles, Spring, Chain, Rise>;
TYPED_TEST_SUITE(ManyPoints, Scenes);

std::vector<double> random_times(double end, std::size_t n) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(0, 1), decade(-18, 0);
    std::vector<double> t{0, 5e-324, 1e-300, end};
    while (t.size() < n) {
        t.push_back(part(random) * end);
        t.push_back(std::pow(10.0, decade(random)) * end);
    }
    return t;
}

} // namespace

TYPED_TEST(ManyPoints, AreGoodToFewUnits) {
    using F = ManyPoints<TypeParam>;
    for (const double eps : {0.1, 1e-2, 1e-3, 1e-5}) {
        const typename F::Double evaluator(eps);
        const typename F::Quad exact{Float128(eps)};
        const double end = F::end_of(eps);
        const std::vector<double> t = random_times(end, 120);
        F::in_every_width([&] {
            Columns values = F::columns(t.size());
            const BatchReport report = F::batch(evaluator, t, values, nullptr, F::places);
            EXPECT_EQ(report.count, 0U);
            EXPECT_EQ(report.first, t.size());
            double worst = 0;
            for (std::size_t i = 0; i < t.size(); ++i)
                worst = std::max(worst, F::error(exact, Float128(t[i]), values, i));
            EXPECT_LE(worst, 5) << eps;
            // few points in a period, and many; from behind, too
            for (const double dt : {0.77, 0.77e-3, -0.77e-3}) {
                const std::size_t n = 500;
                const double t0 = dt < 0 ? 0.9 * end : 0;
                Columns row = F::columns(n);
                F::grid(evaluator, t0, dt, row, nullptr, F::places);
                for (std::size_t i = 0; i < n; i += 41) {
                    const Float128 at = Float128(t0) + Float128(dt) * Float128(static_cast<long>(i));
                    if (at * Float128(eps) > Float128(end * eps)) break;
                    EXPECT_LE(F::error(exact, at, row, i), 5.5) << eps << ' ' << dt << ' ' << i;
                }
            }
        });
    }
}

TYPED_TEST(ManyPoints, HaveTheStatusesOfCalls) {
    using F = ManyPoints<TypeParam>;
    const double eps = 1e-2, end = F::end_of(eps), nan = std::numeric_limits<double>::quiet_NaN();
    const typename F::Double evaluator(eps);
    std::vector<double> t = random_times(end, 6000);
    for (const auto& [place, time] :
         {std::pair{3UL, nan}, std::pair{900UL, -1.0}, std::pair{4500UL, 1.01 * end},
          std::pair{4501UL, std::numeric_limits<double>::infinity()}})
        t[place] = time;
    F::in_every_width([&] {
        for (const bool sorted : {false, true}) {
            std::vector<double> times = t;
            if (sorted) std::sort(times.begin() + 1000, times.begin() + 4000);
            Columns values = F::columns(times.size());
            std::vector<Status> status(times.size(), Status::no_memory);
            const BatchReport report = F::batch(evaluator, times, values, status.data(), F::places);
            std::size_t bad = 0;
            for (std::size_t i = 0; i < times.size(); ++i) {
                typename F::Double::Values one;
                ASSERT_EQ(status[i], evaluator(times[i], one)) << times[i];
                bad += status[i] == Status::ok ? 0 : 1;
                for (const auto& column : values)
                    ASSERT_EQ(std::isnan(column[i]), status[i] != Status::ok) << times[i];
            }
            EXPECT_EQ(report.count, bad);
            EXPECT_EQ(bad, 4U);
            EXPECT_EQ(report.worst, Status::bad_argument);
            EXPECT_EQ(report.first, 3U);
        }
    });
}

TYPED_TEST(ManyPoints, AreTheSameInAnyOrderAndAlone) {
    using F = ManyPoints<TypeParam>;
    const double eps = 1e-3;
    const typename F::Double evaluator(eps);
    std::vector<double> t = random_times(F::end_of(eps), 5000);
    F::in_every_width([&] {
        Columns values = F::columns(t.size());
        F::batch(evaluator, t, values, nullptr, F::places);
        std::vector<std::size_t> order(t.size());
        for (std::size_t i = 0; i < t.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return t[a] < t[b]; });
        std::vector<double> sorted;
        for (const std::size_t i : order) sorted.push_back(t[i]);
        Columns again = F::columns(t.size()), alone = F::columns(1);
        F::batch(evaluator, sorted, again, nullptr, F::places);
        for (std::size_t i = 0; i < t.size(); ++i)
            for (std::size_t k = 0; k < F::count; ++k)
                ASSERT_EQ(std::memcmp(&values[k][order[i]], &again[k][i], sizeof(double)), 0) << sorted[i];
        for (std::size_t i = 0; i < t.size(); i += 101) {
            F::batch(evaluator, {t[i]}, alone, nullptr, F::places);
            for (std::size_t k = 0; k < F::count; ++k)
                ASSERT_EQ(std::memcmp(&values[k][i], alone[k].data(), sizeof(double)), 0) << t[i];
        }
    });
}

TYPED_TEST(ManyPoints, AllocateNothingOncePrepared) {
    using F = ManyPoints<TypeParam>;
    const typename F::Double evaluator(1e-3);
    const std::vector<double> t = random_times(F::end_of(1e-3), 5000);
    Columns values = F::columns(t.size());
    ASSERT_EQ(evaluator.prepare(), Status::ok);
    const long before = allocations;
    F::batch(evaluator, t, values, nullptr, F::places);
    F::grid(evaluator, 0, 0.01, values, nullptr, F::places);
    EXPECT_EQ(allocations, before);
    EXPECT_EQ(evaluator.prepare(), Status::ok);
    EXPECT_EQ(allocations, before);
}

TYPED_TEST(ManyPoints, OfAConstructionThatFailedAllocateNothing) {
    using F = ManyPoints<TypeParam>;
    const typename F::Double evaluator(-1e-3);
    const std::vector<double> t(3, 1.0);
    Columns values = F::columns(t.size());
    const long before = allocations;
    EXPECT_EQ(evaluator.prepare(), Status::bad_argument);
    EXPECT_EQ(F::batch(evaluator, t, values, nullptr, F::places).worst, Status::bad_argument);
    EXPECT_EQ(F::grid(evaluator, 0, 0.01, values, nullptr, F::places).worst, Status::bad_argument);
    EXPECT_EQ(allocations, before);
}

TYPED_TEST(ManyPoints, OfCopiesMadeWhileThreadsBuildAreTheSame) {
    using F = ManyPoints<TypeParam>;
    const std::vector<double> t = random_times(F::end_of(1e-2), 200);
    Columns expected = F::columns(t.size());
    F::batch(typename F::Double(1e-2), t, expected, nullptr, F::places);
    const typename F::Double shared(1e-2);
    std::atomic<int> waiting{8};
    std::vector<Columns> results(8, F::columns(t.size()));
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < 8; ++k)
        threads.emplace_back([&, k] {
            --waiting;
            while (waiting > 0) std::this_thread::yield();
            typename F::Double other(0.5);
            if (k % 2 == 1) other = shared;
            F::batch(k % 2 == 1 ? other : shared, t, results[k], nullptr, F::places);
        });
    for (std::thread& thread : threads) thread.join();
    for (const Columns& result : results) EXPECT_EQ(result, expected);
}

TEST(Batch, ComputesNoOutputThatIsNotWanted) {
    using Evaluator = generated::almost_holonomic_pendulum::third_order::Evaluator<double>;
    const Evaluator evaluator(1e-2);
    const std::vector<double> t{1, 2, 3};
    std::vector<double> psi(3), x(3), y(3), only(3);
    evaluator.batch(t.data(), 3, psi.data(), x.data(), y.data());
    evaluator.batch(t.data(), 3, nullptr, only.data(), nullptr);
    EXPECT_EQ(only, x);
    const BatchReport empty = evaluator.batch(nullptr, 0, nullptr, nullptr, nullptr);
    EXPECT_EQ(empty.worst, Status::ok);
    EXPECT_EQ(empty.count, 0U);
    EXPECT_EQ(empty.first, 0U);
}

TEST(Batch, OfAnEvaluatorWithoutNumbersSaysSo) {
    using Evaluator = generated::almost_holonomic_pendulum::third_order::Evaluator<double>;
    const Evaluator evaluator(-1);
    EXPECT_EQ(evaluator.prepare(), Status::bad_argument);
    const double t = 1;
    double psi = 0;
    Status status = Status::ok;
    const BatchReport report = evaluator.batch(&t, 1, &psi, nullptr, nullptr, &status);
    EXPECT_EQ(status, Status::bad_argument);
    EXPECT_EQ(report.worst, Status::bad_argument);
    EXPECT_EQ(report.count, 1U);
    EXPECT_TRUE(std::isnan(psi));
}

TEST(Batch, InLongDoubleIsThatOfCalls) {
    using Evaluator = generated::almost_holonomic_pendulum::third_order::Evaluator<long double>;
    const Evaluator evaluator(1e-2L);
    const std::vector<long double> t{0, 1, 99, 101};
    std::vector<long double> x(4), grid(2);
    std::vector<Status> status(4);
    const BatchReport report = evaluator.batch(t.data(), 4, nullptr, x.data(), nullptr, status.data());
    EXPECT_EQ(report.worst, Status::outside_interval);
    EXPECT_EQ(report.first, 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        Evaluator::Values values;
        EXPECT_EQ(evaluator(t[i], values), status[i]);
        EXPECT_EQ(x[i], values.x);
    }
    evaluator.grid(1, 98, 2, nullptr, grid.data(), nullptr);
    EXPECT_EQ(grid[0], x[1]);
    EXPECT_EQ(grid[1], x[2]);
}

} // namespace resonform::test
