// SPDX-License-Identifier: GPL-3.0-or-later
// resonform verify SCENE [--report DIR]: the eps-ladder of every output, and a report to look at.
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "verify/json.hpp"
#include "verify/report.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

// report.html; report.md with figures/*.svg.
void write_report(const std::filesystem::path& folder, const report::Page& page) {
    make_folder(folder);
    write_file(folder / "report.html", report::to_html(page));
    write_file(folder / "report.md", report::to_markdown(page));
    make_folder(folder / "figures");
    for (const report::Section& section : page.sections)
        for (const report::Block& block : section.blocks)
            if (const auto* gallery = std::get_if<report::Gallery>(&block))
                for (const report::Figure& figure : gallery->figures)
                    write_file(folder / "figures" / (figure.name + ".svg"), figure.svg);
    show_progress(fmt::format("report: {}", (folder / "report.html").string()));
}

// Before hours of integration: what write_report will do can be done.
void require_place_for_report(const std::filesystem::path& folder) {
    require_writable_folder(folder);
    require_writable_folder(folder / "figures");
}

int run_verify(const std::string& scene, const std::string& folder, const DerivationLimits& limits,
               const std::string& format) {
    const Home home = find_home();
    if (!folder.empty()) require_place_for_report(folder);
    const SceneLine line = solve_scene(scene, home, limits);
    const CacheFolder cache(home);
    const auto& system = line.expanded.first_order;
    const auto options = with_progress<VerifyOptions>(cache);
    const Verification verification = verify(system, line.scene, line.solution, options);
    put("{}", format == "json" ? to_json(verification).dump(2) + "\n" : to_text(verification));
    finish_results(); // the verdicts are there while the report is still being made
    if (!folder.empty())
        write_report(folder,
                     report::make_report(
                         {system, &line.scene, &line.solution, verification,
                          compare(system, line.scene, line.solution, with_progress<CompareOptions>(cache)),
                          stability(line.scene, line.solution, with_progress<StabilityOptions>(cache))},
                         options));
    return verification.as_expected() ? done : check_failed;
}

} // namespace

void add_verify(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("verify", "the order of accuracy of a scene, against direct integration");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const Text folder =
        add_output(*command, "--report", "DIR",
                   "write report.html and report.md here; adds run times and the stability sweep");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    command->callback([&action, scene, folder, format, limits] {
        action = [scene, folder, format, limits] {
            return run_verify(*scene, *folder, limits.value(), format.value());
        };
    });
}

} // namespace resonform
