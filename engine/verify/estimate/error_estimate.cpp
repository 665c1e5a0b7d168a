// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/error_estimate.hpp"

#include "model/files/interval_length.hpp"
#include "verify/estimate/error_estimator.hpp"
#include "verify/estimate/times.hpp"
#include "verify/run/real.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <thread>

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

// At one eps, for all outputs.
class EstimateAt {
public:
    EstimateAt(const ErrorEstimator& estimator, const Scene& scene, const GradedField& field,
               const Rational& eps)
        : estimator_(estimator), rate_(largest_rate(field, scene, eps)), eps_(eps),
          interval_(judged_interval(field, scene, eps)), from_(layer_end(field, scene, eps)) {}

    std::vector<EstimatedRung> estimated() const {
        const std::vector<double> times = crowded_times(interval_, estimate_points, rate_, from_).all;
        Maxima most = maxima(parts<long double>(times));
        std::vector<double> noise = rounding(times);
        for (std::size_t k = 0; k < noise.size(); ++k)
            if (noise[k] > little_noise * most.error[k]) {
                most =
                    maxima(parts<Float128>(crowded_times(interval_, slow_estimate_points, rate_, from_).all));
                for (double& n : noise)
                    n *= RealTraits<Float128>::roundoff() / RealTraits<long double>::roundoff();
                break;
            }
        std::vector<EstimatedRung> rungs;
        for (std::size_t k = 0; k < noise.size(); ++k)
            rungs.push_back({eps_, most.map[k], most.flow[k], most.error[k], noise[k]});
        return rungs;
    }

private:
    template <class Real> [[nodiscard]] ErrorParts parts(const std::vector<double>& times) const {
        const Real eps = from_rational<Real>(eps_);
        return estimator_.parts<Real>(eps, eps * Real(interval_) * Real(1 + 0x1p-40), times);
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
};

} // namespace

ErrorEstimates error_estimates(const Scene& scene, const Solution& solution, const std::vector<Rational>& eps,
                               const Derive& derive) {
    const ErrorEstimator estimator(scene, solution, derive);
    const GradedField& field = *solution.normalization->normal_form.field;
    std::vector<EstimateAt> rungs;
    for (const Rational& e : eps) rungs.emplace_back(estimator, scene, field, e);
    std::vector<std::vector<EstimatedRung>> found(rungs.size());
    const std::size_t threads = std::clamp(std::thread::hardware_concurrency(), 1U, 8U);
    std::vector<std::future<void>> work;
    for (std::size_t j = 0; j < threads; ++j)
        work.push_back(std::async(std::launch::async, [&, j] {
            for (std::size_t i = j; i < rungs.size(); i += threads) found[i] = rungs[i].estimated();
        }));
    for (auto& w : work) w.get();
    ErrorEstimates estimates;
    for (std::size_t k = 0; k < estimator.outputs().size(); ++k) {
        const ErrorEstimator::Output& output = estimator.outputs()[k];
        ErrorEstimate& estimate = estimates[output.name];
        estimate.next_order = output.next_order;
        estimate.reason = output.reason;
        for (const auto& rung : found) estimate.ladder.push_back(rung[k]);
    }
    return estimates;
}

} // namespace resonform
