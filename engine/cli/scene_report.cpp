// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_report.hpp"

#include "cli/output.hpp"
#include "cli/verify_apart.hpp"
#include "verify/comparison/comparison.hpp"
#include "verify/report/plot.hpp"
#include "verify/stability/stability.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace resonform {

namespace {

std::vector<report::Figure> figures_of(const report::Page& page) {
    std::vector<report::Figure> figures;
    for (const report::Section& section : page.sections)
        for (const report::Block& block : section.blocks)
            if (const auto* gallery = std::get_if<report::Gallery>(&block))
                figures.insert(figures.end(), gallery->figures.begin(), gallery->figures.end());
    return figures;
}

} // namespace

VerifyOptions verify_options(const CacheFolder& cache, const DerivationLimits& limits) {
    auto options = with_progress<VerifyOptions>(cache);
    options.guarantee = [limits](const Scene& s, const Solution& solution, const Claims& claims) {
        return guarantees_apart(s, solution, claims, limits);
    };
    options.estimate = [limits](const Scene& s, const Solution& solution, const std::vector<Rational>& eps) {
        return error_estimates_apart(s, solution, eps, limits);
    };
    return options;
}

report::Findings findings_of(const SceneLine& line, Verification verification, const CacheFolder& cache,
                             report::Origin origin, bool timed) {
    const auto& system = line.expanded.first_order;
    report::Findings findings{system, &line.scene, &line.solution,   std::move(verification),
                              {},     {},          std::move(origin)};
    if (timed) {
        auto all_orders = with_progress<CompareOptions>(cache);
        for (int order = 1; order <= line.scene.order; ++order) all_orders.orders.push_back(order);
        findings.comparison = compare(system, line.scene, line.solution, all_orders);
    }
    findings.stability = stability(line.scene, line.solution, with_progress<StabilityOptions>(cache));
    return findings;
}

bool figures_can_be_drawn() {
    const std::string why_not = why_no_plots();
    if (why_not.empty()) return true;
    say(fmt::format("resonform: {}, so the report will have no figures (Debian: gnuplot-nox)", why_not));
    return false;
}

std::vector<TextFile> markdown_files(const std::filesystem::path& folder, const report::Page& page) {
    std::vector<TextFile> files{{folder / "report.md", report::to_markdown(page)}};
    for (const report::Figure& figure : figures_of(page))
        files.push_back({folder / "figures" / (figure.name + ".svg"), figure.svg});
    return files;
}

std::vector<TextFile> report_files(const std::filesystem::path& folder, const report::Page& page) {
    std::vector<TextFile> files = markdown_files(folder, page);
    files.push_back({folder / "report.html", report::to_html(page)});
    for (const report::Figure& figure : figures_of(page))
        files.push_back({folder / "figures" / (figure.name + ".csv"), figure.csv});
    return files;
}

} // namespace resonform
