// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/deviation.hpp"

#include "verify/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace resonform {

namespace {

constexpr std::size_t long_double_samples = 64; // points at which long double is compared with Float128
constexpr double clear_of_floor = 200;
constexpr double sample_margin = 4; // the worst of all points may be this much above the worst sample

using Errors = std::vector<std::vector<double>>;

// error[k][i] for the points first ... last - 1.
template <class Real>
void fill(const Trial& trial, const Evaluator<Real>& evaluator, const Reference& reference, Errors& error,
          std::size_t first, std::size_t last) {
    std::vector<Real> values(reference.values.size());
    for (std::size_t i = first; i < last; ++i) {
        const bool ok = trial.answers(evaluator.call(static_cast<Real>(reference.times[i]), values.data()));
        for (std::size_t k = 0; k < values.size(); ++k) {
            const Float128 direct = convert<Float128>(reference.values[k][i]);
            error[k][i] = ok ? static_cast<double>(Float128(values[k]) - direct)
                             : std::numeric_limits<double>::infinity();
        }
    }
}

// Tells the status at the first time without numbers, if there is one.
template <class Real>
void tell_refusal(const Trial& trial, const Evaluator<Real>& evaluator, const Reference& reference,
                  Deviation& result) {
    result.refused = Status::ok;
    result.refusal.clear();
    const std::vector<double>& error = result.error.front();
    const auto refused = std::find_if(error.begin(), error.end(), [](double e) { return !std::isfinite(e); });
    if (refused == error.end()) return;
    const double t = reference.times[static_cast<std::size_t>(refused - error.begin())];
    std::vector<Real> values(reference.values.size());
    const Status status = evaluator.call(static_cast<Real>(t), values.data());
    if (trial.answers(status)) return;
    result.refused = status;
    result.refusal = fmt::format("{} at t = {:.3g}", told(status, evaluator.why(status)), t);
}

// Sets the errors and the refusal.
template <class Real>
void deviate(const Trial& trial, const TrialPoint& at, const Reference& reference, Deviation& result) {
    const std::size_t points = reference.times.size();
    const std::size_t parts = side_by_side();
    const Evaluator<Real> evaluator = trial.evaluator<Real>(at);
    result.error.assign(reference.values.size(), std::vector<double>(points));
    in_parallel(parts, [&](std::size_t j) {
        fill(trial, evaluator, reference, result.error, points * j / parts, points * (j + 1) / parts);
    });
    tell_refusal(trial, evaluator, reference, result);
}

double largest_of(const std::vector<double>& error) {
    double most = 0;
    for (const double e : error) {
        if (!(std::abs(e) <= std::numeric_limits<double>::max()))
            return std::numeric_limits<double>::infinity();
        most = std::max(most, std::abs(e));
    }
    return most;
}

// The rounding of long double: its distance from Float128 at some points.
std::vector<double> rounding_of_long_double(const Trial& trial, const TrialPoint& at,
                                            const Reference& reference) {
    const std::size_t points = reference.times.size(),
                      step = std::max<std::size_t>(1, points / long_double_samples);
    const Evaluator<long double> coarse = trial.evaluator<long double>(at);
    const Evaluator<Float128> fine = trial.evaluator<Float128>(at);
    std::vector<long double> a(reference.values.size());
    std::vector<Float128> b(reference.values.size());
    std::vector<double> floor(reference.values.size(), 0.0);
    for (std::size_t i = 0; i < points; i += step) {
        const double t = reference.times[i];
        if (!trial.answers(coarse.call(t, a.data())) || !trial.answers(fine.call(t, b.data()))) continue;
        for (std::size_t k = 0; k < floor.size(); ++k)
            floor[k] =
                std::max(floor[k], sample_margin * std::abs(static_cast<double>(Float128(a[k]) - b[k])));
    }
    return floor;
}

} // namespace

Deviation deviation(const Trial& trial, const TrialPoint& at, const Reference& reference,
                    std::vector<double> rounding) {
    Deviation result;
    if (rounding.empty()) rounding = rounding_of_long_double(trial, at, reference);
    result.rounding = std::move(rounding);
    result.floor = result.rounding;
    result.digits = RealTraits<long double>::digits;
    deviate<long double>(trial, at, reference, result);
    bool clear = true;
    for (std::size_t k = 0; k < result.floor.size(); ++k)
        clear = clear && largest_of(result.error[k]) >= clear_of_floor * result.floor[k];
    if (clear) return result;
    deviate<Float128>(trial, at, reference, result);
    result.digits = RealTraits<DoubleDouble>::digits; // the reference has fewer than Float128
    for (double& f : result.floor)
        f *= RealTraits<Float128>::roundoff() / RealTraits<long double>::roundoff();
    return result;
}

double largest(const std::vector<double>& error, const std::vector<std::size_t>& even) {
    double most = largest_of(error);
    if (std::isinf(most)) return most;
    for (std::size_t i = 1; i + 1 < even.size(); ++i) {
        const double value = error[even[i]], here = std::abs(value), sign = value < 0 ? -1 : 1;
        const double before = sign * error[even[i - 1]], after = sign * error[even[i + 1]];
        const double bend = before - 2 * here + after;
        if (here >= before && here >= after && bend < 0)
            most = std::max(most, here - (after - before) * (after - before) / (8 * bend));
    }
    return most;
}

double root_mean_square(const std::vector<double>& error, const std::vector<std::size_t>& even) {
    double sum = 0;
    for (std::size_t i = 0; i < even.size(); ++i)
        sum += (i == 0 || i + 1 == even.size() ? 0.5 : 1.0) * error[even[i]] * error[even[i]];
    return std::sqrt(sum / static_cast<double>(even.size() - 1));
}

} // namespace resonform
