// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/work_precision.hpp"

#include "algebra/number/error.hpp"
#include "emit/program/build_program.hpp"
#include "model/files/interval_length.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/solve.hpp"
#include "verify/estimate/times.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/integrate/compiled_tape.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/judging/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

namespace resonform {

namespace {

constexpr std::array<Method, 3> rivals{Method::cvode_adams, Method::dopri5, Method::taylor};
constexpr int loosest = 4, tightest = 13;   // tolerances 1e-4 ... 1e-13
constexpr std::size_t judged_points = 2001; // of a dense output: where the reference is known

using Clock = std::chrono::steady_clock;
using OutputValues = std::vector<std::vector<double>>; // [output][point]

// The emitted evaluator of one order as users get it: without the states that verification keeps.
class Emitted {
public:
    Emitted(const Scene& scene, const Solution& solution, const VerifyOptions& options)
        : program_(build_program(solution, scene, {true, false, true})),
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

std::string setting_of(double tolerance) { return fmt::format("tolerance {:.0e}", tolerance); }

// Times to fill and where among them the reference is known.
struct Workload {
    Task task;
    std::vector<double> times;
    std::size_t first_judged, stride; // reference point first_judged + i is times[i * stride]
};

// The equations with the values of [fix] put in, as the emitted code has them.
Tape fixed_rates(const FirstOrderSystem& system, const Scene& scene) {
    FirstOrderSystem fixed = system;
    for (State& state : fixed.states) state.rate = scene.fixed(state.rate);
    return Tape::rates(fixed);
}

// All methods at one eps. Nothing is integrated before a row wants it.
class Comparer {
public:
    // from: errors at earlier times do not count.
    Comparer(const Trial& trial, const Tape& rates, const Rational& eps, double from,
             const CompareOptions& options)
        : trial_(trial), options_(options), at_(trial.point(eps)), from_(from),
          judged_(even_times(at_.interval, judged_points)), tape_(rates) {
        workloads_.push_back({Task::final, {judged_.back()}, judged_points - 1, 1});
        // Every interval of the reference is divided evenly.
        const std::size_t per = std::max<std::size_t>(1, options.dense_points / (judged_points - 1));
        Workload dense{Task::dense, {}, 0, per};
        for (std::size_t i = 0; i + 1 < judged_points; ++i)
            for (std::size_t j = 0; j < per; ++j) {
                const double share = static_cast<double>(j) / static_cast<double>(per);
                dense.times.push_back(judged_[i] + share * (judged_[i + 1] - judged_[i]));
            }
        dense.times.push_back(judged_.back());
        workloads_.push_back(std::move(dense));
    }

    [[nodiscard]] const Rational& eps() const { return at_.eps; }
    [[nodiscard]] const std::vector<Workload>& workloads() const { return workloads_; }

    // Why the code has no number at one of the times; empty: it has them all.
    [[nodiscard]] std::string refusal(const Emitted& code, const Workload& work) const {
        const Evaluator<double> evaluator = code.construct(at_);
        OutputValues values = room_for(work);
        std::vector<unsigned char> status(work.times.size());
        evaluator.batch(work.times, rows_of(values), status);
        return first_refusal(evaluator, status);
    }

    [[nodiscard]] ComparisonRow emitted(const Emitted& code, const Workload& work) {
        ComparisonRow row = start("emitted", code.setting(), work);
        const auto construct = [&] { // tables are made for many points
            Evaluator<double> evaluator = code.construct(at_);
            if (work.times.size() > 1) evaluator.prepare();
            return evaluator;
        };
        row.construction_seconds = measure([&] { (void)construct(); }).median;
        const Evaluator<double> evaluator = construct();
        OutputValues values = room_for(work);
        const std::vector<double*> rows = rows_of(values);
        std::vector<unsigned char> status(work.times.size());
        row.seconds = measure([&] { evaluator.batch(work.times, rows, status); });
        row.failure = first_refusal(evaluator, status);
        judge(row, work, values);
        return row;
    }

    [[nodiscard]] ComparisonRow direct(Method method, double tolerance, const Workload& work) {
        ComparisonRow row = start(to_string(method), setting_of(tolerance), work);
        const CompiledTape& rates = compiled_rates();
        const Start from{convert_all<double>(at_.start), tolerance, trial_.output_states()};
        const auto make = [&] {
            return method == Method::taylor ? make_taylor(rates, from)
                                            : make_integrator(method, rates.rates(), from);
        };
        row.construction_seconds = measure([&] { (void)make(); }).median;
        const std::unique_ptr<Integrator> integrator = make();
        OutputValues values = room_for(work);
        Run run;
        row.seconds = measure([&] { run = integrator->run(work.times, values); });
        row.failure = run.failure;
        judge(row, work, values);
        return row;
    }

private:
    [[nodiscard]] ComparisonRow start(std::string method, std::string setting, const Workload& work) const {
        ComparisonRow row;
        row.eps = at_.eps;
        row.method = std::move(method);
        row.setting = std::move(setting);
        row.task = work.task;
        row.points = work.times.size();
        return row;
    }

    [[nodiscard]] OutputValues room_for(const Workload& work) const {
        return OutputValues(trial_.output_states().size(), std::vector<double>(work.times.size()));
    }

    [[nodiscard]] static std::vector<double*> rows_of(OutputValues& values) {
        std::vector<double*> rows;
        for (auto& v : values) rows.push_back(v.data());
        return rows;
    }

    [[nodiscard]] static std::string first_refusal(const Evaluator<double>& evaluator,
                                                   const std::vector<unsigned char>& status) {
        const auto bad = std::find_if(status.begin(), status.end(),
                                      [](unsigned char s) { return static_cast<Status>(s) != Status::ok; });
        if (bad == status.end()) return "";
        const auto refused = static_cast<Status>(*bad);
        return told(refused, evaluator.why(refused));
    }

    const Reference& reference() {
        if (!reference_) reference_ = trial_.reference(at_, judged_);
        return *reference_;
    }

    const CompiledTape& compiled_rates() {
        if (!rates_)
            rates_.emplace(tape_, convert_all<double>(at_.parameters), to_double_value(at_.eps_value),
                           options_.cache, [&] {
                               if (options_.progress)
                                   options_.progress("compiling the equations for the direct methods");
                           });
        return *rates_;
    }

    // A method that did not reach the end gets the error NaN.
    void judge(ComparisonRow& row, const Workload& work, const OutputValues& values) {
        if (!row.failure.empty()) {
            row.max_error.assign(values.size(), NAN);
            return;
        }
        const Reference& reference = this->reference();
        for (std::size_t k = 0; k < values.size(); ++k) {
            double worst = 0;
            for (std::size_t i = 0; work.first_judged + i < judged_points; ++i) {
                if (judged_[work.first_judged + i] < from_) continue;
                const DoubleDouble error =
                    DoubleDouble(values[k][i * work.stride]) - reference.values[k][work.first_judged + i];
                const double size = std::abs(to_double_value(error));
                worst = size <= worst ? worst : size; // NaN counts as worst
            }
            row.max_error.push_back(worst);
        }
    }

    const Trial& trial_;
    const CompareOptions& options_;
    TrialPoint at_;
    double from_;
    std::vector<double> judged_; // where the reference is known
    const Tape& tape_;
    std::optional<Reference> reference_;
    std::optional<CompiledTape> rates_; // of the tape
    std::vector<Workload> workloads_;
};

bool no_worse(const std::vector<double>& errors, const std::vector<double>& than) {
    for (std::size_t k = 0; k < errors.size(); ++k)
        if (!(errors[k] <= than[k])) return false;
    return true;
}

RivalAtEqualAccuracy at_equal_accuracy(Method method, const std::vector<ComparisonRow>& rows,
                                       const BreakEven& own, const std::vector<double>& accuracy) {
    RivalAtEqualAccuracy rival;
    rival.method = to_string(method);
    for (const ComparisonRow& row : rows)
        if (row.method == rival.method && row.task == own.task && row.failure.empty() &&
            no_worse(row.max_error, accuracy) && row.total_seconds() < rival.seconds.value_or(INFINITY))
            rival.seconds = row.total_seconds();
    if (rival.seconds) rival.ratio = *rival.seconds / own.emitted_seconds;
    return rival;
}

} // namespace

const char* to_string(Task task) { return task == Task::final ? "final" : "dense"; }

BreakEven break_even(const std::vector<ComparisonRow>& rows, const ComparisonRow& emitted,
                     const ComparisonRow& along) {
    BreakEven result;
    result.task = emitted.task;
    result.emitted_seconds = emitted.total_seconds();
    result.failure = emitted.failure.empty() ? along.failure : emitted.failure;
    if (!result.failure.empty()) return result;
    result.winner = emitted.method;
    double best = result.emitted_seconds;
    for (const Method method : rivals) {
        RivalAtEqualAccuracy rival = at_equal_accuracy(method, rows, result, along.max_error);
        if (rival.seconds.value_or(INFINITY) < best) {
            best = *rival.seconds;
            result.winner = rival.method;
        }
        result.rivals.push_back(std::move(rival));
    }
    return result;
}

namespace {

// Tells which integration is running, if it takes long and nothing was told for a while.
class Pulse {
public:
    explicit Pulse(const CompareOptions& options) : options_(options) {}

    void before(Method method, double tolerance, const Workload& work) {
        const Clock::time_point now = Clock::now();
        if (!options_.progress || std::chrono::duration<double>(now - told_).count() < options_.silence)
            return;
        options_.progress(
            fmt::format("timing {}, {}, {}", to_string(method), to_string(work.task), setting_of(tolerance)));
        told_ = now;
    }

private:
    const CompareOptions& options_;
    Clock::time_point told_ = Clock::now();
};

// An eps at which the evaluator has no numbers: nobody wins, nothing is integrated, and the rows are those of
// the orders that refuse.
std::vector<BreakEven> refused_at(Comparer& comparer, const std::vector<Emitted>& codes,
                                  const std::string& refusal, std::vector<ComparisonRow>& rows) {
    std::vector<BreakEven> even;
    for (const Emitted& code : codes)
        for (const Workload& work : comparer.workloads())
            if (!comparer.refusal(code, work).empty()) rows.push_back(comparer.emitted(code, work));
    for (const Workload& work : comparer.workloads()) even.push_back({work.task, 0, {}, "", refusal});
    return even;
}

// One eps: its rows go to `rows`.
std::vector<BreakEven> compare_at(Comparer comparer, const std::vector<Emitted>& codes,
                                  const CompareOptions& options, std::vector<ComparisonRow>& rows) {
    const std::string refusal = comparer.refusal(codes.back(), comparer.workloads().back());
    if (!refusal.empty()) {
        if (options.progress)
            options.progress(fmt::format("the emitted code of {} has no numbers at eps = {} ({}), so nothing "
                                         "is integrated",
                                         codes.back().setting(), to_string(comparer.eps()), refusal));
        return refused_at(comparer, codes, refusal, rows);
    }
    std::vector<ComparisonRow> found, highest; // highest: of the scene's own order, per workload
    for (const Emitted& code : codes) {
        if (options.progress) options.progress(fmt::format("timing the emitted code of {}", code.setting()));
        highest.clear();
        for (const Workload& work : comparer.workloads()) highest.push_back(comparer.emitted(code, work));
        found.insert(found.end(), highest.begin(), highest.end());
    }
    for (const Method method : rivals) {
        if (options.progress) options.progress(fmt::format("timing {}", to_string(method)));
        Pulse pulse(options);
        for (const Workload& work : comparer.workloads())
            for (int digits = loosest; digits <= tightest; ++digits) {
                const double tolerance = std::pow(10.0, -digits);
                pulse.before(method, tolerance, work);
                found.push_back(comparer.direct(method, tolerance, work));
            }
    }
    std::vector<BreakEven> even;
    for (const ComparisonRow& emitted : highest) even.push_back(break_even(found, emitted, highest.back()));
    rows.insert(rows.end(), found.begin(), found.end());
    return even;
}

} // namespace

Comparison compare(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                   const Solution& solution, const CompareOptions& options) {
    const Tape rates = fixed_rates(*system, scene);
    const Trial trial(std::move(system), scene, solution, options, EpsFrom::command_line);
    Comparison result;
    result.system = trial.program()->system;
    result.scene = scene.name;
    for (const ProgramOutput& output : trial.program()->outputs) result.outputs.push_back(output.name);
    std::vector<Emitted> codes;
    for (int order = 1; order <= scene.order; ++order)
        codes.emplace_back(
            scene, solve(solution.normalization, options_of(scene, order, solution.truncation)), options);
    for (const Rational& eps : options.eps) {
        const double from = layer_end(*solution.normalization->normal_form.field, scene, eps);
        if (from > interval_length(scene, eps))
            refuse(Reason::integration,
                   {"the interval reaches beyond the layer that a scene without transients leaves out",
                    fmt::format("the layer takes {:.3g} at eps = {}", from, to_string(eps)),
                    "take a smaller --eps, or write transients = true", scene.transients_place});
        result.by_eps.push_back(
            {eps, compare_at(Comparer(trial, rates, eps, from, options), codes, options, result.rows)});
    }
    return result;
}

} // namespace resonform
