// SPDX-License-Identifier: GPL-3.0-or-later
// resonform stability SCENE: the emitted evaluator against 50 digits over many decades of its inputs.
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "verify/json.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

int run_stability(const std::string& scene, const DerivationLimits& limits, const std::string& format) {
    const Home home = find_home();
    const SceneLine line = solve_scene(scene, home, limits);
    const CacheFolder cache(home);
    const Stability sweep = stability(line.scene, line.solution, with_progress<StabilityOptions>(cache));
    put("{}", format == "json" ? to_json(sweep).dump(2) + "\n" : to_text(sweep));
    return done;
}

} // namespace

void add_stability(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("stability", "rounding of the emitted evaluator over many decades");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    command->callback([&action, scene, format, limits] {
        action = [scene, format, limits] { return run_stability(*scene, limits.value(), format.value()); };
    });
}

} // namespace resonform
