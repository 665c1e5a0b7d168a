// SPDX-License-Identifier: GPL-3.0-or-later
// resonform verify SCENE [--report DIR]: the eps-ladder of every output, and a report to look at.
#include "cli/command.hpp"
#include "cli/pipeline.hpp"
#include "cli/progress.hpp"
#include "verify/json.hpp"
#include "verify/report.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

int run_verify(const std::string& scene, const std::string& report, const std::string& format) {
    const Home home = find_home();
    if (!report.empty()) make_folder(report);
    const SceneLine line = solve_scene(scene, home);
    const VerifyOptions options{home.cache(), show_progress};
    const Verification verification = verify(line.expanded.first_order, line.scene, line.solution, options);
    fmt::print("{}", format == "json" ? to_json(verification).dump(2) + "\n" : to_text(verification));
    if (!report.empty()) {
        const std::filesystem::path folder = report;
        const Report pages =
            make_report(line.expanded.first_order, line.scene, line.solution, verification, options);
        write_file(folder / "report.html", pages.html);
        write_file(folder / "report.md", pages.markdown);
        show_progress(fmt::format("report: {}", (folder / "report.html").string()));
    }
    return verification.as_expected() ? done : check_failed;
}

} // namespace

void add_verify(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("verify", "the order of accuracy of a scene, against direct integration");
    const Text scene = add_required(*command, "SCENE", "the scene file");
    const Text report = add_text(*command, "--report", "write report.html and report.md into this folder");
    const Format format(*command, {"text", "json"});
    command->callback([&action, scene, report, format] {
        action = [scene, report, format] { return run_verify(*scene, *report, format.value()); };
    });
}

} // namespace resonform
