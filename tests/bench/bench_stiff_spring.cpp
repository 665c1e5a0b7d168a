// SPDX-License-Identifier: GPL-3.0-or-later
// What a final point of the stiff spring costs, of the emitted code with its rate K for an argument and of
// CVODE's BDF where it is as accurate: build/release/tests/bench_stiff_spring. Starts and construction are in
// both; the least of many.
#include "bench/measure.hpp"
#include "support/program.hpp"
#include "verify/evaluate/ensemble.hpp"
#include "verify/integrate/integrate.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace resonform {
namespace {

constexpr double eps = 0.01;
constexpr std::size_t calls = 32;            // between two looks at the clock
const std::vector<std::size_t> wanted{0, 2}; // x and y among x, x', y, y'
const std::vector<double> start{1, 0, 1, 0};
const std::filesystem::path cache = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";

using Point = std::array<double, 2>;

double distance(const Point& a, const Point& b) {
    return std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
}

class Emitted {
public:
    explicit Emitted(const Scene& scene)
        : library_(build_program(test::solution_of(scene), scene, {false, false, false, {}}), cache, {}) {}

    Point operator()(double k, double t) {
        std::vector<const double*> arguments(2 + start.size(), nullptr);
        arguments[0] = &eps;
        arguments[1] = &k;
        Point point{};
        unsigned char status = 0;
        seconds_ = bench::least_seconds([&] {
                       for (std::size_t call = 0; call < calls; ++call)
                           library_.evaluate(arguments, 1, &t, {&point[0], &point[1]}, &status);
                   }) /
                   static_cast<double>(calls);
        return point;
    }
    // Of the last point.
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    EnsembleLibrary library_;
    double seconds_ = 0;
};

// In x, x', y and y'/K: with y' itself, the rounding errors of its rate, of size K^2, keep CVODE from the
// accuracy at K = 10^8.
void spring(const void* rate, const double* s, double* d) {
    const double k = *static_cast<const double*>(rate);
    d[0] = s[1];
    d[1] = -s[0] + eps * (s[0] * s[2] - s[0] * s[0] * s[0]);
    d[2] = k * s[3];
    d[3] = k * (eps * s[0] * s[0] - 2 * s[2] - 2 * s[3]);
}

struct Rival {
    double tolerance = 0, error = 0, seconds = 0;
    std::size_t steps = 0;
};

// With the largest tolerance 2^-n that reaches the accuracy.
Rival cvode(double k, double t, const Point& exact, double accuracy) {
    Rival rival;
    for (double tolerance = 0.25; tolerance > 1e-12; tolerance /= 2) {
        std::vector<std::vector<double>> values(2, std::vector<double>(1));
        Run run;
        const auto task = [&] {
            run = make_integrator(Method::cvode_bdf, {&spring, &k}, {start, tolerance, wanted})
                      ->run({t}, values);
        };
        task();
        rival.tolerance = tolerance;
        rival.error = distance({values[0][0], values[1][0]}, exact);
        if (!run.failure.empty() || rival.error > accuracy) continue;
        rival.steps = run.steps;
        rival.seconds = bench::least_seconds(task);
        return rival;
    }
    return {};
}

void table() {
    const Scene scene = test::scene_of("stiff_spring", "stiff");
    const Tape rates = Tape::rates(solve_for_highest(scene.system));
    Emitted emitted(scene);
    fmt::print("     K     t | emitted: error      us | CVODE BDF: tol.    error      us  steps | ratio\n");
    for (const double k : {1e3, 1e8}) {
        for (const auto& [name, t] :
             {std::pair("0.1/K", 0.1 / k), std::pair("1/K", 1 / k), std::pair("10/K", 10 / k),
              std::pair("1", 1.0), std::pair("1/eps", 1 / eps)}) {
            const auto reference =
                integrate_implicit<DoubleDouble>(rates, {DoubleDouble(k)}, DoubleDouble(eps),
                                                 {start.begin(), start.end()}, {DoubleDouble(t)}, 1e-25);
            const Point exact{to_double_value(reference.values[0][0]),
                              to_double_value(reference.values[2][0])};
            const double error = distance(emitted(k, t), exact);
            const Rival rival = cvode(k, t, exact, error);
            fmt::print("{:6.0e} {:>5} | {:14.2e} {:7.1f} | {:15.1e} {:8.2e} {:7.1f} {:6} | {:5.2f}\n", k,
                       name, error, emitted.seconds() * 1e6, rival.tolerance, rival.error,
                       rival.seconds * 1e6, rival.steps, rival.seconds / emitted.seconds());
        }
    }
}

} // namespace
} // namespace resonform

int main() {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    resonform::table();
}
