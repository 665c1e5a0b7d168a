// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_scenes [--first N] [--scenes K] [--seconds S] [--starts J] [--compiled C] [--show N]: random scenes,
// by their seeds N, N + 1, ... Each is tried (fuzz/scene_trial.hpp) for S seconds at most, emitted = symbolic
// at J starts (50); every C-th is compiled, none if C is 0, where the interpreter stands for emitted code.
// --show prints the files of a seed.
//
// fuzz_scenes --coverage K [--verified M] [--first N] [--seconds S]: K random systems
// (fuzz/random_system.hpp) are derived, solved and emitted, each for S seconds at most, and M of them
// verified, each for 10 S; the table of reasons of refusal is printed behind a line for each. --show-system
// prints the files of a seed.
//
// The exit code is 1 if anything is wrong.
#include "fuzz/coverage.hpp"
#include "fuzz/random_scene.hpp"
#include "fuzz/random_system.hpp"
#include "fuzz/scene_run.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

int usage() {
    std::fputs(
        "usage: fuzz_scenes [--first N] [--scenes K] [--seconds S] [--starts J] [--compiled C] | "
        "--coverage K [--verified M] [--first N] [--seconds S] | --show N [ATTEMPT] | --show-system N\n",
        stderr);
    return 2;
}

int show(const resonform::test::WrittenScene& written) {
    std::printf("%s\n# scene\n%s", written.system.c_str(), written.scene.c_str());
    return 0;
}

void say(const std::string& line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}

int cover(const resonform::test::CoverageOptions& options) {
    const auto all = covered(options, [](const auto& system) { say(to_line(system)); });
    say("\n" + to_text(all));
    return all.faults.empty() ? 0 : 1;
}

} // namespace

int main(int count, char** words) {
    using namespace resonform::test;
    RunOptions options;
    CoverageOptions coverage;
    std::uint64_t scenes = 20;
    options.folder = coverage.folder = std::filesystem::temp_directory_path();
    if (count >= 3 && std::strcmp(words[1], "--show") == 0)
        return show(random_scene(std::strtoull(words[2], nullptr, 10), count > 3 ? std::atoi(words[3]) : 0));
    if (count == 3 && std::strcmp(words[1], "--show-system") == 0)
        return show(random_system(std::strtoull(words[2], nullptr, 10)));
    for (int k = 1; k < count; k += 2) {
        if (k + 1 == count) return usage();
        const std::string key = words[k];
        const double value = std::strtod(words[k + 1], nullptr);
        if (key == "--seconds") {
            options.seconds = coverage.seconds = value;
            coverage.verify_seconds = 10 * value;
        } else if (key == "--first")
            coverage.first = static_cast<std::uint64_t>(value);
        else if (key == "--scenes")
            scenes = static_cast<std::uint64_t>(value);
        else if (key == "--coverage")
            coverage.systems = static_cast<std::size_t>(value);
        else if (key == "--verified")
            coverage.verified = static_cast<std::size_t>(value);
        else if (key == "--starts")
            options.starts = static_cast<std::size_t>(value);
        else if (key == "--compiled")
            options.compiled = static_cast<std::uint64_t>(value);
        else
            return usage();
    }
    if (coverage.systems > 0) return cover(coverage);
    for (std::uint64_t k = 0; k < scenes; ++k) options.seeds.push_back(coverage.first + k);
    const RunSummary summary = run_scenes(options, [](const SceneResult& result) { say(to_line(result)); });
    say("\n" + to_text(summary));
    return summary.wrong == 0 ? 0 : 1;
}
