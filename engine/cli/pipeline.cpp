// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pipeline.hpp"

#include "algebra/number/error.hpp"
#include "cli/output.hpp"
#include "emit/cpp/cpp.hpp"
#include "emit/display/decided.hpp"
#include "emit/program/build_program.hpp"
#include "emit/program/fixed_divisors.hpp"
#include "model/exact/first_order_system.hpp"
#include "model/files/read_scene.hpp"
#include "model/files/read_system.hpp"
#include "model/text/diagnostic.hpp"
#include "normalize/recursion/numbers.hpp"
#include "normalize/recursion/poincare.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/flow_certificate.hpp"
#include "solve/solve.hpp"
#include "solve/time_scale.hpp"
#include "solve/truncation.hpp"
#include "verify/estimate/error_estimator.hpp"

#include <fmt/format.h>

#include <chrono>
#include <set>
#include <utility>
#include <vector>

namespace resonform {

namespace {

// Reports the steps of a computation that took half a second or more.
class Laps {
public:
    void done(const std::string& step) {
        constexpr double told = 0.5; // seconds
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        if (seconds >= told) show_progress(fmt::format("{}, {:.1f} s", step, seconds));
        begin_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_ = Clock::now();
};

} // namespace

System changed_system(const std::filesystem::path& file, const SystemChanges& changes, const Home& home) {
    System system = read_system(file, changes.settings, "--set");
    std::vector<Setting> left;
    for (const Setting& setting : changes.settings)
        if (!is_set(system, setting.parameter)) left.push_back(setting);
    system = with_settings(std::move(system), left, "--set");
    check_name_of_folder(system, home);
    if (changes.style) system.style = *changes.style;
    system.digits = changes.digits;
    return system;
}

Expanded expand_system(std::shared_ptr<const System> system, Watch& watch) {
    watch.enter("solving the equations for the highest derivatives");
    Expanded expanded;
    expanded.first_order = std::make_shared<const FirstOrderSystem>(solve_for_highest(std::move(system)));
    watch.enter("the expansion");
    const Place file = whole_file(expanded.first_order->system->file);
    expanded.field =
        at_place(file, [&] { return std::make_shared<const GradedField>(expand(expanded.first_order)); });
    return expanded;
}

namespace {

// derive(options) makes a result, check(result) certifies it.
template <class Derive, class Check>
auto derived_and_checked(const Expanded& expanded, int through, Watch& watch, Derive derive, Check check) {
    Laps laps;
    const Place file = whole_file(expanded.first_order->system->file);
    const System& system = *expanded.first_order->system;
    const std::string last = to_string(system.weight(through));
    const NormalizeOptions options{[&](int weight, std::size_t terms) {
        laps.done(fmt::format("weight {}: {} terms", to_string(system.weight(weight)), terms));
        watch.reached(system.weight(weight), system.weight(weight + 1), terms);
    }};
    auto result = at_place(file, [&] { return derive(options); });
    watch.enter(fmt::format("weight {} reached, the certificate under way", last));
    at_place(file, [&] { check(*result); });
    laps.done("certificate");
    watch.certified(last);
    return result;
}

// complaint: "" if it holds.
void require_certificate(const std::string& of, const std::string& complaint) {
    if (!complaint.empty())
        throw Error(ErrorKind::check_failed,
                    {"the certificate of the " + of + " does not hold", complaint, "", {}});
}

} // namespace

std::shared_ptr<const Normalization> normalize_with_certificate(const Expanded& expanded, int through,
                                                                Watch& watch) {
    const bool in_numbers = expanded.field->system().digits > 0;
    return derived_and_checked(
        expanded, through, watch,
        [&](const NormalizeOptions& options) {
            return std::make_shared<Normalization>(
                in_numbers ? normalize_in_numbers(expanded.field, through, options)
                           : normalize(expanded.field, through, options));
        },
        [&](Normalization& n) {
            if (!in_numbers) require_decided(n.normal_form);
            n.certificate = in_numbers ? certify_numbers(n, expanded.field) : certify(n.normal_form, n.map);
        });
}

std::shared_ptr<const Normalization> normalize_certified(const Expanded& expanded, int through,
                                                         Watch& watch) {
    auto normalization = normalize_with_certificate(expanded, through, watch);
    require_certificate("normal form", normalization->certificate.complaint);
    return normalization;
}

GraphNormalization normalize_in_graph_certified(const Expanded& expanded, int through, Watch& watch) {
    const auto normalization = derived_and_checked(
        expanded, through, watch,
        [&](const NormalizeOptions& options) {
            return std::make_shared<GraphNormalization>(normalize_in_graph(expanded.field, through, options));
        },
        [](GraphNormalization& n) { n.result.certificate = certify(n); });
    require_certificate("normal form", normalization->result.certificate.complaint);
    return *normalization;
}

Solution solve_under(Watch& watch, std::shared_ptr<const Normalization> normalization,
                     const SolveOptions& options) {
    watch.go_on_with("the solution");
    Laps laps;
    Solution solution = solve(std::move(normalization), options);
    require_certificate("slow flow", flow_complaint(solution));
    laps.done("solution");
    return solution;
}

Solution solve_system(std::shared_ptr<const System> system, int order, int truncation, Watch& watch) {
    const Expanded expanded = expand_system(std::move(system), watch);
    return solve_under(watch, normalize_certified(expanded, truncation, watch), {order, truncation});
}

Derive deriving_under(Watch& watch) {
    return [&watch](const std::shared_ptr<const System>& system, int order, int truncation) {
        return solve_system(system, order, truncation, watch);
    };
}

Scene read_scene_of(const std::string& argument, const Home& home) {
    Scene scene = read_scene(find_scene(argument, home), home.systems());
    if (scene.file.parent_path().parent_path() != scene.system->file.parent_path())
        say_if_of_source_tree(home, scene.system->file);
    check_name_of_folder(*scene.system, home);
    return scene;
}

Scene read_scene_with_values(const std::string& argument, const Home& home) {
    Scene scene = read_scene_of(argument, home);
    for (const NamedFunction& f : scene.system->functions)
        if (f.callable)
            bad_input({fmt::format("{} is a callable, which only emitted code can call", f.name),
                       "callable = true",
                       "give it as an expression or by data; or generate the header, and give the "
                       "evaluator the function as last argument",
                       *f.callable});
    return scene;
}

namespace {

SceneLine solve_as_given(Scene scene, Watch& watch) {
    SceneLine line;
    line.scene = std::move(scene);
    line.expanded = expand_system(line.scene.system, watch);
    at_place(whole_file(line.scene.file), [&] {
        line.count = count_truncation(*line.expanded.field, line.scene);
        const auto normalization = normalize_certified(line.expanded, line.count.truncation, watch);
        line.solution = solve_under(watch, normalization,
                                    options_of(line.scene, line.scene.order, line.count.truncation));
        check_time_scale(line.solution, line.scene);
        if (!line.scene.fix.empty()) require_divisors(*normalization, line.scene);
    });
    return line;
}

// Whether numbers in place of parameters may change the answer.
bool concerns_symbols(const Error& error) {
    switch (error.diagnostic().reason) {
    case Reason::time:
    case Reason::memory:
    case Reason::terms:
    case Reason::fault: return false;
    default: return error.kind() != ErrorKind::check_failed;
    }
}

// Whether another way to write the same coefficients may be accepted.
bool hangs_on_form(const Error& error) {
    const Reason reason = error.diagnostic().reason;
    return reason == Reason::undecided || reason == Reason::size;
}

} // namespace

SceneLine solve_scene(Scene scene, Watch& watch) {
    if (scene.fix.empty()) return solve_as_given(std::move(scene), watch);
    std::optional<Error> with_symbols;
    try {
        return solve_as_given(scene, watch);
    } catch (const Error& error) {
        if (!concerns_symbols(error)) throw;
        with_symbols = error;
    }
    watch.enter("once more, with the values of [fix] put in");
    try {
        return solve_as_given(with_fix_put_in(std::move(scene)), watch);
    } catch (const Error& error) {
        // A definite refusal with symbols tells the user more than "undecided" or too large numbers.
        if (hangs_on_form(error) && !hangs_on_form(*with_symbols)) throw *with_symbols;
        throw;
    }
}

SceneLine solve_scene(const std::string& argument, const Home& home, Watch& watch) {
    return solve_scene(read_scene_of(argument, home), watch);
}

namespace {

Program program_with(const SceneLine& line, Watch& watch, std::set<std::string> kept_inputs) {
    watch.go_on_with("the evaluator, from the start values on,");
    Laps laps;
    Program program = build_program(line.solution, line.scene, {true, false, true, std::move(kept_inputs)});
    laps.done("evaluator");
    return program;
}

// What estimates the errors of a scene, whose caller gives all parameters.
std::vector<CppFurther> further_of(const SceneLine& line, Watch& watch) {
    std::vector<std::string> given;
    for (const Parameter& p : line.solution.system().parameters) given.push_back(p.name);
    const ErrorEstimator estimator(line.scene, line.solution, deriving_under(watch), given);
    std::vector<CppFurther> all;
    for (const ErrorEstimator::Further& f : estimator.further()) all.push_back({f.outputs, f.whole->program});
    return all;
}

} // namespace

Program program_of(const SceneLine& line, Watch& watch) { return program_with(line, watch, {}); }

Header header_of(const SceneLine& line, Watch& watch, bool inline_runtime) {
    CppOptions options{inline_runtime, {}};
    std::set<std::string> inputs;
    if (line.scene.error_estimate) options.further = further_of(line, watch);
    for (const CppFurther& f : options.further)
        for (const auto* list : {&f.program->parameters, &f.program->start})
            for (const ProgramInput& input : *list) inputs.insert(input.name);
    Header header{program_with(line, watch, std::move(inputs)), ""};
    header.text = emit_cpp(header.program, options);
    return header;
}

SceneLine solve_scene(const std::string& argument, const Home& home, const DerivationLimits& limits) {
    return watched(limits,
                   [&](Watch& watch) { return solve_scene(read_scene_with_values(argument, home), watch); });
}

} // namespace resonform
