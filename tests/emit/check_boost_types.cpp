// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluators in types of Boost.Multiprecision, binary and decimal, with expression templates and without:
// phases of many turns have the last digits of the type, as in double.
#include "support/compiler.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform {
namespace {

// Prints where a call, a grid or a final point is off by more than 4 units of the type, relative to the
// largest value of the output in the interval.
constexpr const char* boost_program = R"(
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace mp = boost::multiprecision;
using Exact = mp::cpp_bin_float_100;
using resonform::Status;
constexpr int count = 9;

// Rounded far below the last of 50 digits.
template <class Real> Exact exactly(const Real& x) { return Exact(x.str(120)); }

template <class Real> void look(const char* type, const char* eps_text) {
    using Own = SCENE::Evaluator<Real>;
    using Other = SCENE::Evaluator<Exact>;
    constexpr std::size_t outputs = sizeof(typename Own::Values) / sizeof(Real);
    const Real eps(eps_text);
    const auto start = Own::default_start(eps, {});
    const auto exact_start = [&] {
        typename Other::Start wide;
        const auto* from = reinterpret_cast<const Real*>(&start);
        auto* to = reinterpret_cast<Exact*>(&wide);
        for (std::size_t k = 0; k < sizeof(start) / sizeof(Real); ++k) to[k] = exactly(from[k]);
        return wide;
    }();
    const Own own(eps, {}, start);
    const Other other(exactly(eps), {}, exact_start);
    const Real t0 = Own::default_slow_time_end(eps, {}) / eps / 1000, dt = t0 * 117;
    std::array<std::vector<Real>, outputs> grid;
    const auto on_grid = [&]<std::size_t... k>(std::index_sequence<k...>) {
        return own.grid(t0, dt, count, (grid[k].resize(count), grid[k].data())...);
    }(std::make_index_sequence<outputs>());
    bool right = on_grid.worst == Status::ok;
    std::array<Exact, outputs> size{}, off{};
    const auto note = [&](const auto& found, const auto& expected) {
        for (std::size_t k = 0; k < outputs; ++k) {
            const Exact exact = reinterpret_cast<const Exact*>(&expected)[k];
            size[k] = std::max(size[k], Exact(abs(exact)));
            off[k] = std::max(off[k], Exact(abs(exactly(found(k)) - exact)));
        }
    };
    for (int i = 0; i < count; ++i) {
        const Real t(t0 + i * dt);
        typename Own::Values called, last;
        typename Other::Values there, on_the_grid;
        right = right && own(t, called) == Status::ok && other(exactly(t), there) == Status::ok &&
                Own::at_end(eps, {}, start, t, last) == Status::ok &&
                other(exactly(t0) + i * exactly(dt), on_the_grid) == Status::ok;
        note([&](std::size_t k) { return reinterpret_cast<const Real*>(&called)[k]; }, there);
        note([&](std::size_t k) { return reinterpret_cast<const Real*>(&last)[k]; }, there);
        note([&](std::size_t k) { return grid[k][std::size_t(i)]; }, on_the_grid);
    }
    for (std::size_t k = 0; k < outputs; ++k) {
        const Exact ulp = off[k] / size[k] / exactly(std::numeric_limits<Real>::epsilon());
        if (!right || !(ulp <= 4))
            std::printf("%s, eps %s, output %zu: %s ulp\n", type, eps_text, k, ulp.str(3).c_str());
    }
}

int main() {
    for (const char* eps : {"0.0123456789", "1.2345678987654321e-5"}) {
        look<mp::cpp_bin_float_50>("binary", eps);
        look<mp::number<mp::cpp_bin_float<50>, mp::et_on>>("binary with templates", eps);
        look<mp::cpp_dec_float_50>("decimal with templates", eps);
    }
}
)";

class BoostTypes : public testing::TestWithParam<std::string> {};
TEST_P(BoostTypes, HaveTheirLastDigits) {
    EXPECT_EQ(test::printed_beside(GetParam(), boost_program, ""), "");
}
INSTANTIATE_TEST_SUITE_P(SlowScenes, BoostTypes,
                         testing::Values("almost_holonomic_pendulum/third_order", "stiff_spring/stiff"),
                         [](const auto& info) { return info.param.substr(0, info.param.find('/')); });

} // namespace
} // namespace resonform
