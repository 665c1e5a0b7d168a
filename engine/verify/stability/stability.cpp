// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/stability.hpp"

#include "emit/program/build_program.hpp"
#include "model/files/interval_length.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/run/parallel.hpp"
#include "verify/stability/answers.hpp"
#include "verify/stability/reference.hpp"
#include "verify/symbolic/ulp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace resonform {

namespace {

constexpr std::size_t listed_points = 5; // the worst of each output
constexpr double covered_share = 0.5;    // of the decades of an input: with fewer there is none either

constexpr double noticed = 4;              // ulp: whose loss is looked for in the graph
constexpr double moderate_condition = 1e8; // half of the digits of double are left

std::vector<UlpBin> histogram_of(const std::vector<double>& ulps) {
    std::vector<UlpBin> bins;
    if (ulps.empty()) return bins;
    double largest = 0;
    for (const double ulp : ulps)
        if (std::isfinite(ulp)) largest = std::max(largest, ulp);
    for (double up_to = 0.5; bins.empty() || bins.back().up_to < largest; up_to *= 2)
        bins.push_back({up_to, 0});
    for (const double ulp : ulps) {
        if (!std::isfinite(ulp) && std::isfinite(bins.back().up_to))
            bins.push_back({std::numeric_limits<double>::infinity(), 0});
        ++std::find_if(bins.begin(), bins.end(), [&](const UlpBin& bin) {
              return !(ulp > bin.up_to);
          })->count;
    }
    return bins;
}

class Sweep {
public:
    Sweep(const Program& program, Stability& result)
        : program_(program), result_(result), ulps_(program.outputs.size()), worst_(program.outputs.size()) {}

    void add_answers(const SweepPoint& at, const std::vector<StabilityAnswer>& answers) {
        for (const StabilityAnswer& answer : answers) add_answer(at, answer);
    }

    // Which part of an output loses digits, at its worst point.
    void trace(const DigitTracer& tracer, double end) {
        for (std::size_t k = 0; k < worst_.size(); ++k) {
            if (worst_[k].empty()) continue;
            const Worst& first = worst_[k].front();
            if (first.point.ulp > noticed && std::isfinite(first.point.ulp))
                worst_[k].front().point.lost = tracer(first.at, end, first.t, k, first.unit);
        }
    }

    void finish() {
        for (std::size_t k = 0; k < ulps_.size(); ++k) {
            for (const Worst& w : worst_[k]) result_.worst.push_back(w.point);
            const std::string& output = program_.outputs[k].name;
            result_.histogram.emplace_back(output, histogram_of(ulps_[k]));
            std::erase_if(ulps_[k], [](double ulp) { return !std::isfinite(ulp); });
            if (ulps_[k].empty()) continue;
            const auto middle = ulps_[k].begin() + static_cast<long>(ulps_[k].size() / 2);
            std::nth_element(ulps_[k].begin(), middle, ulps_[k].end());
            result_.median.emplace_back(output, *middle);
        }
        std::stable_sort(result_.refusals.begin(), result_.refusals.end(),
                         [](const auto& a, const auto& b) { return a.count > b.count; });
        const Ruling found = ruling();
        result_.verdict = found.verdict;
        result_.rule = found.rule;
    }

private:
    struct Ruling {
        Verdict verdict;
        std::string rule; // with its numbers
    };

    [[nodiscard]] Ruling ruling() const {
        const Stability& s = result_;
        for (const WorstPoint& w : s.worst)
            if (w.is_wrong(s.threshold))
                return {
                    Verdict::fail,
                    fmt::format("no error is above {:g} ulp times 1 + what a last bit of {} does: "
                                "{} is off by {:.3g} ulp, where that is {:.3g}, with a condition number of "
                                "{:.3g}",
                                s.threshold, w.is_ill_conditioned() ? "the inputs" : "the slow time",
                                w.output, w.ulp, w.left_open(), w.unavoidable)};
        const auto cases = static_cast<double>(s.cases);
        if (static_cast<double>(s.unexplained) > unexplained_share * cases)
            return {Verdict::fail,
                    fmt::format(
                        "at most {:.0f} % of the points have a status without an explanation: {} of {} do",
                        100 * unexplained_share, s.unexplained, s.cases)};
        if (!(static_cast<double>(s.compared) >= compared_share * cases))
            return {Verdict::undecided,
                    fmt::format("{:.0f} % of the points are compared or more: {} of {} are",
                                100 * compared_share, s.compared, s.cases)};
        if (s.compared < s.beyond_reference)
            return {Verdict::undecided,
                    fmt::format("no more points lie beyond the reference than are compared: {} and {}",
                                s.beyond_reference, s.compared)};
        return coverage();
    }

    [[nodiscard]] Ruling coverage() const {
        for (std::size_t i = 0; i < result_.inputs.size(); ++i) {
            const double all = decades(result_.reachable[i]), here = decades(result_.swept[i]);
            if (here < covered_share * all)
                return {Verdict::undecided, fmt::format("every input is driven over half of the decades open "
                                                        "to it or more: {} over {:.1f} of "
                                                        "{:.1f} (more --points)",
                                                        result_.inputs[i].name, here, all)};
        }
        return {Verdict::pass, ""};
    }

    void add_answer(const SweepPoint& at, const StabilityAnswer& answer) {
        ++result_.cases;
        if (!answer.known) {
            ++result_.beyond_reference;
            return;
        }
        if (is_far_beyond(at, result_.inputs)) {
            add_unjudged(answer);
            return;
        }
        add(at, result_.swept);
        add(at, answer, result_.by_decade);
        if (answer.status != Status::ok) {
            ++result_.refused;
            ++result_.refused_by[to_string(answer.status)];
            if (!answer.explained) ++result_.unexplained;
            add_refusal(at, answer);
            return;
        }
        ++result_.compared;
        for (std::size_t k = 0; k < ulps_.size(); ++k) record(k, answer, at);
    }

    void add_unjudged(const StabilityAnswer& answer) {
        ++result_.not_judged;
        if (answer.status != Status::ok) ++result_.not_judged_refused_by[to_string(answer.status)];
        for (std::size_t k = 0; k < answer.ulp.size(); ++k) {
            double& worst = result_.not_judged_ulp[program_.outputs[k].name];
            worst = std::max(worst, answer.ulp[k]);
        }
    }

    void add_refusal(const SweepPoint& at, const StabilityAnswer& answer) {
        const std::string status = to_string(answer.status);
        auto found =
            std::find_if(result_.refusals.begin(), result_.refusals.end(), [&](const StabilityRefusals& r) {
                return r.status == status && r.why == answer.why;
            });
        if (found == result_.refusals.end())
            found = result_.refusals.insert(
                found, {status, answer.why, 0, 0, nothing_swept(result_.inputs), answer.t, answer.t, {}});
        ++found->count;
        if (!answer.explained && ++found->unexplained == 1) found->first = named(at, answer.t);
        add(at, found->where);
        found->first_t = std::min(found->first_t, answer.t);
        found->last_t = std::max(found->last_t, answer.t);
    }

    [[nodiscard]] NamedInputs named(const SweepPoint& at, double t) const {
        NamedInputs inputs{{"eps", at.eps}};
        for (std::size_t i = 0; i < at.parameters.size(); ++i)
            inputs.emplace_back(program_.parameters[i].name, at.parameters[i]);
        for (std::size_t i = 0; i < at.start.size(); ++i)
            inputs.emplace_back(program_.start[i].name, at.start[i]);
        inputs.emplace_back("t", t);
        return inputs;
    }

    struct Worst {
        WorstPoint point;
        SweepPoint at;
        double t = 0, unit = 0;
    };

    void record(std::size_t output, const StabilityAnswer& answer, const SweepPoint& at) {
        const double ulp = answer.ulp[output];
        ulps_[output].push_back(ulp);
        Worst worst{{program_.outputs[output].name,
                     ulp,
                     answer.conditioning.sum[output],
                     answer.conditioning.slow_time[output],
                     answer.conditioning.input[output],
                     {}},
                    at,
                    answer.t,
                    answer.units[output]};
        if (!(ulp <= result_.threshold) && !worst.point.is_wrong(result_.threshold)) {
            ++result_.ill_conditioned;
            if (!worst.point.is_ill_conditioned()) ++result_.moderately_ill_conditioned;
        }
        const auto before = [&](const Worst& a, const Worst& b) {
            return std::pair(a.point.is_wrong(result_.threshold), a.point.ulp) >
                   std::pair(b.point.is_wrong(result_.threshold), b.point.ulp);
        };
        std::vector<Worst>& list = worst_[output];
        const auto place = std::upper_bound(list.begin(), list.end(), worst, before);
        if (place == list.end() && list.size() == listed_points) return;
        WorstPoint& point = worst.point;
        point.at = named(at, answer.t);
        // without free inputs every start is the same
        if (std::any_of(list.begin(), list.end(), [&](const Worst& w) { return w.point.at == point.at; }))
            return;
        list.insert(place, std::move(worst));
        if (list.size() > listed_points) list.pop_back();
    }

    const Program& program_;
    Stability& result_;
    std::vector<std::vector<double>> ulps_;
    std::vector<std::vector<Worst>> worst_;
};

} // namespace

bool WorstPoint::is_ill_conditioned() const { return !(unavoidable < moderate_condition); }

double WorstPoint::left_open() const { return is_ill_conditioned() ? unavoidable : by_slow_time; }

bool WorstPoint::is_wrong(double threshold) const {
    return !std::isinf(left_open()) && !(ulp <= threshold * (1 + left_open()));
}

Stability stability(const Scene& scene, const Solution& solution, const StabilityOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    if (!scene.verify.eps.empty()) (void)bounded_interval_length(scene, scene.verify.eps.back());
    const auto shared = std::make_shared<const Interpretation>(
        std::make_shared<const Program>(build_program(solution, scene, {false, false})));
    const Program& program = *shared->program;
    const CppPlan& plan = shared->plan;
    Stability result;
    result.system = program.system;
    result.scene = program.scene;
    result.seed = options.seed;
    result.threshold = scene.verify.ulp;
    result.reason = scene.verify.ulp_reason;
    result.inputs = swept_inputs(program, *scene.system);
    result.swept = nothing_swept(result.inputs);
    result.by_decade = no_decades(result.inputs);
    const StabilityReference reference(program, solution, scene);
    const StabilityTrial trial(program, EvaluatorLibrary::build(program, options.cache, options.progress),
                               reference, result.threshold,
                               plan.loses_digits ? plan.phase_names[*plan.loses_digits] : "");
    if (options.progress) options.progress("sweeping the inputs over their decades");
    constexpr std::size_t times = shares_of_interval.size();
    const auto inside = [&](const SweepPoint& at) { return reference.inside(at); };
    result.reachable = reachable_inputs(program, scene, inside);
    const std::vector<SweepPoint> points =
        sweep_points(program, scene, (options.points + times - 1) / times, options.seed, inside);
    std::vector<std::vector<StabilityAnswer>> answers(points.size());
    in_parallel(points.size(), [&](std::size_t i) {
        answers[i] = trial(points[i], std::min(times, options.points - i * times));
    });
    Sweep sweep(program, result);
    for (std::size_t i = 0; i < points.size(); ++i) sweep.add_answers(points[i], answers[i]);
    sweep.trace(DigitTracer(shared), trial.end());
    sweep.finish();
    if (options.progress)
        options.progress(
            fmt::format("swept in {:.1f} s",
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return result;
}

} // namespace resonform
