// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/error_estimate.hpp"

#include "model/files/interval_length.hpp"
#include "model/files/settings.hpp"
#include "verify/estimate/best_order.hpp"
#include "verify/estimate/error_estimator.hpp"
#include "verify/estimate/times.hpp"
#include "verify/run/parallel.hpp"
#include "verify/run/real.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace resonform {

namespace {

// A maximum wants some points in each part of a period, not each period: the errors of an oscillation at
// points of any phase are as large as it is.
constexpr std::size_t estimate_points = 800, slow_estimate_points = 120;
constexpr std::size_t rounding_samples = 40;
constexpr double estimate_margin = 4; // the worst of all points may be this much above the worst sample
constexpr double little_noise = 0.02; // of an estimate

struct Maxima {
    std::vector<double> map, flow, error;
};

template <class Value> double greatest(std::size_t count, const Value& value) {
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double v = std::abs(value(i));
        if (!(v <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::infinity();
        most = std::max(most, v);
    }
    return most;
}

Maxima maxima(const ErrorParts& parts) {
    Maxima most;
    for (std::size_t k = 0; k < parts.map.size(); ++k) {
        const std::vector<double>&map = parts.map[k], &flow = parts.flow[k];
        most.map.push_back(greatest(map.size(), [&](std::size_t i) { return map[i]; }));
        most.flow.push_back(greatest(flow.size(), [&](std::size_t i) { return flow[i]; }));
        most.error.push_back(greatest(map.size(), [&](std::size_t i) { return map[i] + flow[i]; }));
    }
    return most;
}

struct EstimatesAt { // one eps, of each output
    std::vector<EstimatedRung> rungs;
    std::vector<BestOrder> best; // empty: not asked for
};

// At one eps, for all outputs.
class EstimateAt {
public:
    EstimateAt(const ErrorEstimator& estimator, const Scene& scene, const GradedField& field,
               const Rational& eps)
        : estimator_(estimator), rate_(largest_rate(field, scene, eps)), eps_(eps),
          interval_(judged_interval(field, scene, eps)), from_(layer_end(field, scene, eps)),
          eps_root_(field.system().eps_root) {}

    EstimatesAt estimated(const std::optional<OrderSeries>& orders) const {
        const std::vector<double> times = crowded_times(interval_, estimate_points, rate_, from_).all;
        Maxima most = maxima(parts<long double>(times));
        std::vector<double> noise = rounding(times);
        EstimatesAt estimates;
        if (orders) estimates.best = best(*orders, noise);
        for (std::size_t k = 0; k < noise.size(); ++k)
            if (noise[k] > little_noise * most.error[k]) {
                most = maxima(parts<Float128>(few_times()));
                for (double& n : noise)
                    n *= RealTraits<Float128>::roundoff() / RealTraits<long double>::roundoff();
                break;
            }
        for (std::size_t k = 0; k < noise.size(); ++k)
            estimates.rungs.push_back({eps_, most.map[k], most.flow[k], most.error[k], noise[k]});
        return estimates;
    }

private:
    template <class Real> [[nodiscard]] ErrorParts parts(const std::vector<double>& times) const {
        return estimator_.parts<Real>(from_rational<Real>(eps_), slow_time_end<Real>(), times);
    }

    template <class Real> [[nodiscard]] Real slow_time_end() const {
        return from_rational<Real>(eps_) * Real(interval_) * Real(1 + 0x1p-40);
    }

    [[nodiscard]] std::vector<double> few_times() const {
        return crowded_times(interval_, slow_estimate_points, rate_, from_).all;
    }

    [[nodiscard]] std::vector<BestOrder> best(const OrderSeries& orders,
                                              const std::vector<double>& noise) const {
        std::vector<BestOrder> found;
        for (const std::vector<double>& terms :
             orders.terms(from_rational<long double>(eps_), slow_time_end<long double>(), few_times(), noise))
            found.push_back(best_of(eps_, terms, eps_root_));
        return found;
    }

    // Of long double: what double rounds, so much smaller as its last place is.
    [[nodiscard]] std::vector<double> rounding(const std::vector<double>& times) const {
        std::vector<double> some;
        for (std::size_t i = 0; i < times.size(); i += 1 + times.size() / rounding_samples)
            some.push_back(times[i]);
        const ErrorParts rough = parts<double>(some), fine = parts<long double>(some);
        std::vector<double> noise;
        const double share = estimate_margin * static_cast<double>(RealTraits<long double>::roundoff() /
                                                                   RealTraits<double>::roundoff());
        for (std::size_t k = 0; k < rough.map.size(); ++k) {
            double most = 0;
            for (std::size_t i = 0; i < some.size(); ++i) {
                const double off = rough.map[k][i] + rough.flow[k][i] - fine.map[k][i] - fine.flow[k][i];
                if (std::isfinite(off)) most = std::max(most, std::abs(off));
            }
            noise.push_back(share * most);
        }
        return noise;
    }

    const ErrorEstimator& estimator_;
    double rate_;
    Rational eps_;
    double interval_, from_;
    int eps_root_;
};

} // namespace

ErrorEstimates error_estimates(const Scene& scene, const Solution& solution, const std::vector<Rational>& eps,
                               const Derive& derive) {
    std::optional<Solution> next;
    const ErrorEstimator estimator(
        scene, solution, [&](const std::shared_ptr<const System>& system, int order, int truncation) {
            Solution richer = derive(system, order, truncation);
            if (!next) next = richer; // a second one is of the weight behind it
            return richer;
        });
    std::optional<OrderSeries> orders;
    if (scene.oscillating && next) orders.emplace(with_fix_put_in(scene), *next, estimator);
    const GradedField& field = *solution.normalization->normal_form.field;
    std::vector<EstimateAt> rungs;
    for (const Rational& e : eps) rungs.emplace_back(estimator, scene, field, e);
    std::vector<EstimatesAt> found(rungs.size());
    in_parallel(rungs.size(), [&](std::size_t i) { found[i] = rungs[i].estimated(orders); });
    ErrorEstimates estimates;
    for (std::size_t k = 0; k < estimator.outputs().size(); ++k) {
        const ErrorEstimator::Output& output = estimator.outputs()[k];
        ErrorEstimate& estimate = estimates[output.name];
        estimate.next_order = output.next_order;
        estimate.reason = output.reason;
        for (const EstimatesAt& at : found) {
            estimate.ladder.push_back(at.rungs[k]);
            if (orders && output.next_order > 0 && at.best[k].order > 0) estimate.best.push_back(at.best[k]);
        }
    }
    return estimates;
}

} // namespace resonform
