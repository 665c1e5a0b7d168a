// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/members.hpp"

#include "emit/cpp/cpp.hpp"
#include "emit/cpp/names.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace resonform::bench {

namespace {

// Prints three times. Starts differ by a tenth, end times by a fifth.
constexpr const char* program_text = R"(
#include "scene.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <tuple>
#include <vector>

using Scene = SCENE::Evaluator<double>;
constexpr std::size_t starts = sizeof(Scene::Start) / sizeof(double), values = sizeof(Scene::Values) / sizeof(double);

template <class Task> double least(std::size_t n, int repetitions, const Task& task) {
    double best = 1e300;
    for (int r = 0; r < repetitions; ++r) {
        const auto begin = std::chrono::steady_clock::now();
        task();
        best = std::min(best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
    }
    return best / double(n);
}

int main(int, char** argv) {
    const double one = std::atof(argv[1]);
    Scene::Values first; // as many members as take 40 ms
    const double ns = least(1, 9, [&] { Scene::at_end(one, {}, Scene::default_start(one, {}), 0.5 / one, first); });
    const std::size_t n = std::clamp<std::size_t>(std::size_t(4e7 / ns), 64, 20000);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> part(0, 1);
    std::vector<double> eps(n, one), t(n);
    std::vector<Scene::Start> all(n, Scene::default_start(one, {}));
    std::vector<std::vector<double>> start(starts, std::vector<double>(n)), out(values, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
        t[i] = Scene::default_slow_time_end(one, {}) / one * (1 - part(random) / 5);
        double* fields = reinterpret_cast<double*>(&all[i]);
        for (std::size_t k = 0; k < starts; ++k) start[k][i] = fields[k] = fields[k] * (1 + part(random) / 10);
    }
    Scene::Members members;
    const double** arrays = reinterpret_cast<const double**>(&members);
    arrays[0] = eps.data();
    for (std::size_t k = 0; k < starts; ++k) arrays[k + 1] = start[k].data();
    std::array<double*, values> to;
    for (std::size_t k = 0; k < values; ++k) to[k] = out[k].data();
    const double alone = least(n, 9, [&] {
        Scene::Values at;
        for (std::size_t i = 0; i < n; ++i) {
            Scene::at_end(one, {}, all[i], t[i], at);
            out[0][i] = reinterpret_cast<const double*>(&at)[0];
        }
    });
    double times[2];
    for (const bool full : {false, true}) {
        [full](auto& m) {
            if constexpr (requires { m.full_phase; }) m.full_phase = full;
        }(members);
        times[full] = least(n, 9, [&] { std::apply([&](auto*... o) { Scene::ensemble(n, members, t.data(), o...); }, to); });
    }
    std::printf("%.17g %.17g %.17g\n", alone, times[0], times[1]);
}
)";

bool supports(const std::string& march) {
    if (march == "x86-64-v4") return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    return march == "x86-64" || (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));
}

} // namespace

std::vector<MemberTimes> time_members(const Program& program, const std::string& march,
                                      const std::vector<double>& eps) {
    if (!supports(march) || !program.parameters.empty()) return {};
    const std::filesystem::path folder =
        std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache" / "members";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.hpp") << emit_cpp(program, {});
    std::ofstream(folder / "main.cpp") << program_text;
    const std::string compile = fmt::format(
        "cd '{0}' && {1} -std=gnu++20 -O2 -march={2} -DSCENE={3} -I. -I'{4}/engine' main.cpp -o main",
        folder.string(), RESONFORM_CXX_COMPILER, march, cpp_namespace(program.system, program.scene),
        RESONFORM_SOURCE_DIR);
    if (std::system(compile.c_str()) != 0) return {};
    std::vector<MemberTimes> all;
    for (const double one : eps) {
        FILE* pipe = popen(fmt::format("'{}/main' {:.17g}", folder.string(), one).c_str(), "r");
        if (pipe == nullptr) return {};
        MemberTimes times;
        const bool read = std::fscanf(pipe, "%lf %lf %lf", &times.alone, &times.plain, &times.full) == 3;
        if (pclose(pipe) != 0 || !read) return {};
        all.push_back(times);
    }
    return all;
}

} // namespace resonform::bench
