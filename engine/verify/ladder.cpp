// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/ladder.hpp"

#include "verify/deviation.hpp"
#include "verify/interpreter.hpp"
#include "verify/start_scaling.hpp"
#include "verify/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

// A default ladder that has not settled goes on with these, as long as a rung is affordable.
constexpr std::array<int, 3> extensions{20'000, 50'000, 100'000}; // 1/eps
constexpr double affordable_steps = 150'000;                      // seconds in double-double

using Clock = std::chrono::steady_clock;
double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Of a scene that does not claim another. What is accurate through order N has an error O(eps^{N+1}); a
// mean motion leaves out the oscillation, and differs from the motion by its first term.
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

struct Rung {
    TrialPoint at;
    std::size_t steps; // of a run in double
};

Rung planned(const Trial& trial, const Rational& eps) {
    TrialPoint at = trial.point(eps);
    const std::size_t steps = trial.steps(at);
    return {std::move(at), steps};
}

// All rungs before any is integrated at length, the smallest eps first: it refuses at once what would
// take hours.
std::vector<Rung> planned_ladder(const Trial& trial, const std::vector<Rational>& ladder) {
    std::vector<Rung> rungs;
    for (auto eps = ladder.rbegin(); eps != ladder.rend(); ++eps) rungs.push_back(planned(trial, *eps));
    std::reverse(rungs.begin(), rungs.end());
    return rungs;
}

double largest_value(const std::vector<DoubleDouble>& values) {
    double most = 0;
    for (const DoubleDouble& v : values) most = std::max(most, std::abs(to_double_value(v)));
    return most;
}

void add_rung(std::vector<OutputVerdict>& outputs, const Trial& trial, const Rung& plan) {
    const Reference reference = trial.reference(plan.at, Trial::resolving_points(plan.steps));
    const Deviation found = deviation(trial, plan.at, reference);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        LadderRung rung;
        rung.eps = plan.at.eps;
        rung.max_error = largest(found.error[k]);
        rung.rms_error = root_mean_square(found.error[k]);
        rung.digits = found.digits;
        rung.reference_error = reference.error[k];
        rung.floor = found.floor[k];
        rung.scale = largest_value(reference.values[k]);
        outputs[k].ladder.push_back(std::move(rung));
    }
}

void judge_all(std::vector<OutputVerdict>& outputs) {
    for (OutputVerdict& output : outputs) judge(output);
}

void extend(std::vector<OutputVerdict>& outputs, const Trial& trial, std::size_t steps_of_last) {
    for (const int inverse : extensions) {
        if (std::all_of(outputs.begin(), outputs.end(), settled)) return;
        const Rational eps = Rational(1) / Rational(inverse);
        const double ratio = to_double(outputs.front().ladder.back().eps) / to_double(eps);
        if (ratio <= 1) continue;
        if (static_cast<double>(steps_of_last) * ratio > affordable_steps) return;
        const Rung rung = planned(trial, eps);
        add_rung(outputs, trial, rung);
        judge_all(outputs);
        steps_of_last = rung.steps;
    }
}

// Worst |emitted - interpreted| at some times, in ulp of the interpreter's scale: double against
// Float128.
double emitted_against_symbolic(const Trial& trial, const TrialPoint& at) {
    constexpr int times = 40;
    const Program& program = *trial.program();
    const Evaluator<double> emitted = trial.evaluator<double>(at);
    // The same inputs: those of double, exactly.
    const double eps = to_double_value(at.eps_value);
    const std::vector<double> parameters = default_parameters<double>(program, eps);
    const auto widen = [](const std::vector<double>& v) { return std::vector<Float128>(v.begin(), v.end()); };
    const Interpreter<Float128> symbolic(trial.program(), Float128(eps), widen(parameters),
                                         widen(default_start<double>(program, eps, parameters)),
                                         Float128(to_double_value(at.slow_time_end)));
    std::vector<double> a(program.outputs.size());
    std::vector<Float128> b, scale;
    double worst = 0;
    for (int i = 0; i <= times; ++i) {
        const double t = at.interval * i / times;
        if (emitted.call(t, a.data()) != Status::ok || symbolic.call(t, b) != Status::ok) continue;
        if (symbolic.scale(t, scale) != Status::ok) continue;
        for (std::size_t k = 0; k < a.size(); ++k) {
            if (!(scale[k] > 0)) continue;
            const double ulp = std::abs(static_cast<double>((Float128(a[k]) - b[k]) / scale[k])) * 0x1p52;
            worst = std::max(worst, ulp);
        }
    }
    return worst;
}

} // namespace

bool Verification::as_expected() const {
    return std::all_of(outputs.begin(), outputs.end(),
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
    std::size_t steps_of_last = 0;
    for (const Rung& rung : planned_ladder(trial, scene.verify.eps)) {
        add_rung(result.outputs, trial, rung);
        result.emitted_against_symbolic =
            std::max(result.emitted_against_symbolic, emitted_against_symbolic(trial, rung.at));
        steps_of_last = rung.steps;
    }
    judge_all(result.outputs);
    if (!scene.verify.eps_given) extend(result.outputs, trial, steps_of_last);
    if (const std::string complaint = start_scaling_complaint(scene); !complaint.empty())
        for (OutputVerdict& output : result.outputs) {
            output.verdict = Verdict::undecided;
            output.found_order.reset();
            output.constant = std::numeric_limits<double>::quiet_NaN();
            output.reason = complaint;
        }
    if (options.progress) options.progress(fmt::format("verified in {:.1f} s", since(begin)));
    return result;
}

ErrorCurves error_curves(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                         const Solution& solution, const Rational& eps, std::size_t points,
                         const VerifyOptions& options) {
    const Trial trial(std::move(system), scene, solution, options);
    const TrialPoint at = trial.point(eps);
    const Reference reference = trial.reference(at, points);
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
