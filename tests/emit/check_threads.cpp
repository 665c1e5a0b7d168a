// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of one evaluator from several threads, copies taken meanwhile, under the thread sanitizer.
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// Prints the rounds in which threads got different numbers.
constexpr const char* race_program = R"(
#include "generated/almost_holonomic_pendulum/third_order.hpp"
#include "generated/henon_heiles/third_order.hpp"

#include <atomic>
#include <cstdio>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

template <class Scene> void race(const char* name) {
    constexpr std::size_t values = sizeof(typename Scene::Values) / sizeof(double), points = 300;
    for (int round = 0; round < 5; ++round) {
        const Scene shared(0.01);
        std::atomic<int> waiting{8};
        std::vector<std::thread> threads;
        std::vector<std::vector<double>> seen(8);
        for (std::size_t k = 0; k < 8; ++k)
            threads.emplace_back([&, k] {
                std::vector<double> t(points), eps(points, 0.01);
                for (std::size_t i = 0; i < points; ++i) t[i] = 0.3 * double(i);
                std::vector<std::vector<double>> out(values, std::vector<double>(points));
                std::array<double*, values> to;
                for (std::size_t i = 0; i < values; ++i) to[i] = out[i].data();
                const auto call = [&](auto&& function) { std::apply(function, to); };
                typename Scene::Values one;
                typename Scene::Members members;
                members.eps = eps.data();
                --waiting;
                while (waiting > 0) std::this_thread::yield();
                if (k % 4 == 0) call([&](auto*... o) { shared.batch(t.data(), points, o...); });
                if (k % 4 == 1) call([&](auto*... o) { shared.grid(0, 0.3, points, o...); });
                if (k % 4 == 2) {
                    const Scene copy(shared);
                    call([&](auto*... o) { copy.batch(t.data(), points, o...); });
                    Scene other(0.02);
                    other = shared;
                    other.prepare();
                }
                if (k % 4 == 3) {
                    shared(1.0, one);
                    shared.prepare();
                    Scene::at_end(0.01, {}, Scene::default_start(0.01, {}), 3.0, one);
                    call([&](auto*... o) { Scene::ensemble(points, members, t.data(), o...); });
                }
                seen[k] = out[0];
            });
        for (std::thread& thread : threads) thread.join();
        if (seen[0] != seen[4] || seen[0] != seen[2] || seen[3] != seen[7])
            std::printf("%s, round %d\n", name, round);
    }
}

template <class Scene> void move(const char* name) {
    Scene from(0.01);
    const Scene to(std::move(from));
    typename Scene::Values values;
    if (to(1.0, values) != resonform::Status::ok) std::printf("%s: moved\n", name);
    for (const Scene& none : {from, Scene(from)})
        if (none(1.0, values) != resonform::Status::outside_interval) std::printf("%s: moved from\n", name);
    from.prepare();
    from = to;
    if (from(1.0, values) != resonform::Status::ok) std::printf("%s: assigned\n", name);
}

int main() {
    move<resonform::generated::almost_holonomic_pendulum::third_order::Evaluator<double>>("pendulum");
    move<resonform::generated::henon_heiles::third_order::Evaluator<double>>("Henon-Heiles");
    race<resonform::generated::almost_holonomic_pendulum::third_order::Evaluator<double>>("pendulum");
    race<resonform::generated::henon_heiles::third_order::Evaluator<double>>("Henon-Heiles");
}
)";

TEST(SlowThreads, ShareAnEvaluator) {
    const test::Scratch scratch;
    test::write(scratch.path() / "main.cpp", race_program);
    const std::string root = RESONFORM_SOURCE_DIR;
    const test::Outcome outcome =
        test::run(std::string(RESONFORM_CXX_COMPILER) + " -std=gnu++20 -O1 -fsanitize=thread -I'" + root +
                      "' -I'" + root + "/engine' main.cpp -o main && setarch -R ./main",
                  scratch.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err.substr(0, 3000);
    EXPECT_EQ(outcome.out, "");
}

} // namespace
} // namespace resonform
