// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/work_precision.hpp"

#include "verify/integrate.hpp"
#include "verify/interpreter.hpp"
#include "verify/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

constexpr std::array<Method, 3> rivals{Method::cvode_adams, Method::dopri5, Method::taylor};
constexpr int loosest = 4, tightest = 13;   // tolerances 1e-4 ... 1e-13
constexpr std::size_t judged_points = 2001; // of a dense output: where the reference is known
constexpr double worth_repeating = 0.05;    // seconds: shorter runs are repeated and the least time counts
constexpr int most_repetitions = 7;

using Clock = std::chrono::steady_clock;
using OutputValues = std::vector<std::vector<double>>; // [output][point]

// The least time of several runs; a long run is done once.
template <class Work> double least_seconds(Work&& work) {
    double least = std::numeric_limits<double>::infinity(), spent = 0;
    for (int i = 0; i < most_repetitions && (i == 0 || spent < worth_repeating); ++i) {
        const auto begin = Clock::now();
        work();
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        least = std::min(least, seconds);
        spent += seconds;
    }
    return least;
}

// The emitted evaluator of one order as users get it: without the states that verification keeps.
class Emitted {
public:
    Emitted(const Scene& scene, const Solution& solution, const VerifyOptions& options)
        : program_(build_program(solution, scene)),
          library_(EvaluatorLibrary::build(program_, options.cache, options.progress)) {}

    [[nodiscard]] Evaluator<double> construct(const TrialPoint& at) const {
        const double eps = to_double_value(at.eps_value);
        const std::vector<double> parameters = default_parameters<double>(program_, eps);
        return {library_, eps, parameters, default_start<double>(program_, eps, parameters),
                to_double_value(at.slow_time_end)};
    }
    [[nodiscard]] std::string setting() const { return fmt::format("order {}", program_.order); }

private:
    Program program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
};

// Times to fill and where among them the reference is known.
struct Workload {
    Task task;
    std::vector<double> times;
    std::size_t first_judged, stride; // reference point first_judged + i is times[i * stride]
};

class Comparer {
public:
    Comparer(const Trial& trial, const CompareOptions& options)
        : trial_(trial), at_(trial.point(options.eps)), reference_(trial.reference(at_, judged_points)) {
        workloads_.push_back({Task::final, {reference_.times.back()}, judged_points - 1, 1});
        // Every interval of the reference is divided evenly.
        const std::size_t per = std::max<std::size_t>(1, options.dense_points / (judged_points - 1));
        Workload dense{Task::dense, {}, 0, per};
        for (std::size_t i = 0; i + 1 < judged_points; ++i)
            for (std::size_t j = 0; j < per; ++j) {
                const double share = static_cast<double>(j) / static_cast<double>(per);
                dense.times.push_back(reference_.times[i] +
                                      share * (reference_.times[i + 1] - reference_.times[i]));
            }
        dense.times.push_back(reference_.times.back());
        workloads_.push_back(std::move(dense));
    }

    [[nodiscard]] const std::vector<Workload>& workloads() const { return workloads_; }

    [[nodiscard]] ComparisonRow emitted(const Emitted& code, const Workload& work) const {
        ComparisonRow row = start("emitted", code.setting(), work);
        row.construction_seconds = least_seconds([&] { (void)code.construct(at_); });
        const Evaluator<double> evaluator = code.construct(at_);
        OutputValues values(reference_.values.size(), std::vector<double>(work.times.size()));
        std::vector<double*> rows;
        for (auto& v : values) rows.push_back(v.data());
        std::vector<unsigned char> status(work.times.size());
        row.seconds = least_seconds([&] { evaluator.batch(work.times, rows, status); });
        const auto bad = std::find_if(status.begin(), status.end(),
                                      [](unsigned char s) { return static_cast<Status>(s) != Status::ok; });
        if (bad != status.end()) row.failure = to_string(static_cast<Status>(*bad));
        judge(row, work, values);
        return row;
    }

    [[nodiscard]] ComparisonRow direct(Method method, double tolerance, const Workload& work) const {
        ComparisonRow row = start(to_string(method), fmt::format("tolerance {:.0e}", tolerance), work);
        IntegrationResult run;
        row.seconds = least_seconds([&] {
            run = integrate(method, trial_.tape(), convert_all<double>(at_.parameters),
                            to_double_value(at_.eps_value), convert_all<double>(at_.start), work.times,
                            tolerance);
        });
        row.failure = run.failure;
        OutputValues values;
        for (const std::size_t s : trial_.output_states()) values.push_back(std::move(run.values[s]));
        judge(row, work, values);
        return row;
    }

private:
    static ComparisonRow start(std::string method, std::string setting, const Workload& work) {
        ComparisonRow row;
        row.method = std::move(method);
        row.setting = std::move(setting);
        row.task = work.task;
        row.points = work.times.size();
        return row;
    }

    void judge(ComparisonRow& row, const Workload& work, const OutputValues& values) const {
        for (std::size_t k = 0; k < values.size(); ++k) {
            double worst = 0;
            for (std::size_t i = 0; work.first_judged + i < judged_points; ++i) {
                const DoubleDouble error =
                    DoubleDouble(values[k][i * work.stride]) - reference_.values[k][work.first_judged + i];
                const double size = std::abs(to_double_value(error));
                worst = size <= worst ? worst : size; // NaN counts as worst
            }
            row.max_error.push_back(worst);
        }
    }

    const Trial& trial_;
    TrialPoint at_;
    Reference reference_;
    std::vector<Workload> workloads_;
};

bool no_worse(const std::vector<double>& errors, const std::vector<double>& than) {
    for (std::size_t k = 0; k < errors.size(); ++k)
        if (!(errors[k] <= than[k])) return false;
    return true;
}

// The accuracy asked of everyone is the emitted code's along the whole run: at a single time an error
// may vanish by accident.
BreakEven break_even(const std::vector<ComparisonRow>& rows, const ComparisonRow& emitted,
                     const std::vector<double>& accuracy) {
    BreakEven result;
    result.task = emitted.task;
    result.emitted_seconds = emitted.seconds + emitted.construction_seconds;
    result.winner = emitted.method;
    double best = result.emitted_seconds;
    for (const Method method : rivals) {
        RivalAtEqualAccuracy rival;
        rival.method = to_string(method);
        for (const ComparisonRow& row : rows)
            if (row.method == rival.method && row.task == emitted.task && row.failure.empty() &&
                no_worse(row.max_error, accuracy) && row.seconds < rival.seconds.value_or(INFINITY))
                rival.seconds = row.seconds;
        if (rival.seconds) rival.ratio = *rival.seconds / result.emitted_seconds;
        if (rival.seconds.value_or(INFINITY) < best) {
            best = *rival.seconds;
            result.winner = rival.method;
        }
        result.rivals.push_back(std::move(rival));
    }
    return result;
}

} // namespace

const char* to_string(Task task) { return task == Task::final ? "final" : "dense"; }

Comparison compare(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                   const Solution& solution, const CompareOptions& options) {
    const Trial trial(std::move(system), scene, solution, options);
    const Comparer comparer(trial, options);
    Comparison result;
    result.system = trial.program()->system;
    result.scene = scene.name;
    result.eps = options.eps;
    for (const ProgramOutput& output : trial.program()->outputs) result.outputs.push_back(output.name);
    std::vector<ComparisonRow> highest; // of the scene's own order, per workload
    for (int order = 1; order <= scene.order; ++order) {
        if (options.progress) options.progress(fmt::format("timing the emitted code of order {}", order));
        const Emitted code(scene, solve(solution.normalization, {order, solution.truncation}), options);
        highest.clear();
        for (const Workload& work : comparer.workloads()) highest.push_back(comparer.emitted(code, work));
        result.rows.insert(result.rows.end(), highest.begin(), highest.end());
    }
    for (const Method method : rivals) {
        if (options.progress) options.progress(fmt::format("timing {}", to_string(method)));
        for (const Workload& work : comparer.workloads())
            for (int digits = loosest; digits <= tightest; ++digits)
                result.rows.push_back(comparer.direct(method, std::pow(10.0, -digits), work));
    }
    for (const ComparisonRow& emitted : highest)
        result.break_even.push_back(break_even(result.rows, emitted, highest.back().max_error));
    return result;
}

} // namespace resonform
