// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability.hpp"

#include "verify/evaluator.hpp"
#include "verify/interpreter.hpp"
#include "verify/stability_points.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace resonform {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

constexpr std::size_t listed_points = 5; // the worst of each output
constexpr std::array<double, 6> shares_of_interval{0, 1e-9, 0.1, 1.0 / 3, 0.7, 1};

std::vector<Wide> widen(const std::vector<double>& values) { return {values.begin(), values.end()}; }

class Sweep {
public:
    Sweep(std::shared_ptr<const Program> program, std::shared_ptr<const EvaluatorLibrary> library,
          Stability& result)
        : program_(std::move(program)), library_(std::move(library)), result_(result),
          ulps_(program_->outputs.size()), worst_(program_->outputs.size()) {}

    // One construction, several times; the reference is built only if the emitted code answers, and as far as
    // it does.
    void try_point(const SweepPoint& at) {
        // A little longer than the interval: t = end/eps is rounded.
        const double end = program_->interval_slow_time * (1 + 0x1p-40);
        const Evaluator<double> emitted(library_, at.eps, at.parameters, at.start, end);
        std::vector<std::pair<double, std::vector<double>>> answers; // t, values
        double reach = end * shares_of_interval[1];
        for (const double share : shares_of_interval) {
            ++result_.cases;
            const double t = share * program_->interval_slow_time / at.eps;
            std::vector<double> values(program_->outputs.size());
            const Status status = emitted.call(t, values.data());
            if (status != Status::ok) {
                ++result_.refused;
                ++result_.refused_by[to_string(status)];
                continue;
            }
            answers.emplace_back(t, std::move(values));
            reach = std::max(reach, share * end);
        }
        if (answers.empty()) return;
        const Interpreter<Wide> symbolic(program_, Wide(at.eps), widen(at.parameters), widen(at.start),
                                         Wide(reach));
        for (const auto& [t, values] : answers) compare(values, symbolic, at, t);
    }

    void finish() {
        for (std::size_t k = 0; k < ulps_.size(); ++k) {
            result_.worst.insert(result_.worst.end(), worst_[k].begin(), worst_[k].end());
            if (ulps_[k].empty()) continue;
            const auto middle = ulps_[k].begin() + static_cast<long>(ulps_[k].size() / 2);
            std::nth_element(ulps_[k].begin(), middle, ulps_[k].end());
            result_.median.emplace_back(program_->outputs[k].name, *middle);
        }
    }

private:
    void compare(const std::vector<double>& values, const Interpreter<Wide>& symbolic, const SweepPoint& at,
                 double t) {
        std::vector<Wide> exact, scale;
        // Phases that are too large for double, by a hair, are not for 50 digits.
        const auto answers = [](Status s) { return s == Status::ok || s == Status::low_precision; };
        if (!answers(symbolic.call(Wide(t), exact)) || !answers(symbolic.scale(Wide(t), scale)))
            ++result_.beyond_reference;
        else
            for (std::size_t k = 0; k < values.size(); ++k)
                record(k, ulp(values[k], exact[k], scale[k]), at, t);
    }

    // |value - exact| over the spacing of doubles at the scale.
    static double ulp(double value, const Wide& exact, const Wide& scale) {
        if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
        const Wide spacing = scale * Wide(0x1p-52), least(std::numeric_limits<double>::denorm_min());
        const Wide error = abs(Wide(value) - exact);
        return static_cast<double>(Wide(error / (spacing < least ? least : spacing)));
    }

    void record(std::size_t output, double ulp, const SweepPoint& at, double t) {
        ulps_[output].push_back(ulp);
        std::vector<WorstPoint>& list = worst_[output];
        if (list.size() == listed_points && !(ulp > list.back().ulp)) return;
        WorstPoint point{program_->outputs[output].name, ulp, {{"eps", at.eps}}};
        for (std::size_t i = 0; i < at.parameters.size(); ++i)
            point.at.emplace_back(program_->parameters[i].name, at.parameters[i]);
        for (std::size_t i = 0; i < at.start.size(); ++i)
            point.at.emplace_back(program_->start[i].name, at.start[i]);
        point.at.emplace_back("t", t);
        const auto place =
            std::find_if(list.begin(), list.end(), [ulp](const WorstPoint& p) { return p.ulp < ulp; });
        list.insert(place, std::move(point));
        if (list.size() > listed_points) list.pop_back();
    }

    std::shared_ptr<const Program> program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    Stability& result_;
    std::vector<std::vector<double>> ulps_;
    std::vector<std::vector<WorstPoint>> worst_;
};

} // namespace

Stability stability(const Scene& scene, const Solution& solution, const StabilityOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    const auto program = std::make_shared<const Program>(build_program(solution, scene, {false, false}));
    Stability result;
    result.system = program->system;
    result.scene = program->scene;
    Sweep sweep(program, EvaluatorLibrary::build(*program, options.cache, options.progress), result);
    if (options.progress) options.progress("sweeping the inputs over their decades");
    for (const SweepPoint& point :
         sweep_points(*program, solution.system(), options.random_points, options.seed))
        sweep.try_point(point);
    sweep.finish();
    if (options.progress)
        options.progress(
            fmt::format("swept in {:.1f} s",
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return result;
}

std::string to_text(const Stability& s) {
    std::string text = fmt::format("{} / {}: double against 50 digits, errors in ulp of the output's scale\n"
                                   "  {} cases, {} refused",
                                   s.system, s.scene, s.cases, s.refused);
    for (const auto& [status, count] : s.refused_by) text += fmt::format(", {} {}", count, status);
    text += fmt::format(", {} beyond the reference\n", s.beyond_reference);
    for (const auto& [name, ulp] : s.median) text += fmt::format("  {:<8} median {:.2g} ulp\n", name, ulp);
    for (const WorstPoint& w : s.worst) {
        text += fmt::format("  {:<8} {:>9.3g} ulp at", w.output, w.ulp);
        for (const auto& [name, value] : w.at) text += fmt::format(" {} = {:.6g}", name, value);
        text += "\n";
    }
    return text;
}

} // namespace resonform
