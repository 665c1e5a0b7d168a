// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the evaluator kernel in the width that this program is compiled for, in ns a point and as
// multiples of a vectorised sincos of the same width in the same run (docs/design/21_evaluator_kernel.md).
// New times t in each repetition; the least of many.
#include "bench/measure.hpp"
#include "runtime/kernel/grid.hpp"
#include "runtime/kernel/one.hpp"
#include "runtime/kernel/tables.hpp"
#include "runtime/kernel_scenes.hpp"

#include <cstdio>
#include <random>
#include <vector>

using namespace resonform;
using namespace resonform::kernel;

namespace {

volatile double sink = 0;

std::vector<double> drawn(std::size_t n, double end, bool sorted, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0, end);
    std::vector<double> t(n);
    for (double& x : t) x = part(random);
    if (sorted) std::sort(t.begin(), t.end());
    return t;
}

// Least ns a point of call(t) over fresh t's.
template <class Call> double least(std::size_t n, double end, bool sorted, const Call& call) {
    double best = 1e300;
    const std::size_t repetitions = n > 100000 ? 9 : 300;
    std::vector<std::vector<double>> t;
    for (unsigned r = 0; r < 9; ++r) t.push_back(drawn(n, end, sorted, r));
    for (std::size_t r = 0; r < repetitions; ++r) {
        const auto start = std::chrono::steady_clock::now();
        call(t[r % t.size()]);
        best = std::min(best, bench::seconds_since(start));
    }
    return best / static_cast<double>(n) * 1e9;
}

void sines(const double* t, std::size_t n, double* c, double* s) {
    using L = Lanes<lanes>;
    constexpr int V = at_once;
    for (std::size_t i = 0; i + V * lanes <= n; i += V * lanes)
        for (int k = 0; k < V; ++k) {
            const auto x =
                L::product(L::load(t + i + static_cast<std::size_t>(k * lanes)), L::all(0.6366197723675814));
            const auto turned = x + L::all(rounding_shift), f = x - (turned - L::all(rounding_shift));
            L::Vector cosine, sine;
            cosine_and_sine<lanes>(f, turned, cosine, sine);
            L::store(c + i + static_cast<std::size_t>(k * lanes), cosine);
            L::store(s + i + static_cast<std::size_t>(k * lanes), sine);
        }
}

double yardstick(std::size_t n) {
    std::vector<double> c(n), s(n);
    return least(n, 1000, true,
                 [&](const std::vector<double>& t) { sines(t.data(), n, c.data(), s.data()); });
}

template <class Scene> void rows(const char* name, double eps) {
    const Scene scene(eps);
    Tables tables;
    if (tables.build(scene) != Status::ok) return;
    const View& w = tables.view();
    const double million = yardstick(1000000), block = yardstick(4096), end = w.reach;
    std::vector<double> out[3];
    for (auto& o : out) o.resize(1000000);
    double* all[most_outputs] = {out[0].data(), out[1].data(), out[2].data()};
    unsigned adds = 0;
    for (unsigned r = 0; r < w.rows; ++r) adds += w.row[r].degree + 1;
    std::printf("%s, eps %g: %u rows, %u multiply-adds, %d pieces, %zu bytes\n", name, eps, w.rows, adds,
                w.last + 1, tables.bytes());
    const auto print = [&](const char* what, double ns, double unit) {
        std::printf("  %-42s %8.2f ns %7.2f x sincos\n", what, ns, ns / unit);
    };
    const auto timed = [&](std::size_t n, bool sorted, double* const* to) {
        return least(n, end, sorted,
                     [&](const std::vector<double>& t) { batch(w, t.data(), n, to, nullptr, nullptr); });
    };
    print("sincos, 10^6; blocks of 4096 below", million, million);
    print("sincos, 4096", block, block);
    print("sorted, 10^6", timed(1000000, true, all), million);
    print("sorted, 4096", timed(4096, true, all), block);
    double* last[most_outputs] = {nullptr, all[1], all[2]};
    print("sorted, 10^6, without the first output", timed(1000000, true, last), million);
    print("any order, 10^6", timed(1000000, false, all), million);
    print("any order, 4096", timed(4096, false, all), block);
    const double copy = least(1000000, end, true, [&](const std::vector<double>& t) {
        for (std::size_t i = 0; i < t.size(); ++i) {
            const double x = t[i];
            out[0][i] = x;
            out[1][i] = x;
            out[2][i] = x;
        }
        sink = out[0][17];
    });
    const double dt = end / 1000000;
    const double in_grid = least(1000000, end, true, [&](const std::vector<double>& t) {
        grid(w, t[0] * 1e-3, dt * 0.999, t.size(), all, nullptr, nullptr);
    });
    std::printf("  %-42s %8.2f ns %7.2f x one read, three writes (%.2f ns)\n", "grid, 10^6", in_grid,
                in_grid / copy, copy);
    double values[most_outputs] = {};
    const double single = least(4096, end, false, [&](const std::vector<double>& t) {
        for (const double x : t) {
            one(w, x, values);
            sink = values[0];
        }
    });
    const double libm = least(4096, end, false, [&](const std::vector<double>& t) {
        for (const double x : t) sink = std::sin(x) + std::cos(x);
    });
    std::printf("  %-42s %8.2f ns %7.2f x sin and cos of libm (%.2f ns)\n", "one call", single, single / libm,
                libm);
    double building = 1e300;
    for (int r = 0; r < 100; ++r) {
        const auto start = std::chrono::steady_clock::now();
        const Scene again(eps);
        Tables built;
        built.build(again);
        building = std::min(building, bench::seconds_since(start));
    }
    std::printf("  %-42s %8.2f us\n", "construction", building * 1e6);
}

} // namespace

int main() {
    std::printf("width: %d doubles\n", lanes);
    rows<test::Pendulum<double>>("pendulum, order 3", 1e-3);
    rows<test::Pendulum<double>>("pendulum, order 3", 1e-2);
    rows<test::TwoPhases<double>>("two phases, 20 rows", 1e-2);
    rows<test::ThreePhases<double>>("three phases, 31 rows", 1e-2);
    rows<test::Pendulum<double>>("pendulum, phase to 10^12", 1e-12);
}
