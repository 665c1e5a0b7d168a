// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/error.hpp"
#include "model/files/interval_length.hpp"
#include "verify/comparison/break_even.hpp"
#include "verify/comparison/comparison.hpp"
#include "verify/comparison/contest.hpp"
#include "verify/comparison/emitted_code.hpp"
#include "verify/comparison/equal_accuracy.hpp"
#include "verify/estimate/times.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/linear_oscillator.hpp"
#include "verify/run/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace resonform {

namespace {

constexpr int loosest_timed = 4, tightest_timed = 13; // 1e-4 ... 1e-13, whatever the accuracy

constexpr std::array task_list{Task::final, Task::dense, Task::grid, Task::ensemble};

// Implicit methods where something decays at eps = 0: elsewhere they have nothing to win. Riccati where
// there is a single linear oscillator.
std::vector<Method> rivals_of(const Solution& solution, const Tape& rates) {
    std::vector<Method> rivals{Method::cvode_adams, Method::arkode_explicit, Method::dopri5,
                               Method::fehlberg78,  Method::bulirsch_stoer,  Method::taylor};
    const std::vector<Mode>& modes = solution.normalization->normal_form.field->modes;
    if (std::any_of(modes.begin(), modes.end(), [](const Mode& mode) { return mode.is_damped(); }))
        rivals.insert(rivals.begin() + 2, {Method::cvode_bdf, Method::arkode_implicit});
    if (linear_oscillator(rates)) rivals.push_back(Method::riccati);
    return rivals;
}

// The equations with the values of [fix] put in, as the emitted code has them.
Tape fixed_rates(const FirstOrderSystem& system, const Scene& scene) {
    FirstOrderSystem fixed = system;
    for (State& state : fixed.states) state.rate = scene.fixed(state.rate);
    return Tape::rates(fixed);
}

// Tells which integration is running, if it takes long and nothing was told for a while.
class Pulse {
public:
    explicit Pulse(const CompareOptions& options) : options_(options) {}

    void before(Method method, double tolerance, Task task) {
        const Clock::time_point now = Clock::now();
        if (!options_.progress || std::chrono::duration<double>(now - told_).count() < options_.silence)
            return;
        options_.progress(
            fmt::format("timing {}, {}, {}", to_string(method), to_string(task), setting_of(tolerance)));
        told_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    const CompareOptions& options_;
    Clock::time_point told_ = Clock::now();
};

// One eps.
class Round {
public:
    Round(Contest& contest, const std::vector<EmittedCode>& codes, const std::vector<Method>& rivals,
          const CompareOptions& options)
        : contest_(contest), codes_(codes), rivals_(rivals), options_(options), pulse_(options) {}

    // The highest order is asked first: where it has no numbers nothing is integrated.
    std::vector<BreakEven> run() {
        const std::string refusal = contest_.refusal(codes_.back());
        if (!refusal.empty()) return refused(refusal);
        contest_.prepare();
        const OnOneProcessor held;
        pinned = held.processor().has_value();
        for (const EmittedCode& code : codes_) emitted(code);
        for (const Method method : rivals_) tolerances(method);
        std::vector<BreakEven> even;
        for (const EmittedCode& code : codes_) against(code, even);
        return even;
    }

    std::vector<ComparisonRow> rows;
    bool pinned = false;

private:
    void tell(const std::string& text) const {
        if (options_.progress) options_.progress(text);
    }

    // Nobody wins, and the rows are those that refuse.
    std::vector<BreakEven> refused(const std::string& refusal) {
        tell(fmt::format("the emitted code of {} has no numbers at eps = {} ({}), so nothing is integrated",
                         codes_.back().setting(), to_string(contest_.eps()), refusal));
        std::vector<BreakEven> even;
        for (const EmittedCode& code : codes_)
            for (const Workload& work : contest_.workloads()) {
                ComparisonRow row = contest_.asked_only(code, work);
                const std::string failure = row.failure.empty() ? refusal : row.failure;
                if (!row.failure.empty()) rows.push_back(row);
                even.push_back(break_even({std::move(row)}, {}, code.prepared(), failure));
            }
        return even;
    }

    void emitted(const EmittedCode& code) {
        tell(fmt::format("timing the emitted code of {}", code.setting()));
        for (const Workload& work : contest_.workloads())
            for (ComparisonRow& row : contest_.emitted(code, work)) rows.push_back(std::move(row));
    }

    // Those that are timed at every decade.
    static bool is_timed_at_decades(Method method, const Workload& work) {
        return work.task != Task::ensemble && (work.points() == 1 || has_cheap_output(method));
    }

    // One member, at every decade.
    void tolerances(Method method) {
        tell(fmt::format("timing {}", to_string(method)));
        for (const Workload& work : contest_.workloads())
            for (int digits = loosest_timed; digits <= tightest_timed && is_timed_at_decades(method, work);
                 ++digits) {
                const double tolerance = std::pow(10.0, -digits);
                pulse_.before(method, tolerance, work.task);
                rows.push_back(contest_.direct(method, tolerance, work));
            }
    }

    // All rivals at the accuracy of one order.
    void against(const EmittedCode& code, std::vector<BreakEven>& even) {
        const std::string refusal = contest_.refusal(code);
        std::vector<std::optional<Tuned>> tuned(rivals_.size());
        if (refusal.empty()) {
            const std::vector<double> accuracy = contest_.accuracy(code);
            for (std::size_t k = 0; k < rivals_.size(); ++k)
                tuned[k] = loosest_tolerance([&](double tolerance) {
                    pulse_.before(rivals_[k], tolerance, Task::dense);
                    return error_ratio(contest_.accuracy(rivals_[k], tolerance), accuracy);
                });
        }
        for (const Workload& work : contest_.workloads()) {
            std::vector<RivalAtEqualAccuracy> at;
            for (std::size_t k = 0; k < rivals_.size() && refusal.empty(); ++k)
                at.push_back(rival(rivals_[k], tuned[k], work));
            even.push_back(break_even(rows_of(code, work), std::move(at), code.prepared(), refusal));
        }
    }

    std::vector<ComparisonRow> rows_of(const EmittedCode& code, const Workload& work) const {
        std::vector<ComparisonRow> own;
        for (const ComparisonRow& row : rows)
            if (row.is_emitted() && row.order == code.program().weight(code.program().order) &&
                row.task == work.task && row.points == work.points() && row.members == work.members)
                own.push_back(row);
        return own;
    }

    RivalAtEqualAccuracy rival(Method method, const std::optional<Tuned>& tuned, const Workload& work) {
        RivalAtEqualAccuracy result;
        result.method = to_string(method);
        if (!tuned) return result;
        pulse_.before(method, tuned->tolerance, work.task);
        ComparisonRow row = work.task == Task::ensemble ? contest_.members(method, tuned->tolerance, work)
                                                        : contest_.direct(method, tuned->tolerance, work);
        result.tolerance = tuned->tolerance;
        result.error_ratio = tuned->ratio;
        if (row.failure.empty()) {
            result.seconds = row.total_seconds();
            result.spread = row.seconds;
            if (work.points() > 1)
                result.to_end = contest_.direct(method, tuned->tolerance, contest_.to_end()).total_seconds();
        }
        if (!is_timed_at_decades(method, work)) rows.push_back(std::move(row));
        return result;
    }

    Contest& contest_;
    const std::vector<EmittedCode>& codes_;
    const std::vector<Method>& rivals_;
    const CompareOptions& options_;
    Pulse pulse_;
};

// Where errors begin to count.
double judged_from(const Solution& solution, const Scene& scene, const Rational& eps) {
    const double from = layer_end(*solution.normalization->normal_form.field, scene, eps);
    if (from > interval_length(scene, eps))
        refuse(Reason::integration,
               {"the interval reaches beyond the layer that a scene without transients leaves out",
                fmt::format("the layer takes {:.3g} at eps = {}", from, to_string(eps)),
                "take a smaller --eps, or write transients = true", scene.transients_place});
    return from;
}

} // namespace

const char* to_string(Task task) {
    switch (task) {
    case Task::final: return "final";
    case Task::dense: return "dense";
    case Task::grid: return "grid";
    case Task::ensemble: return "ensemble";
    }
    return "unknown";
}

const char* to_string(Form form) {
    switch (form) {
    case Form::scalar: return "scalar";
    case Form::batch: return "batch";
    case Form::grid: return "grid";
    case Form::at_end: return "final";
    case Form::ensemble: return "ensemble";
    }
    return "unknown";
}

std::vector<std::string> task_names() {
    std::vector<std::string> names;
    for (const Task task : task_list) names.emplace_back(to_string(task));
    return names;
}

Task task_of(const std::string& name) {
    return *std::find_if(task_list.begin(), task_list.end(), [&](Task t) { return to_string(t) == name; });
}

Comparison compare(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                   const Solution& solution, const CompareOptions& options) {
    Comparison result;
    result.machine = this_machine();
    const Tape rates = fixed_rates(*system, scene);
    const VerifyOptions& usual = options;
    VerifyOptions interpreted = usual; // nothing of the trial's code is timed
    interpreted.compiled = false;
    const Trial trial(std::move(system), scene, solution, interpreted, EpsFrom::command_line);
    result.system = trial.program()->system;
    result.scene = scene.name;
    for (const ProgramOutput& output : trial.program()->outputs) result.outputs.push_back(output.name);
    const std::vector<EmittedCode> codes = emitted_codes(scene, solution, options);
    for (const EmittedCode& code : codes) result.prepared.push_back(code.prepared());
    const std::vector<Method> rivals = rivals_of(solution, rates);
    for (const Rational& eps : options.eps) {
        const double from = judged_from(solution, scene, eps);
        Contest contest(trial, rates, codes.back().program(), eps, from, options);
        Round round(contest, codes, rivals, options);
        result.by_eps.push_back({eps, round.run()});
        result.pinned = round.pinned;
        result.rows.insert(result.rows.end(), std::make_move_iterator(round.rows.begin()),
                           std::make_move_iterator(round.rows.end()));
    }
    find_break_even_eps(result.by_eps);
    return result;
}

} // namespace resonform
