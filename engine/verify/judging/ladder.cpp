// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/ladder.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "emit/program/build_program.hpp"
#include "verify/estimate/times.hpp"
#include "verify/judging/data_error.hpp"
#include "verify/judging/descent.hpp"
#include "verify/judging/deviation.hpp"
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/guarantee.hpp"
#include "verify/judging/judge.hpp"
#include "verify/judging/start_scaling.hpp"
#include "verify/judging/trial.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <chrono>

namespace resonform {

namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Checks the code that `generate` writes, without the state that the ladder starts from.
EmittedCheck emitted_check(const Scene& scene, const Solution& solution, const VerifyOptions& options) {
    const auto program = std::make_shared<const Program>(build_program(solution, scene, {true, false, true}));
    return check_emitted(*program, library_of(program, options, "dlfe"), solution, scene,
                         {options.cache, options.progress, options.emitted_starts});
}

Guarantees guarantees_of(const Scene& scene, const Solution& solution,
                         const std::vector<OutputVerdict>& outputs, const VerifyOptions& options) {
    Claims claims;
    for (const OutputVerdict& output : outputs) claims[output.name] = output.claimed_order;
    if (options.guarantee) return options.guarantee(scene, solution, claims);
    return guarantees(scene, solution, claims, [](const auto&, int, int) -> Solution {
        refuse({"the next weight is derived", "there is nothing to derive it with", "", {}});
    });
}

void add_estimates(const Scene& scene, const Solution& solution, const VerifyOptions& options,
                   std::vector<OutputVerdict>& outputs) {
    if (!options.estimate || outputs.empty()) return;
    std::vector<Rational> eps;
    for (const LadderRung& rung : outputs.front().ladder) eps.push_back(rung.eps);
    const ErrorEstimates estimates = options.estimate(scene, solution, eps);
    for (OutputVerdict& output : outputs) weigh_estimate(output, estimates.at(output.name));
}

void add_data_errors(const Trial& trial, std::vector<OutputVerdict>& outputs) {
    if (outputs.empty() || outputs.front().ladder.empty()) return;
    const std::vector<DataError> errors = data_errors(trial, outputs.front().ladder.back().eps);
    for (std::size_t k = 0; k < errors.size(); ++k) outputs[k].data_error = errors[k];
}

} // namespace

Verification verify(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                    const Solution& solution, const VerifyOptions& options) {
    const auto begin = Clock::now();
    const auto equations = std::move(system); // of the trial, and of the liars
    const Trial trial(equations, scene, solution, options);
    Verification result;
    Descent descent(trial, scene, solution, result);
    const Guarantees guaranteed = guarantees_of(scene, solution, result.outputs, options);
    descent.along(scene.verify.eps);
    if (!scene.verify.eps_given) descent.further();
    for (OutputVerdict& output : result.outputs) weigh(output, guaranteed.at(output.name));
    weigh_defects(result);
    add_estimates(scene, solution, options, result.outputs);
    add_data_errors(trial, result.outputs);
    result.emitted = emitted_check(scene, solution, options);
    if (options.liars) result.lies = liars(equations, scene, solution, options);
    if (const std::string complaint = start_scaling_complaint(scene); !complaint.empty())
        for (OutputVerdict& output : result.outputs) leave_open(output, complaint);
    if (options.progress) options.progress(fmt::format("verified in {:.1f} s", since(begin)));
    return result;
}

ErrorCurves error_curves(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                         const Solution& solution, const Rational& eps, std::size_t points,
                         const VerifyOptions& options) {
    const Trial trial(std::move(system), scene, solution, options);
    const TrialPoint at = trial.point(eps);
    const Reference reference =
        trial.reference(at, even_times(at.interval, points,
                                       layer_end(*solution.normalization->normal_form.field, scene, eps)));
    ErrorCurves curves;
    curves.eps = to_double(eps);
    curves.times = reference.times;
    curves.error = deviation(trial, at, reference).error;
    for (std::size_t k = 0; k < reference.values.size(); ++k) {
        curves.outputs.push_back(trial.program()->outputs[k].name);
        std::vector<double> direct, emitted;
        for (std::size_t i = 0; i < points; ++i) {
            direct.push_back(to_double_value(reference.values[k][i]));
            emitted.push_back(direct.back() + curves.error[k][i]);
        }
        curves.direct.push_back(std::move(direct));
        curves.emitted.push_back(std::move(emitted));
    }
    return curves;
}

} // namespace resonform
