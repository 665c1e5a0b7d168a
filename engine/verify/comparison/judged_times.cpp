// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/comparison/judged_times.hpp"

#include "verify/estimate/times.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr std::size_t most_judged = 2001;

} // namespace

std::shared_ptr<const JudgedTimes> evenly_judged(double interval, std::size_t points) {
    auto times = std::make_shared<JudgedTimes>();
    if (points == 1) {
        times->all = {interval};
        times->judged = {0};
        return times;
    }
    times->all = even_times(interval, points);
    const std::size_t judged = std::min(points, most_judged);
    for (std::size_t j = 0; j < judged; ++j) // rounded to the next index
        times->judged.push_back((2 * j * (points - 1) + judged - 1) / (2 * (judged - 1)));
    return times;
}

void ErrorsAgainstReference::expect(const JudgedTimes& times) {
    for (const std::size_t i : times.judged) times_.push_back(times.all[i]);
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
    reference_.reset();
}

std::vector<double> ErrorsAgainstReference::largest(const JudgedTimes& times, const OutputValues& values) {
    if (!reference_) reference_ = trial_.reference(at_, times_);
    std::vector<double> largest;
    for (std::size_t k = 0; k < values.size(); ++k) {
        double worst = 0;
        for (const std::size_t i : times.judged) {
            if (times.all[i] < from_) continue;
            const auto at = std::lower_bound(times_.begin(), times_.end(), times.all[i]) - times_.begin();
            const DoubleDouble error =
                DoubleDouble(values[k][i]) - reference_->values[k][static_cast<std::size_t>(at)];
            const double size = std::abs(to_double_value(error));
            worst = size <= worst ? worst : size; // NaN counts as worst
            if (std::isnan(worst)) break;
        }
        largest.push_back(worst);
    }
    return largest;
}

} // namespace resonform
