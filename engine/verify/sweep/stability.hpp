// SPDX-License-Identifier: GPL-3.0-or-later
// How many digits the emitted code of a scene has, over a grid: of each output
//
//   max over t of |emitted in double - exact| / ulp(scale of the output at t),    t = 0, 1e-9 T ... T,
//
// at the times, with the exact solution in 50 digits and the scales of verify/stability/stability.hpp, T the
// end of the scene's interval.
#pragma once

#include "verify/evaluate/evaluator.hpp"
#include "verify/stability/reference.hpp"
#include "verify/sweep/grid.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace resonform {

class SweepStability {
public:
    // library: of the program, in double. Errors: those of places_of_axes.
    SweepStability(std::shared_ptr<const Program> program, const Scene& scene, const Solution& solution,
                   const SweepGrid& grid, std::shared_ptr<const EvaluatorLibrary> library);

    // ComputePoints: one row; columns are T and the outputs. The status is the first of the times that is
    // not ok, outside_interval also where a slow flow is not followed in 50 digits; such times do not count,
    // and if none does, there is NaN. Infinite: a number where the exact solution has none.
    void operator()(std::uint64_t first, std::uint64_t count, double* numbers, unsigned char* status) const;

private:
    // One point.
    [[nodiscard]] Status compute(std::uint64_t i, double* numbers) const;

    std::shared_ptr<const Program> program_;
    std::shared_ptr<const Interpretation> formula_; // its numbers
    const SweepGrid& grid_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    std::shared_ptr<const StabilityReference> reference_;
    std::vector<std::size_t> place_; // of each axis among the arguments
};

} // namespace resonform
