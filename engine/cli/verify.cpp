// SPDX-License-Identifier: GPL-3.0-or-later
// resonform verify SCENE [--report DIR]: the eps-ladder of every output, and a report to look at.
#include "algebra/number/error.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/complaint.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/origin.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/scene_report.hpp"
#include "cli/watch.hpp"
#include "verify/report/json.hpp"
#include "verify/report/report.hpp"
#include "verify/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>

namespace resonform {

namespace {

// report.html; report.md with figures/*.svg and their numbers in figures/*.csv, if there are any.
void write_report(const std::filesystem::path& folder, const report::Page& page) {
    write_files(report_files(folder, page));
    show_progress(fmt::format("report: {}", (folder / "report.html").string()));
}

// Checks before hours of integration that write_report() will be able to write.
void require_place_for_report(const std::filesystem::path& folder) {
    require_writable_folder(folder);
    require_writable_folder(folder / "figures");
}

// A report is replaced by a newer one of the same scene, and by nothing else.
void require_same_subject(const std::filesystem::path& folder, const Scene& scene) {
    const std::string own = report::escaped(scene.system->name + "/" + scene.name);
    for (const char* name : {"report.md", "report.html"}) { // names are spelled in full in the first
        std::error_code ignored;
        if (!std::filesystem::exists(folder / name, ignored)) continue;
        const std::string found = report::subject_of(read_file(folder / name));
        if (found == own) return;
        bad_argument("--report", "the folder must not hold the report of another scene",
                     (folder / name).string() + (found.empty() ? "" : " of " + found),
                     "give another folder, or delete that report");
    }
}

struct VerifyRequest {
    std::string scene;
    std::filesystem::path report; // empty: none
    DerivationLimits limits;
    std::string format;
    bool liars;
};

// The command that makes it again.
std::string spelled(const VerifyRequest& request) {
    return fmt::format("resonform verify {} --report {}{}", request.scene, request.report.string(),
                       request.liars ? " --liars" : "");
}

SceneLine solve_for(const VerifyRequest& request, const Home& home) {
    return watched(request.limits, [&](Watch& watch) {
        Scene scene = read_scene_with_values(request.scene, home);
        if (!request.report.empty()) require_same_subject(request.report, scene);
        return solve_scene(std::move(scene), watch);
    });
}

// Runs work after the verdicts. Its errors go to standard error only: the JSON document is already out.
int run_behind_results(const std::function<void()>& work) {
    try {
        work();
        return done;
    } catch (...) {
        const Error error = error_of(std::current_exception());
        say_error(error);
        return static_cast<int>(error.kind());
    }
}

int run_verify(const VerifyRequest& request) {
    const Home home = find_home();
    const bool reported = !request.report.empty();
    if (reported) require_place_for_report(request.report);
    const bool drawn = reported && figures_can_be_drawn();
    const SceneLine line = solve_for(request, home);
    const CacheFolder cache(home);
    const auto& system = line.expanded.first_order;
    VerifyOptions options = verify_options(cache, request.limits);
    options.liars = request.liars;
    const Verification verification = verify(system, line.scene, line.solution, options);
    put("{}", request.format == "json" ? document_text(to_json(verification)) : to_text(verification));
    finish_results(); // the verdicts are there while the report is still being made
    const int verdict = verification.as_expected() ? done : check_failed;
    if (!reported) return verdict;
    return std::max(verdict, run_behind_results([&] {
                        const report::Findings findings =
                            findings_of(line, verification, cache, origin_of(spelled(request)));
                        write_report(request.report, report::make_report(findings, options, drawn));
                    }));
}

} // namespace

void add_verify(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("verify", "the order of accuracy of a scene, measured against direct integration");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const Text folder =
        add_output(*command, "--report", "DIR",
                   "write report.html and report.md here; adds run times and the stability sweep");
    const auto liars = std::make_shared<bool>(false);
    command->add_flag("--liars", *liars,
                      "change every coefficient in turn, and tell which check catches it; adds minutes");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_verify({*scene, *folder, limits.value(), format.value(), *liars});
    });
}

} // namespace resonform
