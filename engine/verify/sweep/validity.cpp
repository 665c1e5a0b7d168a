// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/validity.hpp"

#include "verify/estimate/times.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/sweep/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace resonform {

namespace {

constexpr std::size_t coarse_times = 400, fine_times = 33;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// How many times from the first on have an error below the tolerance.
std::size_t believed(const ErrorParts& parts, std::size_t output, double tolerance) {
    const std::vector<double>&map = parts.map[output], &flow = parts.flow[output];
    std::size_t i = 0;
    while (i < map.size() && std::abs(map[i] + flow[i]) < tolerance) ++i; // NaN: beyond
    return i;
}

} // namespace

SweepValidity::SweepValidity(std::shared_ptr<const Program> program, const Scene& scene,
                             const SweepGrid& grid, std::shared_ptr<const ErrorEstimator> estimator,
                             double tolerance)
    : program_(std::move(program)), formula_(std::make_shared<const Interpretation>(program_)), grid_(grid),
      estimator_(std::move(estimator)), tolerance_(tolerance),
      place_(places_of_axes(grid, *program_, scene)) {}

Status SweepValidity::compute(std::uint64_t i, double* numbers) const {
    const GivenArguments given = arguments_at(grid_, i, *program_, place_);
    const long double eps = given.at("eps");
    const NodeNumbers* known = &formula_->numbers;
    auto arguments = program_arguments<long double>(*program_, eps, given, known);
    const auto interval = default_slow_time_end<long double>(*program_, eps, arguments.parameters, known);
    const long double slow_end = interval * (1 + 4 * std::numeric_limits<double>::epsilon());
    const auto end = static_cast<double>(interval / eps);
    numbers[0] = end;
    std::fill_n(numbers + 1, estimator_->outputs().size(), not_a_number);
    const Interpreter<long double> formula(formula_, eps, std::move(arguments.parameters),
                                           std::move(arguments.start), slow_end);
    std::vector<long double> values;
    const Status status = formula.call(0, values);
    if (status != Status::ok && status != Status::low_precision) return status;

    const std::vector<double> times = crowded_times(end, coarse_times, 0).all;
    const auto parts_at = [&](const std::vector<double>& t) {
        return estimator_->parts<long double>(eps, slow_end, t, given);
    };
    const ErrorParts parts = parts_at(times);
    for (std::size_t k = 0; k < estimator_->outputs().size(); ++k) {
        if (estimator_->outputs()[k].next_order == 0) continue;
        const std::size_t good = believed(parts, k, tolerance_);
        double& number = numbers[1 + k];
        number = good == 0 ? 0 : times[good - 1];
        if (good == 0 || good == times.size()) continue;
        const std::vector<double> between = even_times(times[good], fine_times, times[good - 1]);
        number = between[std::max<std::size_t>(1, believed(parts_at(between), k, tolerance_)) - 1];
    }
    return status;
}

void SweepValidity::operator()(std::uint64_t first, std::uint64_t count, double* numbers,
                               unsigned char* status) const {
    const std::size_t columns = 1 + estimator_->outputs().size();
    for (std::uint64_t i = 0; i < count; ++i)
        status[i] = static_cast<unsigned char>(compute(first + i, numbers + i * columns));
}

} // namespace resonform
