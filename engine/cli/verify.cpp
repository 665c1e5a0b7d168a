// SPDX-License-Identifier: GPL-3.0-or-later
// resonform verify SCENE [--report DIR]: the eps-ladder of every output, and a report to look at.
#include "algebra/number/error.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/complaint.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/verify_apart.hpp"
#include "cli/watch.hpp"
#include "verify/report/json.hpp"
#include "verify/report/plot.hpp"
#include "verify/report/report.hpp"
#include "verify/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>

namespace resonform {

namespace {

// report.html; report.md with figures/*.svg, if there are any.
void write_report(const std::filesystem::path& folder, const report::Page& page) {
    std::vector<TextFile> files{{folder / "report.html", report::to_html(page)},
                                {folder / "report.md", report::to_markdown(page)}};
    for (const report::Section& section : page.sections)
        for (const report::Block& block : section.blocks)
            if (const auto* gallery = std::get_if<report::Gallery>(&block))
                for (const report::Figure& figure : gallery->figures)
                    files.push_back({folder / "figures" / (figure.name + ".svg"), figure.svg});
    write_files(files);
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

SceneLine solve_for(const VerifyRequest& request, const Home& home) {
    return watched(request.limits, [&](Watch& watch) {
        Scene scene = read_scene_with_values(request.scene, home);
        if (!request.report.empty()) require_same_subject(request.report, scene);
        return solve_scene(std::move(scene), watch);
    });
}

bool figures_can_be_drawn() {
    const std::string why_not = why_no_plots();
    if (why_not.empty()) return true;
    say(fmt::format("resonform: {}, so the report will have no figures (Debian: gnuplot-nox)", why_not));
    return false;
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
    auto options = with_progress<VerifyOptions>(cache);
    options.liars = request.liars;
    options.guarantee = [&](const Scene& s, const Solution& solution, const Claims& claims) {
        return guarantees_apart(s, solution, claims, request.limits);
    };
    options.estimate = [&](const Scene& s, const Solution& solution, const std::vector<Rational>& eps) {
        return error_estimates_apart(s, solution, eps, request.limits);
    };
    const Verification verification = verify(system, line.scene, line.solution, options);
    put("{}", request.format == "json" ? document_text(to_json(verification)) : to_text(verification));
    finish_results(); // the verdicts are there while the report is still being made
    const int verdict = verification.as_expected() ? done : check_failed;
    if (!reported) return verdict;
    auto all_orders = with_progress<CompareOptions>(cache);
    const int one = line.scene.system->eps_root;
    for (int order = one; order <= line.scene.order; order += one) all_orders.orders.push_back(order);
    return std::max(
        verdict, run_behind_results([&] {
            write_report(request.report,
                         report::make_report(
                             {system, &line.scene, &line.solution, verification,
                              compare(system, line.scene, line.solution, all_orders),
                              stability(line.scene, line.solution, with_progress<StabilityOptions>(cache))},
                             options, drawn));
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
