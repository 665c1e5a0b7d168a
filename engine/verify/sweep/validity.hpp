// SPDX-License-Identifier: GPL-3.0-or-later
// How long the formula of a scene may be believed, over a grid: of each output the largest time up to which
// its estimated error stays below a tolerance,
//
//   max { t <= T : |map + flow|(t') < tolerance for 0 <= t' <= t },    T the end of the scene's interval,
//
// with map and flow as in verify/estimate/error_estimator.hpp. An estimate, not a bound. The error is looked
// at at 400 times (crowded_times), and at 32 more where it first exceeds the tolerance.
#pragma once

#include "runtime/status.hpp"
#include "verify/estimate/error_estimator.hpp"
#include "verify/sweep/grid.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace resonform {

class SweepValidity {
public:
    // The estimator was made with the axes' names as given. Errors: those of places_of_axes.
    SweepValidity(std::shared_ptr<const Program> program, const Scene& scene, const SweepGrid& grid,
                  std::shared_ptr<const ErrorEstimator> estimator, double tolerance);

    // ComputePoints: one row; columns are T and the outputs. 0: the tolerance is exceeded from the start.
    // NaN: the output has no estimate, or the formula no number at t = 0, and the status is that of the
    // formula there.
    void operator()(std::uint64_t first, std::uint64_t count, double* numbers, unsigned char* status) const;

private:
    // One point.
    [[nodiscard]] Status compute(std::uint64_t i, double* numbers) const;

    std::shared_ptr<const Program> program_;
    std::shared_ptr<const Interpretation> formula_;
    const SweepGrid& grid_;
    std::shared_ptr<const ErrorEstimator> estimator_;
    double tolerance_;
    std::vector<std::size_t> place_; // of each axis among the arguments
};

} // namespace resonform
