// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/comparison/equal_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

constexpr int loosest = 1, tightest = 13; // decades
constexpr double near_enough = 0.9;       // of the ratio
constexpr double resolved = 1.02;         // of two tolerances
constexpr int most_steps = 12;
constexpr double aim = 0.95; // of the ratio, so that a step ends on the side that is good enough

// Of a ratio, without the ends of the line of numbers.
double height(double ratio) { return std::log(std::clamp(ratio / aim, 1e-100, 1e100)); }

// Between a tolerance that is good enough and a looser one that is not.
Tuned between(Tuned good, Tuned bad, const std::function<double(double)>& ratio_at) {
    double low = height(good.ratio), high = height(bad.ratio);
    int last = 0; // which end moved
    for (int step = 0; step < most_steps; ++step) {
        if (good.ratio >= near_enough || bad.tolerance < resolved * good.tolerance) break;
        const double width = std::log(bad.tolerance / good.tolerance);
        const double share = std::isfinite(bad.ratio) && low < 0 ? low / (low - high) : 0.5;
        const double tolerance = good.tolerance * std::exp(width * std::clamp(share, 0.05, 0.95));
        const Tuned found{tolerance, ratio_at(tolerance)};
        if (found.ratio <= 1) {
            good = found;
            low = height(found.ratio);
            if (last > 0) high /= 2; // the end that stays a second time draws less
            last = 1;
        } else {
            bad = found;
            high = height(found.ratio);
            if (last < 0) low /= 2;
            last = -1;
        }
    }
    return good;
}

} // namespace

double error_ratio(const std::vector<double>& errors, const std::vector<double>& accuracy) {
    double worst = 0;
    for (std::size_t k = 0; k < errors.size(); ++k) {
        if (errors[k] <= 0) continue;
        if (!(accuracy[k] > 0 && std::isfinite(errors[k]))) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, errors[k] / accuracy[k]);
    }
    return worst;
}

std::optional<Tuned> loosest_tolerance(const std::function<double(double)>& ratio_at) {
    std::optional<Tuned> before;
    for (int digits = loosest; digits <= tightest; ++digits) {
        const double tolerance = std::pow(10.0, -digits);
        const Tuned found{tolerance, ratio_at(tolerance)};
        if (found.ratio <= 1) return before ? between(found, *before, ratio_at) : found;
        before = found;
    }
    return std::nullopt;
}

} // namespace resonform
