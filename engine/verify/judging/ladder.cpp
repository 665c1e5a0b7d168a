// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/ladder.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "emit/program/build_program.hpp"
#include "model/files/interval_length.hpp"
#include "verify/estimate/times.hpp"
#include "verify/judging/data_error.hpp"
#include "verify/judging/defect.hpp"
#include "verify/judging/deviation.hpp"
#include "verify/judging/start_scaling.hpp"
#include "verify/judging/trial.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

namespace resonform {

namespace {

// A default ladder that has not settled goes on with these, as long as a rung is affordable.
constexpr std::array<int, 3> extensions{20'000, 50'000, 100'000}; // 1/eps
constexpr double affordable_steps = 150'000;                      // seconds in double-double
constexpr double grown_rounding = 1e-30;                          // of double-double, times e^3
constexpr double digits_of_errors = 20;                           // of a motion that is followed
constexpr double longest_layer = 0.5;                             // of an interval that is looked at

using Clock = std::chrono::steady_clock;
double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// The claim of a scene that makes none. An output accurate through order N has an error O(eps^{N+1}); a mean
// motion leaves out the oscillation, and so has an error of the order of its first term.
int default_claim(const Scene& scene, const Solution& solution, const std::string& name) {
    const int claim = scene.order + 1;
    if (scene.oscillating) return claim;
    return std::min(first_oscillation(solution, name).value_or(claim), claim);
}

std::vector<OutputVerdict> blank_verdicts(const Scene& scene, const Solution& solution,
                                          const Program& program) {
    std::vector<OutputVerdict> outputs;
    for (const ProgramOutput& output : program.outputs) {
        OutputVerdict verdict;
        verdict.name = output.name;
        const auto claim = scene.verify.claim.find(output.name);
        const auto expect = scene.verify.expect.find(output.name);
        verdict.claimed_order =
            claim == scene.verify.claim.end() ? default_claim(scene, solution, output.name) : claim->second;
        verdict.expected = expect == scene.verify.expect.end() ? Verdict::pass : expect->second;
        outputs.push_back(std::move(verdict));
    }
    return outputs;
}

// Checks the code that `generate` writes, without the state that the ladder starts from.
EmittedCheck emitted_check(const Scene& scene, const Solution& solution, const VerifyOptions& options) {
    const auto program = std::make_shared<const Program>(build_program(solution, scene, {true, false, true}));
    return check_emitted(*program, library_of(program, options, "dl"), solution, scene,
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

// A formula that leaves too large a defect is wrong, whatever a short ladder says of it.
void weigh_defect(const OutputVerdict& defect, std::vector<OutputVerdict>& outputs) {
    if (defect.verdict != Verdict::fail) return;
    const bool is_output = std::any_of(outputs.begin(), outputs.end(),
                                       [&](const OutputVerdict& o) { return o.name == defect.name; });
    for (OutputVerdict& output : outputs) {
        if ((is_output && output.name != defect.name) || output.verdict == Verdict::fail) continue;
        output.verdict = Verdict::fail;
        output.found_order.reset();
        output.reason = fmt::format("the defect of the equation of {}: {}", defect.name, defect.reason);
    }
}

void add_data_errors(const Trial& trial, std::vector<OutputVerdict>& outputs) {
    if (outputs.empty() || outputs.front().ladder.empty()) return;
    const std::vector<DataError> errors = data_errors(trial, outputs.front().ladder.back().eps);
    for (std::size_t k = 0; k < errors.size(); ++k) outputs[k].data_error = errors[k];
}

double largest_value(std::span<const DoubleDouble> values) {
    double most = 0;
    for (const DoubleDouble& v : values) most = std::max(most, std::abs(to_double_value(v)));
    return most;
}

// A rung of the first `count` times alone, which crowd at the start.
LadderRung of_layer(LadderRung rung, const std::vector<double>& error,
                    const std::vector<DoubleDouble>& values, std::size_t count) {
    double most = 0, squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        most = std::fmax(most, std::abs(error[i]));
        squares += error[i] * error[i];
    }
    rung.max_error = most;
    rung.rms_error = std::sqrt(squares / static_cast<double>(count));
    rung.scale = largest_value(std::span(values).first(count));
    return rung;
}

// Goes down a ladder and writes the results into a Verification.
class Descent {
public:
    Descent(const Trial& trial, const Scene& scene, const GradedField& field, Verification& result)
        : trial_(trial), scene_(scene), field_(field), result_(result) {
        growing_ = grows_at_start(field, scene, scene.verify.eps.front());
    }

    // Plans all rungs before any is integrated; the first that takes too many steps ends the ladder.
    void along(const std::vector<Rational>& ladder) {
        std::vector<Rung> rungs;
        for (const Rational& eps : ladder) {
            if (!(interval_length(scene_, eps) <= longest_interval)) {
                result_.conditions.ladder_end = {
                    eps, fmt::format("the interval is longer than {:g} there", longest_interval)};
                break;
            }
            const double digits = digits_lost(field_, scene_, eps) + digits_of_errors;
            if (digits > RealTraits<DoubleDouble>::digits) {
                result_.conditions.ladder_end = {
                    eps,
                    fmt::format("direct integration past Re lambda = 0 needs {:.1f} digits there and has {}",
                                digits, RealTraits<DoubleDouble>::digits)};
                break;
            }
            if (layer_end(field_, scene_, eps) > longest_layer * judged_interval(field_, scene_, eps)) {
                result_.conditions.within_layer.push_back(eps);
                continue;
            }
            Rung rung = planned(eps);
            if (!rung.steps) {
                result_.conditions.ladder_end = {
                    eps, fmt::format("direct integration through t = {:.3g} takes more than {} steps",
                                     rung.at.interval, most_ladder_steps)};
                break;
            }
            rungs.push_back(std::move(rung));
        }
        for (const Rung& rung : rungs) add(rung);
        for (OutputVerdict& output : result_.outputs) judge(output);
        for (OutputVerdict& defect : result_.defects) judge(defect);
    }

    // A default ladder that has not settled goes on.
    void further() {
        for (const int inverse : extensions) {
            if (result_.conditions.ladder_end || result_.outputs.front().ladder.empty()) return;
            if (std::all_of(result_.outputs.begin(), result_.outputs.end(), settled)) return;
            const Rational eps = Rational(1) / Rational(inverse);
            const double ratio = to_double(result_.outputs.front().ladder.back().eps) / to_double(eps);
            if (ratio > 1 && static_cast<double>(steps_of_last_) * ratio > affordable_steps) return;
            if (ratio > 1) along({eps});
        }
    }

private:
    struct Rung {
        TrialPoint at;
        std::optional<std::size_t> steps; // of a run in double; nullopt: too many
    };

    [[nodiscard]] Rung planned(const Rational& eps) const {
        TrialPoint at = trial_.point(eps);
        const std::optional<std::size_t> steps = trial_.steps(at, most_ladder_steps);
        return {std::move(at), steps};
    }

    void add(const Rung& plan) {
        const double rate = largest_rate(field_, scene_, plan.at.eps);
        const double from = layer_end(field_, scene_, plan.at.eps);
        const SampleTimes times =
            crowded_times(plan.at.interval, Trial::resolving_points(*plan.steps), rate, from);
        result_.conditions.layer_end = from;
        note(times, plan.at.interval - from, rate);
        const Reference reference = trial_.reference(plan.at, times.all);
        const Deviation found = deviation(trial_, plan.at, reference);
        const double layer = layer_length(field_, scene_, plan.at.eps);
        const auto behind = std::upper_bound(times.all.begin(), times.all.end(), layer);
        const auto within = static_cast<std::size_t>(behind - times.all.begin());
        for (std::size_t k = 0; k < result_.outputs.size(); ++k) {
            OutputVerdict& output = result_.outputs[k];
            LadderRung rung;
            rung.eps = plan.at.eps;
            rung.max_error = largest(found.error[k], times.even);
            rung.rms_error = root_mean_square(found.error[k], times.even);
            rung.digits = found.digits;
            rung.reference_error = reference.error[k];
            rung.floor = found.floor[k];
            rung.refusal = found.refusal;
            rung.scale = largest_value(reference.values[k]);
            if (growing_) // rounding has grown, too
                rung.reference_error = std::max(rung.reference_error, grown_rounding * rung.scale);
            if (layer > 0)
                output.layer.push_back(of_layer(rung, found.error[k], reference.values[k], within));
            output.ladder.push_back(std::move(rung));
        }
        if (growing_) add_defect(plan, rate);
        steps_of_last_ = *plan.steps;
    }

    // Beside modes that grow.
    void add_defect(const Rung& plan, double rate) {
        Conditions& conditions = result_.conditions;
        conditions.growth_end = plan.at.interval;
        conditions.moved = trial_.moved(plan.at);
        const std::string none = why_no_defect(*scene_.system);
        const bool on_manifold = scene_.growing == Growing::project || !scene_.transients;
        if (on_manifold) conditions.beyond = none.empty() ? "beyond, the defect judges the formula" : none;
        if (!none.empty()) return;
        for (const EquationDefect& equation :
             defect_of(trial_, on_manifold ? trial_.whole(plan.at) : plan.at, rate)) {
            const auto known =
                std::find_if(result_.defects.begin(), result_.defects.end(),
                             [&](const OutputVerdict& d) { return d.name == equation.variable; });
            OutputVerdict& defect = known == result_.defects.end() ? result_.defects.emplace_back() : *known;
            defect.name = equation.variable;
            defect.claimed_order = scene_.order + 1;
            defect.ladder.push_back(equation.rung);
        }
    }

    void note(const SampleTimes& times, double length, double rate) {
        Conditions& conditions = result_.conditions;
        conditions.count = times.all.size();
        conditions.first = times.first;
        if (rate == 0) return;
        const double period = 2 * std::numbers::pi / rate;
        const double here = static_cast<double>(times.even.size() - 1) * period / length;
        conditions.per_fast_period = std::fmin(conditions.per_fast_period, here); // the first is no number
    }

    const Trial& trial_;
    const Scene& scene_;
    const GradedField& field_;
    Verification& result_;
    bool growing_ = false;
    std::size_t steps_of_last_ = 0;
};

} // namespace

bool Verification::as_expected() const {
    return emitted.verdict == Verdict::pass &&
           std::all_of(outputs.begin(), outputs.end(),
                       [](const OutputVerdict& o) { return o.verdict == o.expected; });
}

Verification verify(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                    const Solution& solution, const VerifyOptions& options) {
    const auto begin = Clock::now();
    const Trial trial(std::move(system), scene, solution, options);
    Verification result;
    result.system = trial.program()->system;
    result.scene = scene.name;
    result.outputs = blank_verdicts(scene, solution, *trial.program());
    result.conditions = conditions_of(scene);
    const Guarantees guaranteed = guarantees_of(scene, solution, result.outputs, options);
    Descent descent(trial, scene, *solution.normalization->normal_form.field, result);
    descent.along(scene.verify.eps);
    if (!scene.verify.eps_given) descent.further();
    for (OutputVerdict& output : result.outputs) weigh(output, guaranteed.at(output.name));
    for (const OutputVerdict& defect : result.defects) weigh_defect(defect, result.outputs);
    add_estimates(scene, solution, options, result.outputs);
    add_data_errors(trial, result.outputs);
    result.emitted = emitted_check(scene, solution, options);
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
