// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/comparison/contest.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr std::size_t points_along = 2001; // where no task has more
constexpr std::size_t most_judged_members = 3;
constexpr std::size_t few_times = 4; // and 0: each ends a step that would be longer without

JudgedTimes few_of(const JudgedTimes& times) {
    JudgedTimes few;
    for (std::size_t i = 0; i <= few_times; ++i) {
        few.judged.push_back(i);
        few.all.push_back(times.all[i * (times.all.size() - 1) / few_times]);
    }
    return few;
}

// The task with the most points, if it has enough of them.
Workload along_of(const std::vector<Workload>& workloads, double interval) {
    const Workload* most = nullptr;
    for (const Workload& work : workloads)
        if (work.points() >= points_along && (most == nullptr || work.points() > most->points()))
            most = &work;
    return most != nullptr ? *most : Workload{Task::dense, evenly_judged(interval, points_along)};
}

} // namespace

Contest::Contest(const Trial& trial, const Tape& rates, const Program& starts, const Rational& eps,
                 double from, const CompareOptions& options)
    : trial_(trial), options_(options), tape_(rates), oscillator_(linear_oscillator(rates)),
      at_(trial.point(eps)), from_(from),
      errors_(trial, at_, from), to_end_{Task::final, evenly_judged(at_.interval, 1)} {
    std::map<std::size_t, std::shared_ptr<const JudgedTimes>> even;
    for (const Task task : options.tasks) {
        if (task == Task::final) workloads_.push_back(to_end_);
        if (task == Task::ensemble) workloads_.push_back({task, to_end_.times, options.members});
        if (task != Task::dense && task != Task::grid) continue;
        for (const std::size_t points : options.points) {
            auto& times = even[points];
            if (!times) times = evenly_judged(at_.interval, points);
            workloads_.push_back({task, times});
        }
    }
    along_ = along_of(workloads_, at_.interval);
    for (const std::size_t i : along_.times->judged) {
        judged_.judged.push_back(judged_.all.size());
        judged_.all.push_back(along_.times->all[i]);
    }
    few_ = few_of(judged_);
    errors_.expect(*to_end_.times);
    errors_.expect(*along_.times);
    for (const auto& [points, times] : even) errors_.expect(*times);
    for (const Workload& work : workloads_)
        if (work.task == Task::ensemble)
            starts_.emplace(starts, to_double_value(at_.eps_value), work.members);
}

void Contest::prepare() {
    (void)errors_.largest(*to_end_.times, room_for(1));
    (void)compiled_rates();
    if (!starts_) return;
    for (const std::size_t member : starts_->some(most_judged_members)) {
        const TrialPoint at = trial_.started(at_, starts_->start_of(member));
        Member judged{at, ErrorsAgainstReference(trial_, at, from_)};
        judged.errors.expect(*to_end_.times);
        (void)judged.errors.largest(*to_end_.times, room_for(1));
        judged_members_.emplace(member, std::move(judged));
    }
}

ComparisonRow Contest::row(std::string method, std::string setting, const Workload& work) const {
    ComparisonRow row;
    row.eps = at_.eps;
    row.method = std::move(method);
    row.setting = std::move(setting);
    row.task = work.task;
    row.points = work.points();
    row.members = row.run_members = work.members;
    return row;
}

OutputValues Contest::room_for(std::size_t points) const {
    return OutputValues(trial_.output_states().size(), std::vector<double>(points));
}

// A method that did not reach the end gets the error NaN.
void Contest::judge(ComparisonRow& row, const Workload& work, const OutputValues& values) {
    if (row.failure.empty())
        row.max_error = errors_.largest(*work.times, values);
    else
        row.max_error.assign(values.size(), NAN);
}

} // namespace resonform
