// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_scenes [--first N] [--scenes K] [--seconds S] [--starts J] [--compiled C] [--show N]: random scenes,
// by their seeds N, N + 1, ... Each is tried (fuzz/scene_trial.hpp) for S seconds at most, emitted = symbolic
// at J starts (50); every C-th is compiled, none if C is 0, where the interpreter stands for emitted code.
// --show prints the files of a seed. The exit code is 1 if anything is wrong.
#include "fuzz/random_scene.hpp"
#include "fuzz/scene_run.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

int usage() {
    std::fputs("usage: fuzz_scenes [--first N] [--scenes K] [--seconds S] [--starts J] [--compiled C] | "
               "--show N [ATTEMPT]\n",
               stderr);
    return 2;
}

int show(std::uint64_t seed, int attempt) {
    const auto written = resonform::test::random_scene(seed, attempt);
    std::printf("%s\n# scene\n%s", written.system.c_str(), written.scene.c_str());
    return 0;
}

} // namespace

int main(int count, char** words) {
    using namespace resonform::test;
    RunOptions options;
    std::uint64_t first = 1, scenes = 20;
    options.folder = std::filesystem::temp_directory_path();
    if (count >= 3 && std::strcmp(words[1], "--show") == 0)
        return show(std::strtoull(words[2], nullptr, 10), count > 3 ? std::atoi(words[3]) : 0);
    for (int k = 1; k < count; k += 2) {
        if (k + 1 == count) return usage();
        const std::string key = words[k];
        const double value = std::strtod(words[k + 1], nullptr);
        if (key == "--seconds")
            options.seconds = value;
        else if (key == "--first")
            first = static_cast<std::uint64_t>(value);
        else if (key == "--scenes")
            scenes = static_cast<std::uint64_t>(value);
        else if (key == "--starts")
            options.starts = static_cast<std::size_t>(value);
        else if (key == "--compiled")
            options.compiled = static_cast<std::uint64_t>(value);
        else
            return usage();
    }
    for (std::uint64_t k = 0; k < scenes; ++k) options.seeds.push_back(first + k);
    const RunSummary summary = run_scenes(options, [](const SceneResult& result) {
        std::printf("%s\n", to_line(result).c_str());
        std::fflush(stdout);
    });
    std::printf("\n%s", to_text(summary).c_str());
    return summary.wrong == 0 ? 0 : 1;
}
