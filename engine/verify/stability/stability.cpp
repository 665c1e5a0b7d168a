// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/stability.hpp"

#include "emit/program/build_program.hpp"
#include "model/files/interval_length.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/stability/reference.hpp"
#include "verify/symbolic/ulp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace resonform {

namespace {

constexpr std::size_t listed_points = 5; // the worst of each output
constexpr double covered_share = 0.5;    // of the decades of an input: with fewer there is none either

bool is_beyond_double(const SymbolicPoint& exact) {
    return std::any_of(exact.scales.begin(), exact.scales.end(),
                       [](const Wide& scale) { return !(scale < Wide(std::numeric_limits<double>::max())); });
}

class Sweep {
public:
    Sweep(const Program& program, std::shared_ptr<const EvaluatorLibrary> library,
          const StabilityReference& reference, Stability& result)
        : program_(program), library_(std::move(library)), reference_(reference), result_(result),
          ulps_(program.outputs.size()), worst_(program.outputs.size()) {}

    // One construction, several times.
    void try_point(const SweepPoint& at, std::size_t times) {
        // A little longer than the interval: t = end/eps is rounded.
        const double end = program_.interval_slow_time * (1 + 0x1p-40);
        const Evaluator<double> emitted(library_, at.eps, at.parameters, at.start, end);
        StabilityReference::From exact(reference_, at, end);
        std::vector<double> values(program_.outputs.size());
        for (std::size_t i = 0; i < times; ++i) {
            const double t = shares_of_interval[i] * program_.interval_slow_time / at.eps;
            const Status status = emitted.call(t, values.data());
            compare(status, values, exact, at, t);
        }
    }

    void finish() {
        for (std::size_t k = 0; k < ulps_.size(); ++k) {
            result_.worst.insert(result_.worst.end(), worst_[k].begin(), worst_[k].end());
            if (ulps_[k].empty()) continue;
            const auto middle = ulps_[k].begin() + static_cast<long>(ulps_[k].size() / 2);
            std::nth_element(ulps_[k].begin(), middle, ulps_[k].end());
            result_.median.emplace_back(program_.outputs[k].name, *middle);
        }
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
                    fmt::format("no error is above {:g} ulp times 1 + what a last bit of the inputs does: "
                                "{} is off by {:.3g} ulp, where that is {:.3g}",
                                s.threshold, w.output, w.ulp, w.unavoidable)};
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
            const double all = decades(result_.inputs[i]), here = decades(result_.swept[i]);
            if (here < covered_share * all)
                return {
                    Verdict::undecided,
                    fmt::format("every input is driven over half of its decades or more: {} over {:.1f} of "
                                "{:.1f} (more --points)",
                                result_.inputs[i].name, here, all)};
        }
        return {Verdict::pass, ""};
    }

    void compare(Status status, const std::vector<double>& values, StabilityReference::From& from,
                 const SweepPoint& at, double t) {
        ++result_.cases;
        const SymbolicPoint& exact = from.at(t);
        const bool known = exact.status != Status::outside_interval;
        if (!known) {
            ++result_.beyond_reference;
            return;
        }
        add(at, result_.swept);
        if (status != Status::ok) {
            ++result_.refused;
            ++result_.refused_by[to_string(status)];
            if (!explains(status, exact, from, t)) ++result_.unexplained;
            return;
        }
        ++result_.compared;
        const std::vector<double> ulp = from.ulp(t, values);
        std::vector<double> unavoidable(values.size(), 0.0);
        if (std::any_of(ulp.begin(), ulp.end(), [&](double u) { return !(u <= result_.threshold); }))
            unavoidable = from.unavoidable(t);
        for (std::size_t k = 0; k < values.size(); ++k) record(k, ulp[k], unavoidable[k], at, t);
    }

    // Every input lies within its declared range: none of them can be a bad argument.
    bool explains(Status status, const SymbolicPoint& exact, StabilityReference::From& from, double t) const {
        if (status == Status::bad_argument) return false;
        if (exact.status != Status::ok || is_beyond_double(exact)) return true;
        if (status == Status::outside_interval && from.loses_phase(t)) return true;
        if (status == Status::low_precision && (from.has_large_phase(t) || from.has_grown(t))) return true;
        return std::isinf(from.unavoidable(t).front());
    }

    void record(std::size_t output, double ulp, double unavoidable, const SweepPoint& at, double t) {
        if (std::isfinite(ulp)) ulps_[output].push_back(ulp);
        WorstPoint point{program_.outputs[output].name, ulp, unavoidable, {{"eps", at.eps}}};
        const auto before = [&](const WorstPoint& a, const WorstPoint& b) {
            return std::pair(a.is_wrong(result_.threshold), a.ulp) >
                   std::pair(b.is_wrong(result_.threshold), b.ulp);
        };
        std::vector<WorstPoint>& list = worst_[output];
        const auto place = std::upper_bound(list.begin(), list.end(), point, before);
        if (place == list.end() && list.size() == listed_points) return;
        for (std::size_t i = 0; i < at.parameters.size(); ++i)
            point.at.emplace_back(program_.parameters[i].name, at.parameters[i]);
        for (std::size_t i = 0; i < at.start.size(); ++i)
            point.at.emplace_back(program_.start[i].name, at.start[i]);
        point.at.emplace_back("t", t);
        // without free inputs every start is the same
        if (std::any_of(list.begin(), list.end(), [&](const WorstPoint& w) { return w.at == point.at; }))
            return;
        list.insert(place, std::move(point));
        if (list.size() > listed_points) list.pop_back();
    }

    const Program& program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    const StabilityReference& reference_;
    Stability& result_;
    std::vector<std::vector<double>> ulps_;
    std::vector<std::vector<WorstPoint>> worst_;
};

} // namespace

bool WorstPoint::is_wrong(double threshold) const {
    return !std::isinf(unavoidable) && !(ulp <= threshold * (1 + unavoidable));
}

Stability stability(const Scene& scene, const Solution& solution, const StabilityOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    if (!scene.verify.eps.empty()) (void)bounded_interval_length(scene, scene.verify.eps.back());
    const Program program = build_program(solution, scene, {false, false});
    Stability result;
    result.system = program.system;
    result.scene = program.scene;
    result.seed = options.seed;
    result.threshold = scene.verify.ulp;
    result.reason = scene.verify.ulp_reason;
    result.inputs = swept_inputs(program, *scene.system);
    result.swept = nothing_swept(result.inputs);
    const StabilityReference reference(program, solution, scene);
    Sweep sweep(program, EvaluatorLibrary::build(program, options.cache, options.progress), reference,
                result);
    if (options.progress) options.progress("sweeping the inputs over their decades");
    constexpr std::size_t times = shares_of_interval.size();
    const auto inside = [&](const SweepPoint& at) { return reference.inside(at); };
    for (const SweepPoint& point :
         sweep_points(program, scene, (options.points + times - 1) / times, options.seed, inside))
        sweep.try_point(point, std::min(times, options.points - result.cases));
    sweep.finish();
    if (options.progress)
        options.progress(
            fmt::format("swept in {:.1f} s",
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return result;
}

} // namespace resonform
