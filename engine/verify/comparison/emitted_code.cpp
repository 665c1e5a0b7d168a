// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/comparison/emitted_code.hpp"

#include "emit/program/build_program.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/solve.hpp"
#include "solve/truncation.hpp"
#include "verify/comparison/timing.hpp"
#include "verify/evaluate/program_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

// The letters of emit_library.
std::string types_for(const std::vector<Task>& tasks) {
    const auto wanted = [&](Task task) { return std::find(tasks.begin(), tasks.end(), task) != tasks.end(); };
    return std::string("d") + (wanted(Task::final) ? "f" : "") + (wanted(Task::ensemble) ? "e" : "");
}

} // namespace

EmittedCode::EmittedCode(const Scene& scene, const Solution& solution, const CompareOptions& options) {
    prepared_.order = scene.system->weight(solution.order);
    prepared_.derivation_seconds = seconds_of(1, [&] {
        program_ = build_program(solution, scene, {true, false, true});
    });
    library_ = EvaluatorLibrary::build(program_, options.cache, options.progress, types_for(options.tasks));
    prepared_.compilation_seconds = library_->object()->compile_seconds();
    prepared_.derivation_seconds += options.derivation_seconds;
}

std::string EmittedCode::setting() const { return "order " + to_string(program_.weight(program_.order)); }

std::vector<double> EmittedCode::parameters(const TrialPoint& at) const {
    return default_parameters<double>(program_, to_double_value(at.eps_value));
}

std::vector<double> EmittedCode::start(const TrialPoint& at) const {
    return default_start<double>(program_, to_double_value(at.eps_value), parameters(at));
}

Evaluator<double> EmittedCode::construct(const TrialPoint& at) const {
    return {library_, to_double_value(at.eps_value), parameters(at), start(at),
            to_double_value(at.slow_time_end)};
}

Solution lower_solution(const Scene& lower, const Solution& solution) {
    const int truncation = count_truncation(*solution.normalization->normal_form.field, lower).truncation;
    return solve(solution.normalization, options_of(lower, lower.order, truncation));
}

std::vector<EmittedCode> emitted_codes(const Scene& scene, const Solution& solution,
                                       const CompareOptions& options) {
    std::vector<EmittedCode> codes;
    for (const int order : options.orders) {
        if (order == scene.order) continue;
        Scene lower = scene;
        lower.order = order;
        codes.emplace_back(scene, lower_solution(lower, solution), options); // an output may be 0 there
    }
    codes.emplace_back(scene, solution, options);
    return codes;
}

} // namespace resonform
