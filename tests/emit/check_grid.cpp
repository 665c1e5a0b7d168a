// SPDX-License-Identifier: GPL-3.0-or-later
// Grids whose times are no doubles, t0 + i dt with all digits of dt, over intervals of many turns: what the
// times lack to doubles is part of the phase.
#include "support/compiler.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform {
namespace {

// Prints the worst error of the first output in ulp of its largest values nearby. SCENE: the namespace.
constexpr const char* grid_program = R"(
#include "runtime/float128.hpp"

#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>
#include <utility>
#include <vector>

using resonform::Float128;
using resonform::Status;
constexpr int count = 400;

double worst_of(double eps, double from, double to) {
    using Own = SCENE::Evaluator<double>;
    using Other = SCENE::Evaluator<Float128>;
    constexpr std::size_t outputs = sizeof(Own::Values) / sizeof(double);
    const Own own(eps);
    const Other other{Float128(eps)};
    const double T = Own::default_slow_time_end(eps, {}), t0 = from * T / eps;
    const double dt = (to - from) * T / eps / (count + 0.3);
    std::array<std::vector<double>, outputs> all;
    std::array<double*, outputs> to_arrays;
    for (std::size_t k = 0; k < outputs; ++k) to_arrays[k] = (all[k].resize(count), all[k].data());
    std::apply([&](auto*... array) { return own.grid(t0, dt, count, array...); }, to_arrays);
    std::vector<Float128> exact;
    for (int i = 0; i < count; ++i) {
        Other::Values values;
        if (other(Float128(t0) + Float128(i) * Float128(dt), values) != Status::ok) return 1e300;
        exact.push_back(*reinterpret_cast<const Float128*>(&values));
    }
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        double scale = 0;
        for (int j = std::max(0, i - 100); j < std::min(count, i + 100); ++j)
            scale = std::max(scale, std::fabs(double(exact[std::size_t(j)])));
        const double off = std::fabs(double(Float128(all[0][std::size_t(i)]) - exact[std::size_t(i)]));
        worst = std::max(worst, off / (scale * 0x1p-52));
    }
    return worst;
}

int main() {
    for (const double eps : {0.03, 1e-3, 1e-4, 1e-6, 1e-8, 1e-11})
        for (const auto& [from, to] :
             {std::pair(0.0, 0.999), std::pair(0.977, 0.011), std::pair(0.731, 0.7311)})
            if (const double worst = worst_of(eps, from, to); !(worst <= 4.5))
                std::printf("eps %g, from %g to %g of the interval: %g ulp\n", eps, from, to, worst);
}
)";

class Grid : public testing::TestWithParam<std::string> {};
TEST_P(Grid, HasTimesThatAreNoDoubles) { EXPECT_EQ(test::printed_beside(GetParam(), grid_program, ""), ""); }
INSTANTIATE_TEST_SUITE_P(SlowScenes, Grid,
                         testing::Values("airy/waves", "almost_holonomic_pendulum/third_order",
                                         "warming_resonator/warm_up"));

} // namespace
} // namespace resonform
