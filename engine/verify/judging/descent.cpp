// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/descent.hpp"

#include "algebra/number/number.hpp"
#include "model/files/interval_length.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/judging/defect.hpp"
#include "verify/judging/deviation.hpp"
#include "verify/run/parallel.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace resonform {

namespace {

// A default ladder that has not settled goes on with these, as long as a rung is affordable.
constexpr std::array<int, 3> extensions{20'000, 50'000, 100'000}; // 1/eps
constexpr double affordable_steps = 150'000;                      // seconds in double-double
constexpr double grown_rounding = 1e-30;                          // of double-double, times e^3
constexpr double digits_of_errors = 20;                           // of a motion that is followed
constexpr double longest_layer = 0.5;                             // of an interval that is looked at

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
        verdict.eps_root = program.eps_root;
        const auto claim = scene.verify.claim.find(output.name);
        const auto expect = scene.verify.expect.find(output.name);
        verdict.claimed_order =
            claim == scene.verify.claim.end() ? default_claim(scene, solution, output.name) : claim->second;
        verdict.expected = expect == scene.verify.expect.end() ? Verdict::pass : expect->second;
        outputs.push_back(std::move(verdict));
    }
    return outputs;
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

} // namespace

// What a rung is judged by.
struct Descent::Measured {
    SampleTimes times;
    Reference reference;
    Deviation deviation;
    std::vector<EquationDefect> defect; // empty: none is computed
};

Descent::Descent(const Trial& trial, const Scene& scene, const Solution& solution, Verification& result)
    : trial_(trial), scene_(scene), field_(*solution.normalization->normal_form.field), result_(result),
      growing_(grows_at_start(field_, scene, scene.verify.eps.front())),
      follows_growth_(solution.flow && solution.flow->follows_growth()) {
    result_.system = trial.program()->system;
    result_.scene = scene.name;
    result_.outputs = blank_verdicts(scene, solution, *trial.program());
    result_.conditions = conditions_of(scene);
}

// Before anything is integrated; none: it goes on.
std::optional<LadderEnd> Descent::end_at(const Rational& eps) const {
    if (!(interval_length(scene_, eps) <= longest_interval))
        return LadderEnd{eps, fmt::format("the interval is longer than {:g} there", longest_interval)};
    const double digits = digits_lost(field_, scene_, eps) + digits_of_errors;
    if (digits > RealTraits<DoubleDouble>::digits)
        return LadderEnd{
            eps, fmt::format("direct integration past Re lambda = 0 needs {:.1f} digits there and has {}",
                             digits, RealTraits<DoubleDouble>::digits)};
    return std::nullopt;
}

PlannedRung Descent::rung(const Rational& eps) {
    PlannedRung plan{trial_.point(eps), {}, 0, 0, 0, {}};
    plan.steps = trial_.steps(plan.at, most_ladder_steps);
    plan.rate = largest_rate(field_, scene_, eps);
    plan.from = layer_end(field_, scene_, eps);
    plan.layer = layer_length(field_, scene_, eps);
    if (!growing_) return plan;
    const std::string none = why_no_defect(*scene_.system);
    const bool on_manifold = !follows_growth_;
    if (on_manifold)
        result_.conditions.beyond = none.empty() ? "beyond, the defect judges the formula" : none;
    if (none.empty()) plan.defect = on_manifold ? trial_.whole(plan.at) : plan.at;
    return plan;
}

std::vector<PlannedRung> Descent::planned(const std::vector<Rational>& ladder) {
    std::vector<PlannedRung> rungs;
    for (const Rational& eps : ladder) {
        if (const std::optional<LadderEnd> end = end_at(eps); end) {
            result_.conditions.ladder_end = end;
            break;
        }
        if (layer_end(field_, scene_, eps) > longest_layer * judged_interval(field_, scene_, eps)) {
            result_.conditions.within_layer.push_back(eps);
            continue;
        }
        PlannedRung next = rung(eps);
        if (!next.steps) {
            result_.conditions.ladder_end = {
                eps, fmt::format("direct integration through t = {:.3g} takes more than {} steps",
                                 next.at.interval, most_ladder_steps)};
            break;
        }
        rungs.push_back(std::move(next));
    }
    return rungs;
}

void Descent::measure(const std::vector<PlannedRung>& rungs) {
    std::vector<Measured> all(rungs.size());
    in_parallel(rungs.size(), [&](std::size_t k) { all[k] = measured(rungs[k]); });
    for (std::size_t k = 0; k < rungs.size(); ++k) add(rungs[k], all[k]);
    for (OutputVerdict& output : result_.outputs) judge(output);
    for (OutputVerdict& defect : result_.defects) judge(defect);
}

void Descent::further() {
    for (const int inverse : extensions) {
        if (result_.conditions.ladder_end || result_.outputs.front().ladder.empty()) return;
        if (std::all_of(result_.outputs.begin(), result_.outputs.end(), settled)) return;
        const Rational eps = Rational(1) / Rational(inverse);
        const double ratio = to_double(result_.outputs.front().ladder.back().eps) / to_double(eps);
        if (ratio > 1 && static_cast<double>(steps_of_last_) * ratio > affordable_steps) return;
        if (ratio > 1) along({eps});
    }
}

Descent::Measured Descent::measured(const PlannedRung& plan) const {
    Measured found;
    found.times = crowded_times(plan.at.interval, Trial::resolving_points(*plan.steps), plan.rate, plan.from);
    found.reference = trial_.reference(plan.at, found.times.all);
    const auto known = roundings_.find(plan.at.eps);
    found.deviation = deviation(trial_, plan.at, found.reference,
                                known == roundings_.end() ? std::vector<double>{} : known->second);
    if (plan.defect) found.defect = defect_of(trial_, *plan.defect, plan.rate);
    return found;
}

void Descent::add(const PlannedRung& plan, const Measured& found) {
    const auto& [times, reference, deviation, defect] = found;
    roundings_[plan.at.eps] = deviation.rounding;
    result_.conditions.layer_end = plan.from;
    note(times, plan.at.interval - plan.from, plan.rate);
    const auto behind = std::upper_bound(times.all.begin(), times.all.end(), plan.layer);
    const auto within = static_cast<std::size_t>(behind - times.all.begin());
    for (std::size_t k = 0; k < result_.outputs.size(); ++k) {
        OutputVerdict& output = result_.outputs[k];
        LadderRung rung;
        rung.eps = plan.at.eps;
        rung.max_error = largest(deviation.error[k], times.even);
        rung.rms_error = root_mean_square(deviation.error[k], times.even);
        rung.digits = deviation.digits;
        rung.reference_error = reference.error[k];
        rung.floor = deviation.floor[k];
        rung.refused = deviation.refused;
        rung.refusal = deviation.refusal;
        rung.scale = largest_value(reference.values[k]);
        if (growing_) // rounding has grown, too
            rung.reference_error = std::max(rung.reference_error, grown_rounding * rung.scale);
        if (plan.layer > 0)
            output.layer.push_back(of_layer(rung, deviation.error[k], reference.values[k], within));
        output.ladder.push_back(std::move(rung));
    }
    result_.conditions.moved = trial_.moved(plan.at);
    if (growing_) add_defect(plan, found);
    steps_of_last_ = *plan.steps;
}

// Beside modes that grow.
void Descent::add_defect(const PlannedRung& plan, const Measured& found) {
    result_.conditions.growth_end = plan.at.interval;
    for (const EquationDefect& equation : found.defect) {
        const auto known = std::find_if(result_.defects.begin(), result_.defects.end(),
                                        [&](const OutputVerdict& d) { return d.name == equation.variable; });
        OutputVerdict& defect = known == result_.defects.end() ? result_.defects.emplace_back() : *known;
        defect.name = equation.variable;
        defect.eps_root = scene_.system->eps_root;
        defect.claimed_order = scene_.order + 1;
        defect.ladder.push_back(equation.rung);
    }
}

void Descent::note(const SampleTimes& times, double length, double rate) {
    Conditions& conditions = result_.conditions;
    conditions.count = times.all.size();
    conditions.first = times.first;
    if (rate == 0) return;
    const double period = 2 * std::numbers::pi / rate;
    const double here = static_cast<double>(times.even.size() - 1) * period / length;
    conditions.per_fast_period = std::fmin(conditions.per_fast_period, here); // the first is no number
}

void weigh_defects(Verification& result) {
    for (const OutputVerdict& defect : result.defects) weigh_defect(defect, result.outputs);
}

} // namespace resonform
