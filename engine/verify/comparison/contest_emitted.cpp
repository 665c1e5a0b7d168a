// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of emitted code.
#include "verify/comparison/contest.hpp"
#include "verify/evaluate/ensemble.hpp"
#include "verify/evaluate/evaluator.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

using Statuses = std::vector<unsigned char>;

std::vector<Form> forms_of(Task task) {
    switch (task) {
    case Task::final: return {Form::at_end, Form::scalar};
    case Task::dense: return {Form::batch, Form::scalar};
    case Task::grid: return {Form::grid};
    case Task::ensemble: return {Form::ensemble};
    }
    return {};
}

Status first_not_ok(const Statuses& statuses) {
    const auto bad = std::find_if(statuses.begin(), statuses.end(),
                                  [](unsigned char s) { return static_cast<Status>(s) != Status::ok; });
    return bad == statuses.end() ? Status::ok : static_cast<Status>(*bad);
}

std::string refusal_of(const Evaluator<double>& evaluator, const Statuses& statuses) {
    const Status refused = first_not_ok(statuses);
    return refused == Status::ok ? "" : told(refused, evaluator.why(refused));
}

} // namespace

std::vector<ComparisonRow> Contest::emitted(const EmittedCode& code, const Workload& work) {
    std::vector<ComparisonRow> rows;
    for (const Form form : forms_of(work.task)) {
        ComparisonRow made = row("emitted", code.setting(), work);
        made.order = code.program().weight(code.program().order);
        made.form = form;
        switch (form) {
        case Form::scalar: rows.push_back(scalar(code, work, std::move(made))); break;
        case Form::batch:
        case Form::grid: rows.push_back(tabulated(code, work, std::move(made))); break;
        case Form::at_end: rows.push_back(at_end(code, work, std::move(made))); break;
        case Form::ensemble: rows.push_back(ensemble(code, work, std::move(made))); break;
        }
    }
    return rows;
}

ComparisonRow Contest::scalar(const EmittedCode& code, const Workload& work, ComparisonRow row) {
    row.construction_seconds = timed([&] { (void)code.construct(at_); }).median;
    const Evaluator<double> evaluator = code.construct(at_);
    OutputValues values = room_for(work.points());
    std::vector<double> one(values.size());
    Statuses statuses(work.points());
    row.seconds = timed([&] {
        for (std::size_t i = 0; i < work.points(); ++i) {
            statuses[i] = static_cast<unsigned char>(evaluator.call(work.times->all[i], one.data()));
            for (std::size_t k = 0; k < one.size(); ++k) values[k][i] = one[k];
        }
    });
    row.failure = refusal_of(evaluator, statuses);
    judge(row, work, values);
    return row;
}

// Tables are made for many points, before the clock runs: construction.
ComparisonRow Contest::tabulated(const EmittedCode& code, const Workload& work, ComparisonRow row) {
    const auto construct = [&] {
        Evaluator<double> evaluator = code.construct(at_);
        evaluator.prepare();
        return evaluator;
    };
    row.construction_seconds = timed([&] { (void)construct(); }).median;
    const Evaluator<double> evaluator = construct();
    OutputValues values = room_for(work.points());
    const std::vector<double*> arrays = arrays_of(values);
    Statuses statuses(work.points());
    const double step = at_.interval / static_cast<double>(work.points() - 1);
    row.seconds = timed([&] {
        if (row.form == Form::grid)
            evaluator.grid(0, step, arrays, statuses);
        else
            evaluator.batch(work.times->all, arrays, statuses);
    });
    row.failure = refusal_of(evaluator, statuses);
    judge(row, work, values);
    return row;
}

ComparisonRow Contest::at_end(const EmittedCode& code, const Workload& work, ComparisonRow row) {
    const FinalPointLibrary library(code.library());
    const double eps = to_double_value(at_.eps_value), t = work.times->all.back();
    const std::vector<double> parameters = code.parameters(at_), start = code.start(at_);
    std::vector<double> one(trial_.output_states().size());
    Status status = Status::ok;
    row.seconds =
        timed([&] { status = library.at_end(eps, parameters.data(), start.data(), t, one.data()); });
    if (status != Status::ok) row.failure = told(status, code.construct(at_).why(status));
    OutputValues values = room_for(1);
    for (std::size_t k = 0; k < one.size(); ++k) values[k][0] = one[k];
    judge(row, work, values);
    return row;
}

ComparisonRow Contest::ensemble(const EmittedCode& code, const Workload& work, ComparisonRow row) {
    const EnsembleLibrary library(code.library());
    const std::size_t n = work.members;
    const std::vector<double> eps(n, to_double_value(at_.eps_value)), t(n, work.times->all.back());
    const std::vector<std::vector<double>> starts = starts_->arrays_for(code.program());
    std::vector<const double*> arguments(1 + code.program().parameters.size(), nullptr);
    arguments.front() = eps.data();
    for (const std::vector<double>& array : starts) arguments.push_back(array.data());
    OutputValues values = room_for(n);
    const std::vector<double*> arrays = arrays_of(values);
    Statuses statuses(n);
    row.seconds = timed([&] { library.evaluate(arguments, n, t.data(), arrays, statuses.data()); });
    if (const Status refused = first_not_ok(statuses); refused != Status::ok) {
        row.failure = to_string(refused);
        row.max_error.assign(values.size(), NAN);
        return row;
    }
    row.max_error.assign(values.size(), 0);
    for (auto& [member, judged] : judged_members_) {
        OutputValues own = room_for(1);
        for (std::size_t k = 0; k < own.size(); ++k) own[k][0] = values[k][member];
        const std::vector<double> errors = judged.errors.largest(*work.times, own);
        for (std::size_t k = 0; k < own.size(); ++k) row.max_error[k] = std::max(row.max_error[k], errors[k]);
    }
    return row;
}

std::string Contest::refusal_at(const std::vector<double>& times, const EmittedCode& code) const {
    const Evaluator<double> evaluator = code.construct(at_);
    OutputValues values = room_for(times.size());
    Statuses statuses(times.size());
    evaluator.batch(times, arrays_of(values), statuses);
    return refusal_of(evaluator, statuses);
}

ComparisonRow Contest::asked_only(const EmittedCode& code, const Workload& work) const {
    ComparisonRow asked = row("emitted", code.setting(), work);
    asked.order = code.program().weight(code.program().order);
    asked.form = forms_of(work.task).front();
    asked.failure = refusal_at(work.times->all, code);
    asked.max_error.assign(trial_.output_states().size(), NAN);
    return asked;
}

std::vector<double> Contest::accuracy(const EmittedCode& code) {
    const Evaluator<double> evaluator = code.construct(at_);
    OutputValues values = room_for(judged_.all.size());
    Statuses statuses(judged_.all.size());
    evaluator.batch(judged_.all, arrays_of(values), statuses);
    return errors_.largest(judged_, values);
}

} // namespace resonform
