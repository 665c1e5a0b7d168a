// SPDX-License-Identifier: GPL-3.0-or-later
// at_end and ensemble of committed headers: the numbers of an evaluator in a wider type, the statuses of one
// in its own.
#include "support/compiler.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// Prints what is wrong. SCENE: the namespace; QUIET: nothing may be allocated.
constexpr const char* point_program = R"(
#include "scene.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

static long allocated = 0;
static bool starving = false;
void* operator new(std::size_t n) {
    ++allocated;
    if (void* p = starving ? nullptr : std::malloc(n)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

using resonform::Status;

// The members of structs of numbers.
template <class Real, class Struct> Real& member(Struct& s, std::size_t k) { return reinterpret_cast<Real*>(&s)[k]; }
template <class Real, class Struct> std::size_t members(const Struct&) {
    return std::is_empty_v<Struct> ? 0 : sizeof(Struct) / sizeof(Real);
}

template <class Real, class Wide> struct Check {
    using Own = SCENE::Evaluator<Real>;
    using Other = SCENE::Evaluator<Wide>;

    std::mt19937_64 random{7};
    Real uniform(double from, double to) {
        return Real(std::uniform_real_distribution<double>(from, to)(random));
    }

    static double error(typename Own::Values values, typename Other::Values exact, std::size_t k,
                        double scale) {
        const Wide difference = Wide(member<Real>(values, k)) - member<Wide>(exact, k);
        return std::fabs(double(difference)) / (scale * double(resonform::math::epsilon<Real>()));
    }

    // One start and one time.
    void point(const Real& eps, typename Own::Start start, const Real& T) {
        typename Own::Parameters parameters;
        typename Other::Parameters wide_parameters;
        typename Other::Start wide_start;
        for (std::size_t k = 0; k < members<Real>(parameters); ++k)
            member<Wide>(wide_parameters, k) = Wide(member<Real>(parameters, k));
        for (std::size_t k = 0; k < members<Real>(start); ++k)
            member<Wide>(wide_start, k) = Wide(member<Real>(start, k));
        const Real t = T / eps, end = eps * t > Real(1e-240) ? Real(eps * t) : Real(1e-240);
        typename Own::Values values, tabulated;
        allocated = 0;
        const Status status = Own::at_end(eps, parameters, start, t, values);
        if (QUIET && allocated > 0) std::printf("allocates: eps %g T %g\n", double(eps), double(T));
        members_.push_back({eps, t, parameters, start, values, status, {}});
        const Status expected = Own(eps, parameters, start, end)(t, tabulated);
        if (status != expected)
            std::printf("status %d, not %d: eps %g T %g\n", int(status), int(expected), double(eps), double(T));
        if (status != Status::ok) {
            if (status != Status::low_precision && !(member<Real>(values, 0) != member<Real>(values, 0)))
                std::printf("a number at status %d\n", int(status));
            return;
        }
        const Other whole(Wide(eps), wide_parameters, wide_start);
        const Other other(Wide(eps), wide_parameters, wide_start, Wide(end) * Wide(1.0000001));
        typename Other::Values exact, some;
        if (other(Wide(t), exact) != Status::ok) return;
        for (std::size_t k = 0; k < members<Real>(values); ++k) {
            double scale = std::fabs(double(member<Wide>(exact, k)));
            for (int j = 0; j <= 30; ++j)
                if (whole(Wide(j * j) / Wide(900) / Wide(eps), some) == Status::ok)
                    scale = std::max(scale, std::fabs(double(member<Wide>(some, k))));
            members_.back().scale.push_back(scale);
            members_.back().exact = exact;
            const double own = error(values, exact, k, scale), by_tables = error(tabulated, exact, k, scale);
            if (!(own <= 4 || own <= 2 * by_tables))
                std::printf("output %zu: %g ulp, by tables %g: eps %g T %g\n", k, own, by_tables, double(eps), double(T));
            ++compared;
        }
    }
    int compared = 0;

    struct Member {
        Real eps, t;
        typename Own::Parameters parameters;
        typename Own::Start start;
        typename Own::Values alone;
        Status status;
        std::vector<double> scale; // empty: not compared
        typename Other::Values exact{};
    };
    std::vector<Member> members_;

    // Outputs and statuses of the members from `begin`, `count` at a time.
    std::vector<std::vector<Real>> together(std::size_t begin, std::size_t count, bool full_phase, std::vector<Status>& status) {
        constexpr std::size_t values = sizeof(typename Own::Values) / sizeof(Real);
        std::vector<std::vector<Real>> all(values, std::vector<Real>(members_.size(), Real(0)));
        status.assign(members_.size(), Status::ok);
        std::vector<Real> eps, t;
        std::vector<std::vector<Real>> arguments(members<Real>(typename Own::Parameters{}) + members<Real>(typename Own::Start{}));
        for (const Member& m : members_) {
            eps.push_back(m.eps);
            t.push_back(m.t);
            std::size_t next = 0;
            Member own = m;
            for (std::size_t k = 0; k < members<Real>(m.parameters); ++k) arguments[next++].push_back(member<Real>(own.parameters, k));
            for (std::size_t k = 0; k < members<Real>(m.start); ++k) arguments[next++].push_back(member<Real>(own.start, k));
        }
        for (std::size_t i = begin; i < members_.size(); i += count) {
            const std::size_t n = std::min(count, members_.size() - i);
            typename Own::Members arrays;
            if constexpr (requires { arrays.full_phase; }) arrays.full_phase = full_phase;
            const Real** pointers = reinterpret_cast<const Real**>(&arrays);
            pointers[0] = &eps[i];
            for (std::size_t k = 0; k < arguments.size(); ++k) pointers[k + 1] = &arguments[k][i];
            std::array<Real*, values> outputs;
            for (std::size_t k = 0; k < values; ++k) outputs[k] = &all[k][i];
            allocated = 0;
            const auto report = std::apply([&](auto*... to) { return Own::ensemble(n, arrays, &t[i], to..., &status[i]); }, outputs);
            if (QUIET && allocated > 0) std::printf("ensemble allocates\n");
            std::size_t bad = 0;
            for (std::size_t j = 0; j < n; ++j) bad += status[i + j] != Status::ok;
            if (report.count != bad || (bad > 0 && status[i + report.first] != report.worst) || (bad == 0 && report.first != n))
                std::printf("report: count %zu, not %zu\n", report.count, bad);
        }
        return all;
    }

    void ensemble() {
        for (const bool full_phase : {true, false}) {
            std::vector<Status> status, other;
            const auto numbers = together(0, members_.size(), full_phase, status);
            for (const auto& [begin, count] : {std::pair(0, 1), std::pair(0, 3), std::pair(5, 1000000)}) {
                const auto again = together(begin, count, full_phase, other);
                for (std::size_t i = begin; i < members_.size(); ++i) {
                    bool same = other[i] == status[i];
                    for (std::size_t k = 0; k < numbers.size(); ++k)
                        same = same && (again[k][i] == numbers[k][i] || numbers[k][i] != numbers[k][i]);
                    if (!same) std::printf("member %zu depends on its neighbours\n", i);
                }
            }
            for (std::size_t i = 0; i < members_.size(); ++i) {
                const Member& m = members_[i];
                if (status[i] != m.status) std::printf("ensemble: status %d, not %d\n", int(status[i]), int(m.status));
                for (std::size_t k = 0; k < numbers.size(); ++k) {
                    if (status[i] != Status::ok && status[i] != Status::low_precision && numbers[k][i] == numbers[k][i])
                        std::printf("ensemble: a number at status %d\n", int(status[i]));
                    if (k >= m.scale.size()) continue;
                    typename Own::Values own{};
                    member<Real>(own, k) = numbers[k][i];
                    const double off = error(own, m.exact, k, m.scale[k]), by_itself = error(m.alone, m.exact, k, m.scale[k]);
                    const double most = full_phase ? 4 : 4 + 1e-12 / double(resonform::math::epsilon<Real>());
                    if (!(off <= most || off <= 2 * by_itself))
                        std::printf("ensemble, output %zu: %g ulp, alone %g: eps %g T %g\n", k, off, by_itself, double(m.eps), double(m.eps * m.t));
                }
            }
        }
    }

    void defaults() {
        const std::array<Real, 5> eps{Real(0.01), Real(0.02), Real(0.005), Real(0.03), Real(0.01)}, t{Real(10), Real(11), Real(12), Real(13), Real(14)};
        typename Own::Members given;
        constexpr std::size_t values = sizeof(typename Own::Values) / sizeof(Real);
        std::array<std::array<Real, 5>, values> all;
        std::array<Real*, values> outputs;
        for (std::size_t k = 0; k < values; ++k) outputs[k] = all[k].data();
        const auto call = [&](std::size_t n) { return std::apply([&](auto*... to) { return Own::ensemble(n, given, t.data(), to...); }, outputs); };
        const auto without = call(5);
        if (without.count != 5 || without.worst != Status::bad_argument || without.first != 0) std::printf("no eps: %d\n", int(without.worst));
        given.eps = eps.data();
        outputs[0] = nullptr;
        if (call(0).count != 0 || call(5).count != 0) std::printf("defaults: not ok\n");
        for (std::size_t i = 0; i < 5; ++i) {
            typename Own::Values v;
            Own::at_end(eps[i], {}, Own::default_start(eps[i], {}), t[i], v);
            for (std::size_t k = 1; k < values; ++k)
                if (!(resonform::math::magnitude(Real(all[k][i] - member<Real>(v, k))) <= Real(100) * resonform::math::epsilon<Real>()))
                    std::printf("defaults: output %zu\n", k);
        }
    }

    void starts(int count) {
        for (int i = 0; i < count; ++i) {
            const Real eps = Real(std::pow(10.0, double(uniform(-4, QUIET ? -0.4 : -1))));
            auto start = Own::default_start(eps, {});
            const double spread = i % 5 == 0 ? (QUIET ? 6 : 2) : 0.2; // some leave the domain
            for (std::size_t k = 0; k < members<Real>(start); ++k)
                member<Real>(start, k) = member<Real>(start, k) * (Real(1) + uniform(-spread, spread)) + (i % 3 ? uniform(-0.05, 0.05) : Real(0));
            Real T = Own::default_slow_time_end(eps, {}) * uniform(0, 1.3);
            if (QUIET && i % 5 == 2) T = T * Real(20); // a long flow loses more than its tables
            if (i % 10 == 0) T = T * Real(1e-12);
            if (i % 10 == 1) T = Real(0);
            point(eps, start, T);
        }
        if (2 * compared < count) std::printf("compared %d numbers only\n", compared);
        ensemble();
        defaults();
    }

    void arguments() {
        const Real eps = Real(0.01), none = resonform::math::not_a_number<Real>();
        auto start = Own::default_start(eps, {});
        typename Own::Values v;
        const auto expect = [](Status status, Status expected, const char* what) {
            if (status != expected) std::printf("%s: %d\n", what, int(status));
        };
        expect(Own::at_end(none, {}, start, Real(1), v), Status::bad_argument, "eps");
        expect(Own::at_end(Real(0), {}, start, Real(1), v), Status::bad_argument, "eps = 0");
        expect(Own::at_end(eps, {}, start, none, v), Status::bad_argument, "t");
        expect(Own::at_end(eps, {}, start, Real(1) / Real(0 * eps), v), Status::bad_argument, "t infinite");
        expect(Own::at_end(eps, {}, start, Real(1e300), v), Status::outside_interval, "t beyond every interval");
        expect(Own::at_end(eps, {}, start, Real(-1), v), Status::outside_interval, "t < 0");
        allocated = 0;
        starving = true;
        const Status without = Own::at_end(eps, {}, start, Real(-1), v);
        starving = false;
        expect(without, allocated > 0 ? Status::no_memory : Status::outside_interval, "t < 0, no memory");
        if (member<Real>(v, 0) == member<Real>(v, 0)) std::printf("t < 0: a number\n");
        member<Real>(start, 0) = none;
        expect(Own::at_end(eps, {}, start, Real(1), v), Status::bad_argument, "start");
        if (TURNS)
            for (const double small : {1e-9, 1e-13, 1e-16, 1e-21}) // phases are long: low_precision at last
                point(Real(small), Own::default_start(Real(small), {}), Real(0.7));
    }
};

int main() {
    Check<double, long double> check;
    check.arguments();
    check.starts(100);
#ifndef DOUBLE_ALONE
    Check<long double, resonform::Float128> wide;
    wide.arguments();
    wide.starts(20);
#endif
    return 0;
}
)";

std::string wrong_points(const std::string& scene, const std::string& options,
                         const std::string& width = "x86-64") {
    return test::printed_beside(scene, point_program, "-march=" + width + " " + options);
}

TEST(SlowFinalPoint, OfAPhaseAndAQuadrature) {
    EXPECT_EQ(wrong_points("almost_holonomic_pendulum/third_order", "-DQUIET=true -DTURNS=true"), "");
}
// As members of wider ensembles; numbers that are no double are computed one by one at every width.
class FinalPoint : public testing::TestWithParam<std::string> {};
TEST_P(FinalPoint, InWiderPacks) {
    const bool there = GetParam() == "x86-64-v3"
                           ? __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")
                           : __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    if (!there) GTEST_SKIP() << "the processor lacks " << GetParam();
    EXPECT_EQ(wrong_points("almost_holonomic_pendulum/third_order",
                           "-DQUIET=true -DTURNS=true -DDOUBLE_ALONE", GetParam()),
              "");
    EXPECT_EQ(wrong_points("three_oscillators_chain/third_order", "-DQUIET=true -DTURNS=false -DDOUBLE_ALONE",
                           GetParam()),
              "");
    EXPECT_EQ(wrong_points("michaelis_menten/from_no_complex", "-DQUIET=false -DTURNS=false -DDOUBLE_ALONE",
                           GetParam()),
              "");
}
INSTANTIATE_TEST_SUITE_P(SlowWidths, FinalPoint, testing::Values("x86-64-v3", "x86-64-v4"));
TEST(SlowFinalPoint, OfAPhaseAlongSamples) {
    EXPECT_EQ(wrong_points("adiabatic_oscillator/sampled", "-DQUIET=false -DTURNS=true"), "");
}
// A fifth of the starts leads out of the domain.
TEST(SlowFinalPoint, WhereTheDomainEnds) {
    EXPECT_EQ(wrong_points("lengthening_pendulum/third_order", "-DQUIET=true -DTURNS=false"), "");
}
TEST(SlowFinalPoint, OfThreePhases) {
    EXPECT_EQ(wrong_points("three_oscillators_chain/third_order", "-DQUIET=true -DTURNS=false"), "");
}
// Constants whose products may leave the range of a double.
TEST(SlowFinalPoint, OfCoefficientsManyDecadesApart) {
    EXPECT_EQ(wrong_points("extreme_coefficients/free_oscillation", "-DQUIET=true -DTURNS=false"), "");
}
TEST(SlowFinalPoint, OfANearResonance) {
    EXPECT_EQ(wrong_points("near_resonance/detuned", "-DQUIET=true -DTURNS=true"), "");
}
TEST(SlowFinalPoint, OfAFlow) {
    EXPECT_EQ(wrong_points("henon_heiles/third_order", "-DQUIET=false -DTURNS=false"), "");
}
TEST(SlowFinalPoint, OfAFlowAndAModeThatDecays) {
    EXPECT_EQ(wrong_points("michaelis_menten/from_no_complex", "-DQUIET=false -DTURNS=false"), "");
}
TEST(SlowFinalPoint, OfAFlowWithTwoPhases) {
    EXPECT_EQ(wrong_points("spring_pendulum/exchange", "-DQUIET=false -DTURNS=false"), "");
}

} // namespace
} // namespace resonform
