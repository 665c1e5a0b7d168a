// SPDX-License-Identifier: GPL-3.0-or-later
// The formula of a scene against direct integration, over a grid: of each output
//
//   error = max |emitted - direct|(t), 0 <= t <= T,   T the end of the judged interval, in 6 digits,
//   order = q of error = O(eps^q), from the point's eps, eps/2, eps/4, eps/8,
//
// by the judge of verify (verify/judging): each point is a scene of its own with the point's arguments under
// [fix] and [start]. Down the ladder parameters stay, and so do constants of the solution; start values of
// fast variables shrink by their weights.
#pragma once

#include "model/exact/first_order_system.hpp"
#include "runtime/status.hpp"
#include "solve/solution.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/sweep/arguments.hpp"
#include "verify/sweep/grid.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace resonform {

// What the errors of a scene depend on beside its emitted code, as text: the system file, start values,
// interval, [fix] and functions. No expression is in it: GiNaC writes them in another order in every run.
std::string equations_text(const Program& program, const Scene& scene);

class SweepErrors {
public:
    // Scene and solution must outlive it. Errors: those of places_of_axes and Tape::rates; bad_input, a
    // parameter of the equations without a value.
    SweepErrors(std::shared_ptr<const Program> program, const Scene& scene, const Solution& solution,
                std::shared_ptr<const FirstOrderSystem> system, const SweepGrid& grid);

    // ComputePoints: rows are error and order; columns are T and the outputs. NaN where there is none, and
    // then the status is that of the formula at t = 0, or the first that it answers later; outside_domain,
    // where the motion leaves the declared domain or cannot be integrated to the end; outside_interval, where
    // that is too long to be integrated. The order is NaN also where no limit is seen; the error is 0, where
    // it is not seen above the rounding.
    void operator()(std::uint64_t first, std::uint64_t count, double* numbers, unsigned char* status) const;

private:
    // One point: both rows.
    [[nodiscard]] Status compute(std::uint64_t i, double* numbers) const;
    [[nodiscard]] Status status_at_start(const GivenArguments& given, double& end) const;
    [[nodiscard]] Scene scene_at(const GivenArguments& given) const;

    std::shared_ptr<const Program> program_;
    std::shared_ptr<const Interpretation> formula_;
    const Scene& scene_;
    const Solution& solution_;
    std::shared_ptr<const FirstOrderSystem> system_;
    const SweepGrid& grid_;
    std::vector<std::size_t> place_;      // of each axis among the arguments
    std::shared_ptr<std::mutex> algebra_; // GiNaC and CLN count their references without locks
};

} // namespace resonform
