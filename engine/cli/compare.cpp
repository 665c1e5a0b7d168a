// SPDX-License-Identifier: GPL-3.0-or-later
// resonform compare SCENE: error against run time, beside direct integrators.
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "verify/report/json.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

int run_compare(const std::string& scene, const std::string& eps, const DerivationLimits& limits,
                const std::string& format) {
    const std::vector<Rational> asked = eps.empty() ? std::vector<Rational>() : read_eps_list(eps);
    const Home home = find_home();
    const SceneLine line = solve_scene(scene, home, limits);
    const CacheFolder cache(home);
    auto options = with_progress<CompareOptions>(cache);
    if (!asked.empty()) options.eps = asked;
    const Comparison comparison = compare(line.expanded.first_order, line.scene, line.solution, options);
    put("{}", format == "json" ? document_text(to_json(comparison)) : to_text(comparison));
    return done;
}

} // namespace

void add_compare(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("compare", "error against run time, beside direct integrators");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const Text eps =
        add_text(*command, "--eps", "E1,E2,...", "values of eps, such as 0.01,1/1000; default: 0.001");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] { return run_compare(*scene, *eps, limits.value(), format.value()); });
}

} // namespace resonform
