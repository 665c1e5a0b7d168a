// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/report.hpp"

#include "algebra/number/number.hpp"
#include "emit/derive/document.hpp"
#include "emit/program/build_program.hpp"
#include "solve/transgression.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/report/figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
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
    for (const char* text : {"0.1", "0.01"}) {
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
        {Preformatted{print_normal_form(normalization, f.scene->order, Format::text, f.solution)},
         Preformatted{print_solution(*f.solution, Format::text)},
         Paragraph{fmt::format(
             "Certificate: map and normal form, put into the original equations at {} random points "
             "modulo {} primes, leave no residual through weight {}; every monomial of the normal form is "
             "resonant and the map has none of them. A wrong result would pass with probability below {}.",
             certificate.points, certificate.primes.size(), to_string(certificate.through_weight),
             short_number(certificate.error_probability))}}};
}

Table ladder_table(const OutputVerdict& output) {
    Table table{fmt::format("{}: errors on the ladder", pretty(output.name)),
                {"ε", "max error", "RMS error", "local slope", "digits", "error of the reference"},
                {}};
    for (std::size_t i = 0; i < output.ladder.size(); ++i) {
        const LadderRung& rung = output.ladder[i];
        const bool has_slope = i > 0 && std::isfinite(output.local_slopes[i - 1]);
        table.rows.push_back({short_number(to_double(rung.eps)), short_number(rung.max_error),
                              short_number(rung.rms_error),
                              has_slope ? fmt::format("{:.3f}", output.local_slopes[i - 1]) : "",
                              std::to_string(rung.digits), short_number(rung.reference_error)});
    }
    return table;
}

std::string order_of(const OutputVerdict& output, int held) {
    return fmt::format("O(ε^{})", to_string(output.order(held)));
}

Table verdict_table(const Verification& verification) {
    const std::string shorter = shortness(verification.conditions);
    Table table{"Error over the interval against direct integration, as ε → 0",
                {"output", "claimed", "guaranteed", "found", "slope", "window of ε",
                 "limit of max|Δ|/ε^found", "verdict", "expected"},
                {}};
    for (const OutputVerdict& o : verification.outputs)
        table.rows.push_back(
            {pretty(o.name), order_of(o, o.claimed_order),
             o.guaranteed_order ? order_of(o, *o.guaranteed_order) : "",
             o.found_order ? order_of(o, *o.found_order) : "",
             std::isfinite(o.slope) ? fmt::format("{:.3f}", o.slope) : "",
             fmt::format("{} … {}", short_number(o.slope_low_eps), short_number(o.slope_high_eps)),
             short_number(o.constant), to_string(o.verdict) + (shorter.empty() ? "" : ", " + shorter),
             to_string(o.expected)});
    return table;
}

// Estimated beside true errors; no rows where nothing is estimated.
Table estimate_table(const OutputVerdict& output) {
    Table table{fmt::format("{}: error estimated by the next weight", pretty(output.name)),
                {"ε", "map", "flow", "estimated error", "max error", "estimated / true"},
                {}};
    if (!output.estimate || output.estimate->next_order == 0) return table;
    for (std::size_t i = 0; i < output.ladder.size(); ++i) {
        const EstimatedRung& e = output.estimate->ladder[i];
        const double error = output.ladder[i].max_error;
        table.rows.push_back({short_number(to_double(e.eps)), short_number(e.map), short_number(e.flow),
                              short_number(e.error), short_number(error), short_number(e.error / error)});
    }
    return table;
}

Table best_orders(const OutputVerdict& output) {
    Table table{fmt::format("{}: the best order for each ε, by extrapolation", pretty(output.name)),
                {"ε", "order", "of the orders", "expected error"},
                {}};
    if (!output.estimate) return table;
    for (const BestOrder& b : output.estimate->best)
        table.rows.push_back(
            {short_number(to_double(b.eps)), to_string(output.order(b.order)),
             fmt::format("{} … {}", to_string(output.order(1)), to_string(output.order(b.looked_at))),
             short_number(b.accuracy)});
    return table;
}

Section accuracy(const Findings& f, const Figures& figures) {
    Section section{"Order of accuracy",
                    {verdict_table(f.verification), Preformatted{conditions_text(f.verification)}}};
    for (const OutputVerdict& o : f.verification.outputs)
        if (!o.reason.empty())
            section.blocks.push_back(Paragraph{fmt::format("{}: {}", pretty(o.name), o.reason)});
    section.blocks.push_back(figures.ladders(f.verification.outputs));
    for (const OutputVerdict& o : f.verification.outputs) {
        section.blocks.push_back(ladder_table(o));
        if (Table estimated = estimate_table(o); !estimated.rows.empty())
            section.blocks.push_back(std::move(estimated));
        if (o.estimate && !o.estimate->reason.empty())
            section.blocks.push_back(
                Paragraph{fmt::format("Estimated error of {}: {}", pretty(o.name), o.estimate->reason)});
        if (Table best = best_orders(o); !best.rows.empty()) section.blocks.push_back(std::move(best));
    }
    section.blocks.push_back(Paragraph{
        "What covers what: the ladder sees errors of the formulas down to the order found; the certificate "
        "sees every coefficient of normal form and map; what lies between the solution and the compiled code "
        "is seen by the next section."});
    return section;
}

Section emitted(const EmittedCheck& check) {
    Table table{"Emitted = symbolic",
                {"real type", "points", "answered", "largest difference, ulp", "output", "at",
                 "of the scale for moved phases"},
                {},
                false};
    for (const EmittedInType& type : check.types) {
        std::string at;
        for (const auto& [name, value] : type.at)
            at += fmt::format("{}{} = {}", at.empty() ? "" : ", ", pretty(name), short_number(value));
        table.rows.push_back({type.type, std::to_string(type.points), std::to_string(type.compared),
                              type.statuses.empty() ? short_number(type.ulp) : type.statuses,
                              pretty(type.output), at, fmt::format("{:.0f} %", 100 * type.phase_share)});
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

Section speed(const Findings& f, const Figures& figures) {
    Table rows{"Every run",
               {"method", "setting", "task", "form", "points", "max error", "seconds", "construction, s"},
               {},
               true};
    for (const ComparisonRow& row : f.comparison.rows) {
        std::vector<std::string> errors;
        for (const double e : row.max_error) errors.push_back(short_number(e));
        rows.rows.push_back({row.method, row.setting, to_string(row.task),
                             row.form ? to_string(*row.form) : "", std::to_string(row.points),
                             row.failure.empty() ? fmt::format("{}", fmt::join(errors, ", ")) : row.failure,
                             short_number(row.seconds.median), short_number(row.construction_seconds)});
    }
    Table even{"Rivals at the accuracy of the emitted evaluator",
               {"task", "method", "tolerance", "seconds", "rival / emitted", "winner"},
               {}};
    for (const BreakEven& b : f.comparison.by_eps.front().tasks) {
        if (b.order != f.scene->system->weight(f.scene->order)) continue;
        if (!b.failure.empty())
            even.rows.push_back({to_string(b.task), "emitted", "–", b.failure, "–", "not compared"});
        for (const RivalAtEqualAccuracy& rival : b.rivals)
            even.rows.push_back({to_string(b.task), rival.method,
                                 rival.seconds ? short_number(rival.tolerance) : "–",
                                 rival.seconds ? short_number(*rival.seconds) : "not reached",
                                 rival.ratio ? short_number(*rival.ratio) : "–", b.winner});
    }
    return {"Error against run time", {figures.work(f.comparison), even, rows}};
}

Section rounding(const Findings& f) {
    Table worst{"Worst points", {"output", "ulp", "unavoidable", "at"}, {}};
    for (const WorstPoint& point : f.stability.worst) {
        std::vector<std::string> at;
        for (const auto& [name, value] : point.at)
            at.push_back(fmt::format("{} = {}", pretty(name), short_number(value)));
        worst.rows.push_back({pretty(point.output), short_number(point.ulp), short_number(point.unavoidable),
                              fmt::format("{}", fmt::join(at, ", "))});
    }
    Table median{"Median", {"output", "ulp"}, {}};
    for (const auto& [name, ulp] : f.stability.median)
        median.rows.push_back({pretty(name), short_number(ulp)});
    Table swept{"Swept", {"input", "from", "to"}, {}};
    for (const SweptInput& input : f.stability.swept) {
        const std::string unit = input.weight == 0   ? ""
                                 : input.weight == 1 ? " ε"
                                                     : fmt::format(" ε^{}", to_string(input.weight));
        swept.rows.push_back({pretty(input.name),
                              (input.negative ? "± " : "") + short_number(input.low) + unit,
                              short_number(input.high) + unit});
    }
    return {
        "Stability of the emitted code",
        {Paragraph{fmt::format(
             "Verdict: {}{}. Double against 50 digits at {} points over many decades of every input; {} were "
             "answered with a status, of them {} that nothing explains (at most {:.0f} % may be); {} more "
             "are "
             "beyond the reference. Errors in ulp of the output's scale, the sum of its terms' magnitudes; "
             "the threshold is {:g}, and as many times more as one last bit of all inputs makes "
             "unavoidable.",
             to_string(f.stability.verdict), f.stability.rule.empty() ? "" : ": " + f.stability.rule,
             f.stability.cases, f.stability.refused, f.stability.unexplained, 100 * unexplained_share,
             f.stability.beyond_reference, f.stability.threshold)},
         swept, median, worst}};
}

// The law, and how it looks.
Section transgressed(const Findings& f, const Figures& figures, const std::vector<MotionCurves>& curves) {
    Section section{"Transgression: what is constant at ε = 0",
                    {Preformatted{print_transgression(*f.solution, Format::text)}}};
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

Page make_report(const Findings& f, const VerifyOptions& options, bool drawn) {
    const Figures figures(*f.scene->system, options.cache / "plots", drawn);
    const std::vector<MotionCurves> curves = drawn ? motions(f, options) : std::vector<MotionCurves>{};
    const System& system = *f.scene->system;
    Page page{fmt::format("{}: {}", system.title, f.scene->title),
              fmt::format("System {}, scene {}; order {}, normal form and map through weight {}. {}",
                          system.name, f.scene->name, to_string(system.weight(f.solution->order)),
                          to_string(system.weight(f.solution->truncation)), system.source),
              {}};
    if (drawn)
        page.sections = {{"Motion", {figures.motion(curves)}}};
    else
        page.sections = {{"Figures", {Paragraph{"Figures are missing: gnuplot could not be run."}}}};
    if (has_former_constants(system)) page.sections.push_back(transgressed(f, figures, curves));
    if (drawn) page.sections.push_back({"Error of the formulas", {figures.errors(curves)}});
    for (Section section : {accuracy(f, figures), emitted(f.verification.emitted), speed(f, figures),
                            rounding(f), operations(f), derived(f)})
        page.sections.push_back(std::move(section));
    return page;
}

} // namespace resonform::report
