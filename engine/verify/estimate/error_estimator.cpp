// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/error_estimator.hpp"

#include "emit/program/build_program.hpp"
#include "model/files/settings.hpp"
#include "model/system/scene_file.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/solve.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/run/real.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace resonform {

namespace {

constexpr int most_weights = 2; // of whole ones, those that may all vanish

using Indices = std::vector<std::size_t>;

// M' of a formula of order N'.
int next_truncation(const Scene& scene, const Solution& solution, int order) {
    return std::max(solution.truncation + order - solution.order, counted_truncation(scene, solution, order));
}

std::shared_ptr<const Interpretation> interpretation(const Solution& solution, const Scene& scene) {
    return std::make_shared<const Interpretation>(
        std::make_shared<const Program>(build_program(solution, scene)));
}

// The outputs that are known not to change through the order of `richer`, and the others.
std::pair<Indices, Indices> unmoved_and_moved(const Scene& scene, const Solution& solution,
                                              const Solution& richer, const Indices& outputs) {
    const std::optional<int> power = time_power(scene);
    if (!power) return {{}, outputs};
    std::pair<Indices, Indices> parts;
    try {
        const Neglected neglected(richer, formula_of(scene, solution, *power));
        for (const std::size_t k : outputs) {
            const std::optional<ErrorPower> error = neglected.power(scene.outputs[k]);
            (error && error->power <= richer.order ? parts.second : parts.first).push_back(k);
        }
    } catch (const Error&) { // no power bounds what neighbouring solutions part by
        return {{}, outputs};
    }
    return parts;
}

// The next weight may hold parameters that the formula does not.
void require_values(const Scene& scene, const std::vector<std::shared_ptr<const Program>>& programs,
                    const std::vector<std::string>& given) {
    std::vector<std::string> missing;
    const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const auto& program : programs)
        for (const ProgramInput& parameter : program->parameters)
            if (!is_in(missing, parameter.name) && !is_in(given, parameter.name))
                missing.push_back(parameter.name);
    if (!missing.empty())
        not_fixed(scene, "the error estimate needs a value for every parameter of the next weight", missing);
}

template <class Real> struct Evaluated {
    Interpreter<Real> evaluator;
    std::vector<Real> values;

    Evaluated(const std::shared_ptr<const Interpretation>& shared, const Real& eps, const Real& end,
              const GivenArguments& given)
        : Evaluated(shared, eps, end, program_arguments<Real>(*shared->program, eps, given)) {}
    Evaluated(const std::shared_ptr<const Interpretation>& shared, const Real& eps, const Real& end,
              ProgramArguments<Real> arguments)
        : evaluator(shared, eps, std::move(arguments.parameters), std::move(arguments.start), end) {}
    bool answers(double t) {
        const Status status = evaluator.call(static_cast<Real>(t), values);
        return status == Status::ok || status == Status::low_precision;
    }
};

} // namespace

ErrorEstimator::ErrorEstimator(const Scene& scene, const Solution& solution, const Derive& derive,
                               std::vector<std::string> given)
    : formula_(interpretation(solution, scene)), order_(solution.order), truncation_(solution.truncation),
      given_(std::move(given)) {
    const Scene fixed = with_fix_put_in(scene);
    Indices open(scene.outputs.size());
    std::iota(open.begin(), open.end(), std::size_t(0));
    for (const std::string& name : scene.outputs) outputs_.push_back({name, 0, ""});
    const int last = order_ + most_weights * scene.system->eps_root;
    for (int order = order_ + 1; order <= last && !open.empty(); ++order) {
        try {
            const Solution richer = derive(fixed.system, order, next_truncation(scene, solution, order));
            auto [unmoved, moved] = unmoved_and_moved(scene, solution, richer, open);
            if (!moved.empty()) compare_with(richer, fixed, moved);
            open = std::move(unmoved);
        } catch (const Error& error) {
            if (order == order_ + 1) throw;
            for (const std::size_t k : open)
                outputs_[k].reason =
                    "what comes after the next weight, which vanishes identically, cannot be "
                    "derived: " +
                    told(error);
            return;
        }
    }
    for (const std::size_t k : open) outputs_[k].reason = "the next two weights vanish identically";
}

void ErrorEstimator::compare_with(const Solution& richer, const Scene& fixed, const Indices& moved) {
    Scene scene = fixed;
    scene.outputs.clear();
    for (const std::size_t k : moved) {
        scene.outputs.push_back(outputs_[k].name);
        outputs_[k].next_order = richer.order;
    }
    const auto of_order = [&](int order) {
        return solve(richer.normalization, options_of(scene, order, richer.truncation));
    };
    Further further{moved, interpretation(of_order(order_), scene), nullptr, richer.order, richer.truncation};
    scene.oscillating = true;
    further.whole = interpretation(of_order(richer.order), scene);
    require_values(scene, {further.flow->program, further.whole->program}, given_);
    further_.push_back(std::move(further));
}

std::shared_ptr<const Interpretation> ErrorEstimator::formula(int order, int truncation) const {
    if (order == order_ && truncation == truncation_) return formula_;
    for (const Further& further : further_)
        if (order == further.order && truncation == further.truncation &&
            further.outputs.size() == outputs_.size())
            return further.whole;
    return nullptr;
}

template <class Real>
ErrorParts ErrorEstimator::parts(Real eps, Real slow_time_end, const std::vector<double>& times,
                                 const GivenArguments& arguments) const {
    const double none = std::numeric_limits<double>::quiet_NaN();
    ErrorParts result;
    result.map = result.flow =
        std::vector<std::vector<double>>(outputs_.size(), std::vector<double>(times.size(), 0.0));
    Evaluated<Real> formula(formula_, eps, slow_time_end, arguments);
    for (const Further& further : further_) {
        Evaluated<Real> flow(further.flow, eps, slow_time_end, arguments),
            whole(further.whole, eps, slow_time_end, arguments);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const bool known = formula.answers(times[i]) && flow.answers(times[i]) && whole.answers(times[i]);
            for (std::size_t j = 0; j < further.outputs.size(); ++j) {
                const std::size_t k = further.outputs[j];
                result.flow[k][i] = known ? static_cast<double>(flow.values[j] - formula.values[k]) : none;
                result.map[k][i] = known ? static_cast<double>(whole.values[j] - flow.values[j]) : none;
            }
        }
    }
    return result;
}

template ErrorParts ErrorEstimator::parts(double, double, const std::vector<double>&,
                                          const GivenArguments&) const;
template ErrorParts ErrorEstimator::parts(long double, long double, const std::vector<double>&,
                                          const GivenArguments&) const;
template ErrorParts ErrorEstimator::parts(Float128, Float128, const std::vector<double>&,
                                          const GivenArguments&) const;

} // namespace resonform
