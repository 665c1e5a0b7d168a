// SPDX-License-Identifier: GPL-3.0-or-later
// The rivals: direct integration.
#include "verify/comparison/contest.hpp"
#include "verify/comparison/timing.hpp"
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/riccati.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

// Of an ensemble: what of it runs takes about so long, but some of it runs.
constexpr double seconds_of_members = 0.2;
constexpr std::size_t fewest_members = 8, most_members = 200;

} // namespace

std::string setting_of(double tolerance) {
    const bool decade = tolerance == std::pow(10.0, std::round(std::log10(tolerance)));
    return decade ? fmt::format("tolerance {:.0e}", tolerance) : fmt::format("tolerance {:.2e}", tolerance);
}

const CompiledTape& Contest::compiled_rates() {
    if (!rates_)
        rates_.emplace(tape_, convert_all<double>(at_.parameters), to_double_value(at_.eps_value),
                       options_.cache, [&] {
                           if (options_.progress)
                               options_.progress("compiling the equations for the direct methods");
                       });
    return *rates_;
}

std::unique_ptr<Integrator> Contest::integrator(Method method, double tolerance, const TrialPoint& at) {
    const CompiledTape& rates = compiled_rates();
    const Start from{convert_all<double>(at.start), tolerance, trial_.output_states()};
    if (method == Method::taylor) return make_taylor(rates, from);
    if (method == Method::riccati) return make_riccati(rates.rates(), *oscillator_, from);
    return make_integrator(method, rates.rates(), from);
}

ComparisonRow Contest::direct(Method method, double tolerance, const Workload& work) {
    const auto key = std::tuple(method, tolerance, work.points());
    if (const auto known = timed_.find(key); known != timed_.end()) {
        ComparisonRow again = known->second;
        again.task = work.task;
        return again;
    }
    ComparisonRow made = row(to_string(method), setting_of(tolerance), work);
    made.construction_seconds = timed([&] { (void)integrator(method, tolerance, at_); }).median;
    const std::unique_ptr<Integrator> prepared = integrator(method, tolerance, at_);
    OutputValues values = room_for(work.points());
    Run run;
    made.seconds = timed([&] { run = prepared->run(work.times->all, values); });
    made.failure = run.failure;
    judge(made, work, values);
    timed_[key] = made;
    return made;
}

std::vector<double> Contest::accuracy(Method method, double tolerance) {
    std::vector<double>& known = accuracies_[{method, tolerance}];
    if (!known.empty()) return known;
    const JudgedTimes& times = has_dense_output(method) ? judged_ : few_;
    OutputValues values = room_for(times.all.size());
    const Run run = integrator(method, tolerance, at_)->run(times.all, values);
    known = run.failure.empty() ? errors_.largest(times, values) : std::vector<double>(values.size(), NAN);
    return known;
}

ComparisonRow Contest::members(Method method, double tolerance, const Workload& work) {
    ComparisonRow made = row(to_string(method), setting_of(tolerance), work);
    OutputValues values = room_for(1);
    const double one = seconds_of(
        1, [&] { made.failure = integrator(method, tolerance, at_)->run(work.times->all, values).failure; });
    const auto affordable = static_cast<std::size_t>(seconds_of_members / std::max(one, 1e-9));
    std::vector<TrialPoint> starts;
    for (const std::size_t member : starts_->some(std::clamp(affordable, fewest_members, most_members)))
        starts.push_back(trial_.started(at_, starts_->start_of(member)));
    made.run_members = starts.size();
    const Timing seconds = timed([&] {
        for (const TrialPoint& start : starts) {
            const Run run = integrator(method, tolerance, start)->run(work.times->all, values);
            if (!run.failure.empty()) made.failure = run.failure;
        }
    });
    made.seconds = seconds.scaled(static_cast<double>(work.members) / static_cast<double>(made.run_members));
    judge_members(made, method, tolerance);
    return made;
}

void Contest::judge_members(ComparisonRow& row, Method method, double tolerance) {
    row.max_error.assign(trial_.output_states().size(), row.failure.empty() ? 0 : NAN);
    if (!row.failure.empty()) return;
    for (auto& [member, judged] : judged_members_) {
        OutputValues values = room_for(1);
        (void)integrator(method, tolerance, judged.at)->run(to_end_.times->all, values);
        const std::vector<double> errors = judged.errors.largest(*to_end_.times, values);
        for (std::size_t k = 0; k < errors.size(); ++k)
            row.max_error[k] = std::max(row.max_error[k], errors[k]);
    }
}

} // namespace resonform
