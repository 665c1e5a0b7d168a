// SPDX-License-Identifier: GPL-3.0-or-later
// Many random scenes, each in a process of its own: what crashes or never ends is one of the results.
#pragma once

#include "fuzz/scene_trial.hpp"

#include <functional>
#include <map>
#include <vector>

namespace resonform::test {

struct RunOptions {
    std::vector<std::uint64_t> seeds;
    double seconds = 60;          // of processor time, of a scene: what takes longer is ended
    std::size_t starts = 50;      // of emitted = symbolic
    std::uint64_t compiled = 0;   // every so many scenes are compiled; 0: none
    std::filesystem::path folder; // for a folder of each scene, which is removed
};

struct RunSummary {
    std::size_t scenes = 0, right = 0, refused = 0, too_long = 0, undecided = 0, points = 0,
                without_effect = 0;
    std::size_t wrong = 0; // crashes and uncaught changes among them
    double ulp = 0, ulp_extended = 0;
    std::map<std::string, std::size_t> caught_by;
};

// result.wrong of a scene that is ended is too_long.
inline const std::string too_long = "too long";
RunSummary run_scenes(const RunOptions& options, const std::function<void(const SceneResult&)>& tell);

std::string to_line(const SceneResult& result);
std::string to_text(const RunSummary& summary);

} // namespace resonform::test
