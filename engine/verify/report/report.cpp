// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/report.hpp"

#include "algebra/number/number.hpp"
#include "emit/derive/document.hpp"
#include "emit/program/build_program.hpp"
#include "solve/transgression.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/report/figures.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>

#include <regex>

namespace resonform::report {

namespace {

constexpr std::size_t curve_points = 1500;

// The scene with its two drift outputs only, oscillation left out; nullopt if it has no oscillation, or not
// exactly two drift outputs.
std::optional<Scene> mean_scene(const Scene& scene) {
    if (!scene.oscillating) return std::nullopt;
    Scene mean = scene;
    mean.oscillating = false;
    mean.name += "_mean";
    mean.outputs.clear();
    for (const std::string& output : scene.outputs) {
        const Variable* variable = scene.system->variable(output);
        if (variable != nullptr && variable->role == Role::drift) mean.outputs.push_back(output);
    }
    if (mean.outputs.size() != 2) return std::nullopt;
    return mean;
}

// The scene with the variables constant at eps = 0, slow ones and drifts, that have a start value as outputs.
std::optional<Scene> former_scene(const Scene& scene) {
    Scene former = scene;
    former.name += "_former";
    former.outputs.clear();
    for (const Variable& variable : scene.system->variables) {
        const bool starts = scene.start_of(variable.name) != nullptr ||
                            scene.start_of("constant." + variable.name) != nullptr;
        if (starts && (variable.role == Role::slow || variable.role == Role::drift))
            former.outputs.push_back(variable.name);
    }
    if (former.outputs.empty()) return std::nullopt;
    return former;
}

std::vector<MotionCurves> motions(const Findings& f, const VerifyOptions& options) {
    std::vector<MotionCurves> found;
    const std::optional<Scene> former = former_scene(*f.scene);
    const std::optional<Scene> mean = mean_scene(former ? *former : *f.scene);
    const auto curves = [&](const Scene& scene, const Rational& eps) {
        return error_curves(f.system, scene, *f.solution, eps, curve_points, options);
    };
    for (const char* text : drawn_eps) {
        const Rational eps = parse_rational(text);
        MotionCurves motion{curves(*f.scene, eps), std::nullopt, std::nullopt};
        if (mean) motion.mean = curves(*mean, eps);
        if (former) motion.former = curves(*former, eps);
        found.push_back(std::move(motion));
    }
    return found;
}

Section derived(const Findings& f) {
    const Normalization& normalization = *f.solution->normalization;
    const Certificate& certificate = normalization.certificate;
    return {
        "Normal form and solution",
        {Formulas{print_normal_form(normalization, f.scene->order, Format::latex, f.solution),
                  print_normal_form(normalization, f.scene->order, Format::text, f.solution)},
         Formulas{print_solution(*f.solution, Format::latex), print_solution(*f.solution, Format::text)},
         Paragraph{fmt::format(
             "Certificate: map and normal form, put into the original equations at {} random points "
             "modulo {} primes, leave no residual through weight {}; every monomial of the normal form is "
             "resonant and the map has none of them. A wrong result would pass with probability below {}.",
             certificate.points, certificate.primes.size(), to_string(certificate.through_weight),
             short_number(certificate.error_probability))}}};
}

Section emitted(const EmittedCheck& check) {
    Table table{"Emitted = symbolic",
                {"real type", "points", "answered", "largest difference, ulp", "output", "form", "at",
                 "of the scale for moved phases"},
                {},
                false};
    for (const EmittedInType& type : check.types) {
        std::string at;
        for (const auto& [name, value] : type.at)
            at += fmt::format("{}{} = {}", at.empty() ? "" : ", ", pretty(name), short_number(value));
        table.rows.push_back({type.type, std::to_string(type.points), std::to_string(type.compared),
                              type.statuses.empty() ? short_number(type.ulp) : type.statuses,
                              pretty(type.output), type.form, at,
                              fmt::format("{:.0f} %", 100 * type.phase_share)});
    }
    return {
        "Emitted = symbolic",
        {Paragraph{fmt::format(
             "{}: compiled emitted code differs from the exact solution in 50 digits by at most {} ulp of "
             "the output's scale; the threshold is {} ulp{}{}.",
             to_string(check.verdict), short_number(check.worst()), short_number(check.threshold),
             check.threshold > default_ulp ? ", widened: " : "",
             check.threshold > default_ulp && check.reason.empty() ? "no reason is given" : check.reason)},
         table}};
}

// The law, and how it looks.
Section transgressed(const Findings& f, const Figures& figures, const std::vector<MotionCurves>& curves) {
    Section section{"Transgression: what is constant at ε = 0",
                    {Formulas{print_transgression(*f.solution, Format::latex),
                              print_transgression(*f.solution, Format::text)}}};
    if (!curves.empty() && curves.front().former) section.blocks.push_back(figures.transgression(curves));
    return section;
}

std::vector<std::string> count_row(const char* name, const Program::Count& c) {
    std::vector<std::string> row = {name};
    for (const int n : {c.add, c.multiply, c.divide, c.root, c.sincos, c.other, c.tables})
        row.push_back(std::to_string(n));
    return row;
}

Section operations(const Findings& f) {
    const Program program = build_program(*f.solution, *f.scene);
    return {
        "Operations per call",
        {Table{"",
               {"", "add", "multiply", "divide", "root", "sincos", "other", "tables"},
               {count_row("before pruning", program.before), count_row("after pruning", program.after)}}}};
}

} // namespace

std::string subject_of(const std::string& page) {
    std::smatch found;
    const std::regex subtitle("System ([A-Za-z0-9_]+), scene ([^\n]+?); order [0-9]+");
    return std::regex_search(page, found, subtitle) ? found[1].str() + "/" + found[2].str() : "";
}

Page make_report(const Findings& f, const VerifyOptions& options, bool drawn, Extent extent) {
    const System& system = *f.scene->system;
    const Figures figures(system, options.cache / "plots", drawn, f.scene->verify.figures);
    const bool whole = extent == Extent::everything;
    const std::vector<MotionCurves> curves =
        drawn && whole ? motions(f, options) : std::vector<MotionCurves>{};
    Page page{fmt::format("{}: {}", system.title, f.scene->title),
              fmt::format("System {}, scene {}; order {}, normal form and map through weight {}. {}",
                          system.name, f.scene->name, to_string(system.weight(f.solution->order)),
                          to_string(system.weight(f.solution->truncation)), system.source),
              {verdict_section(f), scene_section(f, figures)}};
    const auto add = [&](Section section) { page.sections.push_back(std::move(section)); };
    if (!curves.empty()) add({"Motion", {figures.motion(curves)}});
    if (has_former_constants(system)) add(transgressed(f, figures, curves));
    add(accuracy_section(f, figures));
    add(speed_section(f, figures, whole));
    add(stability_section(f, figures));
    add(emitted(f.verification.emitted));
    add(left_out_section(f, drawn));
    if (whole) add(operations(f));
    if (whole) add(derived(f));
    return page;
}

} // namespace resonform::report
