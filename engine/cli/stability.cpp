// SPDX-License-Identifier: GPL-3.0-or-later
// resonform stability SCENE: the emitted evaluator against 50 digits over many decades of its inputs.
#include "verify/stability/stability.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "verify/report/json.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>

namespace resonform {

namespace {

constexpr std::uint64_t most_points_drawn = 1'000'000;

int run_stability(const std::string& scene, std::size_t points, std::uint64_t seed,
                  const DerivationLimits& limits, const std::string& format) {
    const Home home = find_home();
    const SceneLine line = solve_scene(scene, home, limits);
    const CacheFolder cache(home);
    auto options = with_progress<StabilityOptions>(cache);
    options.points = points;
    options.seed = seed;
    const Stability sweep = stability(line.scene, line.solution, options);
    put("{}", format == "json" ? document_text(to_json(sweep)) : to_text(sweep));
    return sweep.verdict == Verdict::pass ? done : check_failed;
}

} // namespace

void add_stability(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("stability", "rounding of the emitted evaluator over many decades");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const Text points = add_text(*command, "--points", "NUMBER", "points of the sweep, 6 to a start", "300");
    const Text seed =
        add_text(*command, "--seed", "NUMBER", "of the points: the same seed, the same points", "2");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_stability(*scene, read_integer("--points", *points, 1, most_points_drawn, 3000),
                             read_integer("--seed", *seed, 0, std::numeric_limits<std::uint64_t>::max(), 3),
                             limits.value(), format.value());
    });
}

} // namespace resonform
