// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_run.hpp"

#include "fuzz/apart.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <limits>

namespace resonform::test {

namespace {

nlohmann::json packed(const SceneResult& r) {
    return {r.seed, r.roles,        r.order,  r.refused, r.reason,    r.wrong,          r.points,
            r.ulp,  r.ulp_extended, r.ladder, r.change,  r.caught_by, r.without_effect, r.seconds};
}

SceneResult unpacked(const nlohmann::json& j) {
    const auto number = [](const nlohmann::json& n) { // infinity is null
        return n.is_null() ? std::numeric_limits<double>::infinity() : n.get<double>();
    };
    return {j[0],         j[1],         j[2], j[3],  j[4],  j[5],  j[6],
            number(j[7]), number(j[8]), j[9], j[10], j[11], j[12], number(j[13])};
}

SceneResult tried_apart(std::uint64_t seed, const TrialOptions& options, double seconds) {
    const Told told = told_apart(
        [&](const Tell& tell) {
            TrialOptions telling = options;
            telling.enter = tell; // what is under way; the last line is the result
            SceneResult result;
            try {
                result = try_scene(seed, telling);
            } catch (const std::exception& error) {
                result.seed = seed;
                result.wrong = error.what();
            }
            tell(packed(result).dump());
        },
        seconds);
    SceneResult result;
    result.seed = seed;
    switch (told.end) {
    case Told::End::finished: return unpacked(nlohmann::json::parse(told.last()));
    case Told::End::spent:
        result.wrong = too_long;
        result.reason = told.last();
        result.seconds = seconds;
        break;
    case Told::End::crashed:
        result.wrong = fmt::format("the process ended with status {} in {}", told.status, told.last());
    }
    return result;
}

void count(const SceneResult& r, RunSummary& s) {
    ++s.scenes;
    s.refused += static_cast<std::size_t>(r.refused);
    s.points += r.points;
    s.without_effect += static_cast<std::size_t>(r.without_effect);
    s.ulp = std::max(s.ulp, r.ulp);
    s.ulp_extended = std::max(s.ulp_extended, r.ulp_extended);
    if (r.wrong == too_long) {
        ++s.too_long;
    } else if (!r.wrong.empty()) {
        ++s.wrong;
    } else {
        ++s.right;
        ++s.caught_by[r.caught_by];
        if (r.ladder != "pass") ++s.undecided;
    }
}

} // namespace

RunSummary run_scenes(const RunOptions& options, const std::function<void(const SceneResult&)>& tell) {
    RunSummary summary;
    for (const std::uint64_t seed : options.seeds) {
        TrialOptions trial;
        trial.folder = options.folder / fmt::format("scene_{}_{}", getpid(), seed);
        trial.starts = options.starts;
        trial.compiled = options.compiled > 0 && seed % options.compiled == 0;
        std::filesystem::create_directories(trial.folder);
        const SceneResult result = tried_apart(seed, trial, options.seconds);
        std::filesystem::remove_all(trial.folder);
        count(result, summary);
        tell(result);
    }
    return summary;
}

std::string to_line(const SceneResult& r) {
    std::string line = fmt::format(
        "{:>5}  order {}  {:<28} {:>2} refused  {:>5} points  {:>8.3g} {:>8.3g} ulp  {:>5.1f} s  ", r.seed,
        r.order, r.roles, r.refused, r.points, r.ulp, r.ulp_extended, r.seconds);
    if (r.wrong == too_long)
        return fmt::format("{:>5}  ended after {:.0f} s in {}", r.seed, r.seconds, r.reason);
    if (!r.wrong.empty()) return line + "WRONG: " + r.wrong;
    line += fmt::format("{}: {}", r.caught_by, r.change);
    return r.ladder == "pass" ? line : line + "; ladder " + r.ladder;
}

std::string to_text(const RunSummary& s) {
    std::string text = fmt::format(
        "{} scenes: {} right, {} wrong, {} ended after their time; {} others were refused, {} ladders are "
        "undecided\n"
        "{} points, at most {:.3g} ulp in double and {:.3g} in long double\nchanges caught:",
        s.scenes, s.right, s.wrong, s.too_long, s.refused, s.undecided, s.points, s.ulp, s.ulp_extended);
    for (const auto& [check, times] : s.caught_by) text += fmt::format(" {} by {},", times, check);
    return text + fmt::format(" {} others were without effect\n", s.without_effect);
}

} // namespace resonform::test
