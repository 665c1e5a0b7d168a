// SPDX-License-Identifier: GPL-3.0-or-later
// One random scene tried: derived, certified, held against 50 digits and against direct integration, and then
// with one change planted in it, which must change the exit code.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace resonform::test {

struct SceneResult {
    std::uint64_t seed = 0;
    std::string roles;
    int order = 0;
    int refused = 0;         // scenes of this seed that the engine refused, before one that it answered
    std::string reason;      // of the last of them
    std::string wrong;       // "" if all is right
    std::size_t points = 0;  // at which emitted code was held against 50 digits, of all types
    double ulp = 0;          // the worst in double
    double ulp_extended = 0; // and in long double
    std::string ladder;      // "pass", or "undecided: ..."
    std::string change, caught_by;
    int without_effect = 0; // changes drawn before, which moved no output by twice the threshold
    double seconds = 0;
};

struct TrialOptions {
    std::filesystem::path folder; // for files and cache; its own
    bool compiled = false;        // what is emitted is compiled; else the interpreter stands for it
    std::size_t starts = 50;      // of emitted = symbolic
    std::function<void(const std::string&)> enter = [](const std::string&) {}; // what is under way
};

SceneResult try_scene(std::uint64_t seed, const TrialOptions& options);

} // namespace resonform::test
