// SPDX-License-Identifier: GPL-3.0-or-later
// All methods at one eps: each task timed and judged.
#pragma once

#include "verify/comparison/comparison.hpp"
#include "verify/comparison/emitted_code.hpp"
#include "verify/comparison/judged_times.hpp"
#include "verify/comparison/members.hpp"
#include "verify/comparison/timing.hpp"
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/linear_oscillator.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace resonform {

struct Workload {
    Task task;
    std::shared_ptr<const JudgedTimes> times; // of dense and grid with as many points the same
    std::size_t members = 1;

    [[nodiscard]] std::size_t points() const { return times->all.size(); }
};

class Contest {
public:
    // rates: the equations with the values of [fix] put in. from: errors at earlier times do not count.
    // starts: the program whose start values an ensemble varies. All of them must outlive this.
    Contest(const Trial& trial, const Tape& rates, const Program& starts, const Rational& eps, double from,
            const CompareOptions& options);

    [[nodiscard]] const Rational& eps() const { return at_.eps; }
    [[nodiscard]] const std::vector<Workload>& workloads() const { return workloads_; }
    // The end alone.
    [[nodiscard]] const Workload& to_end() const { return to_end_; }

    // Why the code has no number at one of the times along the run; empty: it has them all.
    [[nodiscard]] std::string refusal(const EmittedCode& code) const {
        return refusal_at(along_.times->all, code);
    }
    // Integrates the references and compiles the equations, before anything is timed.
    // Errors: those of Trial::reference.
    void prepare();

    // A row that says no more than why the code has no number at one of the times of a task, if it has none.
    [[nodiscard]] ComparisonRow asked_only(const EmittedCode& code, const Workload& work) const;
    // A row for each form that does the task. Precondition of an ensemble: the code is compiled for it.
    std::vector<ComparisonRow> emitted(const EmittedCode& code, const Workload& work);
    // The largest errors along the run.
    std::vector<double> accuracy(const EmittedCode& code);

    // One point, or many, of one member. Each is timed once.
    ComparisonRow direct(Method method, double tolerance, const Workload& work);
    // Of an ensemble: a few members run, and the seconds are scaled to all.
    ComparisonRow members(Method method, double tolerance, const Workload& work);
    // The largest errors along the run, at 5 times of a method that steps to each; NaN if it did not reach
    // the end.
    std::vector<double> accuracy(Method method, double tolerance);

private:
    struct Member {
        TrialPoint at;
        ErrorsAgainstReference errors;
    };

    [[nodiscard]] std::string refusal_at(const std::vector<double>& times, const EmittedCode& code) const;
    [[nodiscard]] ComparisonRow row(std::string method, std::string setting, const Workload& work) const;
    [[nodiscard]] OutputValues room_for(std::size_t points) const;
    template <class Work> Timing timed(Work&& work) const {
        return measure(options_.repetitions, std::forward<Work>(work));
    }

    ComparisonRow scalar(const EmittedCode& code, const Workload& work, ComparisonRow row);
    ComparisonRow tabulated(const EmittedCode& code, const Workload& work, ComparisonRow row);
    ComparisonRow at_end(const EmittedCode& code, const Workload& work, ComparisonRow row);
    ComparisonRow ensemble(const EmittedCode& code, const Workload& work, ComparisonRow row);
    void judge(ComparisonRow& row, const Workload& work, const OutputValues& values);

    const CompiledTape& compiled_rates();
    std::unique_ptr<Integrator> integrator(Method method, double tolerance, const TrialPoint& at);
    void judge_members(ComparisonRow& row, Method method, double tolerance);

    const Trial& trial_;
    const CompareOptions& options_;
    const Tape& tape_;
    std::optional<LinearOscillator> oscillator_; // what the tape is, for Riccati
    TrialPoint at_;
    double from_;
    ErrorsAgainstReference errors_;
    std::optional<CompiledTape> rates_; // of the tape
    std::optional<Members> starts_;     // of an ensemble
    std::map<std::size_t, Member> judged_members_;
    Workload to_end_, along_; // along_: where the code has to have numbers
    JudgedTimes judged_;      // of along_
    JudgedTimes few_;         // of judged_
    std::vector<Workload> workloads_;
    std::map<std::tuple<Method, double, std::size_t>, ComparisonRow> timed_; // by points
    std::map<std::pair<Method, double>, std::vector<double>> accuracies_;
};

} // namespace resonform
