// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/stability.hpp"

#include "verify/sweep/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace resonform {

SweepStability::SweepStability(std::shared_ptr<const Program> program, const Scene& scene,
                               const Solution& solution, const SweepGrid& grid,
                               std::shared_ptr<const EvaluatorLibrary> library)
    : program_(std::move(program)), formula_(std::make_shared<const Interpretation>(program_)), grid_(grid),
      library_(std::move(library)),
      reference_(std::make_shared<const StabilityReference>(*program_, solution, scene)),
      place_(places_of_axes(grid, *program_, scene)) {}

Status SweepStability::compute(std::uint64_t i, double* numbers) const {
    const GivenArguments given = arguments_at(grid_, i, *program_, place_);
    const double eps = given.at("eps");
    const NodeNumbers* known = &formula_->numbers;
    auto [parameters, start] = program_arguments<double>(*program_, eps, given, known);
    const double interval = default_slow_time_end<double>(*program_, eps, parameters, known);
    const double end = interval * (1 + 0x1p-40); // t = end/eps is rounded
    const SweepPoint at{eps, std::move(parameters), std::move(start)};
    numbers[0] = interval / eps;
    double* const ulp = numbers + 1;
    std::vector<double> values(program_->outputs.size());
    std::fill_n(ulp, values.size(), std::numeric_limits<double>::quiet_NaN());

    const Evaluator<double> emitted(library_, eps, at.parameters, at.start, end);
    StabilityReference::From exact(*reference_, at, end);
    Status first = Status::ok;
    for (const double share : shares_of_interval) {
        const double t = share * interval / eps;
        const bool followed = exact.at(t).status != Status::outside_interval;
        Status status = emitted.call(t, values.data());
        if (status == Status::ok && !followed) status = Status::outside_interval;
        if (first == Status::ok) first = status;
        if (status != Status::ok) continue;
        const std::vector<double> here = exact.ulp(t, values);
        for (std::size_t k = 0; k < here.size(); ++k) ulp[k] = std::fmax(ulp[k], here[k]); // the first is NaN
    }
    return first;
}

void SweepStability::operator()(std::uint64_t first, std::uint64_t count, double* numbers,
                                unsigned char* status) const {
    const std::size_t columns = 1 + program_->outputs.size();
    for (std::uint64_t i = 0; i < count; ++i)
        status[i] = static_cast<unsigned char>(compute(first + i, numbers + i * columns));
}

} // namespace resonform
