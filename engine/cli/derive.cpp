// SPDX-License-Identifier: GPL-3.0-or-later
// resonform derive SYSTEM: one stage of the line, printed.
#include "algebra/number/error.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "emit/derive/document.hpp"
#include "model/files/read_system.hpp"
#include "normalize/recursion/centre_manifold.hpp"
#include "solve/route.hpp"
#include "solve/truncation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

struct DeriveRequest {
    std::string system, order, stage, truncation, format, coefficients, style, digits;
    std::vector<std::string> settings;
    DerivationLimits limits;
};

// Through which weight the printed solution uses normal form and map: as asked, else what accuracy
// through the order on t = 1/eps needs.
int truncation_of(const GradedField& field, int order, const std::string& asked) {
    if (!asked.empty()) {
        const int truncation = read_order("--truncation", asked, field.system().eps_root);
        if (const std::string least = to_string(field.system().weight(order)); truncation < order)
            bad_argument("--truncation", fmt::format("must not be below the order, {}", least), asked,
                         fmt::format("give --truncation {} or more", least));
        return truncation;
    }
    Scene scene;
    scene.system = field.first_order->system;
    scene.order = order;
    scene.time_scale = scene.system->eps_root;
    for (const Variable& variable : scene.system->variables)
        if (variable.role == Role::fast || variable.role == Role::drift)
            scene.outputs.push_back(variable.name);
    return count_truncation(field, scene).truncation;
}

// Drift variables by their rates of weight 1 are solved through weight 1 or the largest weight of a variable.
int weight_of_drift(const System& system) {
    int weight = system.eps_root;
    for (const Variable& v : system.variables) weight = std::max(weight, v.weight);
    return weight;
}

// With a solution at hand, text and LaTeX show the system without its known drift, as (19) and (20) do.
// A normal form that cannot be solved in closed form is no less a normal form.
std::optional<Solution> solved_drift(const std::shared_ptr<const Normalization>& normalization,
                                     Watch& watch) {
    const GradedField& field = *normalization->normal_form.field;
    if (!solves_by_quadratures(field)) return std::nullopt;
    const int weight = std::min(normalization->normal_form.through, weight_of_drift(field.system()));
    try {
        return solve_under(watch, normalization, {weight, weight});
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::refused) throw;
        return std::nullopt;
    }
}

bool is_page(Format format) { return format == Format::text || format == Format::latex; }

// The known drift, which an expanded page leaves out. nullopt: nothing drifts, or no solution.
std::optional<Solution> known_drift(const Expanded& expanded, Format format, Watch& watch) {
    if (!is_page(format) || expanded.field->drift.empty()) return std::nullopt;
    const int weight = weight_of_drift(expanded.field->system());
    try {
        return solved_drift(normalize_certified(expanded, weight, watch), watch);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::refused) throw;
        return std::nullopt;
    }
}

// Coefficients of a normal form are written from a graph as JSON only: a page of text would need all of them
// in one ring.
bool goes_with_graph(Stage stage, Format format) {
    return stage == Stage::divisors || (stage == Stage::normal_form && format == Format::json);
}

bool in_graph(const GradedField& field, int order, Stage stage, Format format, const std::string& asked) {
    if (const Style style = field.system().style; asked == "graph" && style != Style::poincare)
        refuse({"coefficients in a graph go with style poincare",
                to_string(style),
                "leave out --coefficients",
                {}});
    if (asked != "auto" && field.system().digits > 0)
        bad_argument("--coefficients", "with --digits coefficients are numbers", asked,
                     "leave out one of the two options");
    if (field.system().digits > 0) return false;
    return asked == "graph" ||
           (asked == "auto" && goes_with_graph(stage, format) && suits_graph(field, order));
}

std::string from_graph(const Expanded& expanded, int order, Stage stage, Format format, Watch& watch) {
    const GraphNormalization n = normalize_in_graph_certified(expanded, order, watch);
    watch.print();
    return stage == Stage::divisors ? print_divisors(*expanded.field, n.result.divisors, order, format)
                                    : print_normal_form(n, order);
}

bool of_solution(Stage stage) { return stage == Stage::solution || stage == Stage::transgression; }

std::string document(const Expanded& expanded, int weight, Stage stage, const std::string& truncation,
                     Format format, const std::string& coefficients, Watch& watch) {
    if (of_solution(stage)) {
        if (stage == Stage::transgression) require_former_constants(*expanded.first_order->system);
        const int through = truncation_of(*expanded.field, weight, truncation);
        const Solution solution = solve_under(watch, normalize_certified(expanded, through, watch),
                                              {weight, through, expanded.first_order->system->eps_root});
        watch.print();
        return stage == Stage::solution ? print_solution(solution, format)
                                        : print_transgression(solution, format);
    }
    if (stage == Stage::expand) {
        const auto solution = known_drift(expanded, format, watch);
        return print_expansion(*expanded.field, weight, format, solution ? &*solution : nullptr);
    }
    if (in_graph(*expanded.field, weight, stage, format, coefficients))
        return from_graph(expanded, weight, stage, format, watch);
    if (stage == Stage::manifold) require_slaved_modes(*expanded.field);
    const auto normalization = normalize_certified(expanded, weight, watch);
    const bool with_drift = is_page(format) && stage != Stage::divisors && stage != Stage::manifold;
    const auto solution = with_drift ? solved_drift(normalization, watch) : std::nullopt;
    watch.print();
    if (stage == Stage::divisors)
        return print_divisors(*normalization->normal_form.field, normalization->divisors, weight, format);
    if (stage == Stage::manifold) return print_manifold(*normalization, weight, format);
    return print_normal_form(*normalization, weight, format, solution ? &*solution : nullptr);
}

bool of_mechanism(Stage stage) { return stage == Stage::constraints || stage == Stage::accelerations; }

bool before_normal_form(Stage stage) {
    return of_mechanism(stage) || stage == Stage::equations || stage == Stage::expand;
}

// Refuses options that have no effect on the stage.
void require_effect(Stage stage, Format format, const std::string& coefficients, const std::string& style) {
    if (coefficients == "graph" && !goes_with_graph(stage, format))
        bad_argument(
            "--coefficients",
            "coefficients in a graph go with --stage normal_form --format json, or with --stage divisors",
            coefficients,
            stage == Stage::normal_form ? "give --format json, or leave the option out"
                                        : "leave the option out");
    if (!before_normal_form(stage)) return;
    const auto refuse_option = [&](const std::string& option, const std::string& value) {
        bad_argument(option,
                     fmt::format("goes with a normal form, and --stage {} comes before it", to_string(stage)),
                     value, "leave the option out");
    };
    if (coefficients == "ring") refuse_option("--coefficients", coefficients);
    if (!style.empty()) refuse_option("--style", style);
}

void require_printable_in_numbers(Stage stage, Format format) {
    if (before_normal_form(stage) || of_solution(stage))
        bad_argument("--digits", "goes with --stage normal_form, divisors or manifold", to_string(stage),
                     "leave it out: this stage is exact");
    if (format == Format::sympy || format == Format::maxima)
        bad_argument("--digits", "numbers of many digits are written as text, latex or json",
                     to_string(format), "choose one of these formats");
}

int run_derive(const DeriveRequest& request) {
    const Stage stage = of_argument("--stage", [&] { return parse_stage(request.stage); });
    if (!request.truncation.empty() && !of_solution(stage))
        bad_argument("--truncation", "goes with --stage solution or transgression", request.truncation,
                     "leave it out: normal form and map reach --order");
    const Format format = of_argument("--format", [&] { return parse_format(request.format); });
    of_argument("--format", [&] { require_printable(stage, format); });
    const std::string coefficients =
        read_choice("--coefficients", request.coefficients, {"auto", "ring", "graph"});
    const std::optional<Style> style = read_style(request.style);
    require_effect(stage, format, coefficients, request.style);
    const Home home = find_home();
    const auto file = find_system(request.system, home);
    const SystemChanges changes{read_settings(request.settings), style, read_digits(request.digits)};
    if (changes.digits > 0) require_printable_in_numbers(stage, format);
    put("{}", watched(request.limits, [&](Watch& watch) {
            const auto system = std::make_shared<const System>(changed_system(file, changes, home));
            const int weight = read_order("--order", request.order, system->eps_root);
            if (of_mechanism(stage)) return print_derivation(*system, stage, format);
            return stage == Stage::equations ? print_equations(*system, format)
                                             : document(expand_system(system, watch), weight, stage,
                                                        request.truncation, format, coefficients, watch);
        }));
    return done;
}

} // namespace

void add_derive(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("derive", "the normal form of a system, or a stage before or after it");
    const Text system = add_required(*command, "SYSTEM", "", system_help);
    const Text order = add_text(*command, "--order", order_values, "weight of normal form and map", "3");
    const Text stage =
        add_text(*command, "--stage",
                 "constraints|accelerations|equations|expand|normal_form|divisors|manifold|solution|"
                 "transgression",
                 "what to print; the first two of a mechanism", "normal_form");
    const Text truncation = add_text(*command, "--truncation", order_values,
                                     "for the solution: weight through which normal form and map are used, "
                                     "not below the order; default: what the order needs on t = 1/eps");
    const Text format = add_text(*command, "--format", "text|latex|json|sympy|maxima",
                                 "how to print; sympy and maxima for the normal form only", "text");
    const Text coefficients = add_text(
        *command, "--coefficients", "auto|ring|graph",
        "where coefficients are held: a graph is for several symbolic frequencies (JSON of the normal form; "
        "and its divisors; auto takes it there from order 4 on, or 3 with three frequencies), the ring for "
        "all else",
        "auto");
    const Text style = add_style(*command);
    const Text digits = add_digits(*command);
    const Texts settings = add_settings(*command);
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_derive({*system, *order, *stage, *truncation, *format, *coefficients, *style, *digits,
                           *settings, limits.value()});
    });
}

} // namespace resonform
