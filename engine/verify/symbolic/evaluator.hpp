// SPDX-License-Identifier: GPL-3.0-or-later
// The exact solution of a scene at times t, in 50 digits, with the scale that errors of outputs are measured
// in (docs/theory.md):
//
//   const auto solution = std::make_shared<const SymbolicSolution>(solved, scene);
//   const SymbolicEvaluator at(solution, {eps, {}, {{"psi", 0.3}, ...}, slow_time_end}, reach);
//   at(t).values[k], .scales[k], .phase_parts[k], .status
//
// It answers with the statuses of emitted code, but never with low_precision or overflow.
#pragma once

#include "runtime/flow.hpp"
#include "verify/symbolic/solution.hpp"

#include <memory>
#include <vector>

namespace resonform {

struct SymbolicPoint {
    Status status = Status::ok;
    std::vector<Wide> values, scales; // of each output; empty unless the status is ok
    std::vector<Wide> phase_parts;    // of the scales: sum of |du/dtheta| |theta|
};

class SymbolicEvaluator {
public:
    // Quadratures and flow are computed as far as the slow time `reach`, at most inputs.slow_time_end, and no
    // farther than `most_panels` of their tables lead: outside_interval beyond.
    SymbolicEvaluator(std::shared_ptr<const SymbolicSolution> solution, const SymbolicInputs& inputs,
                      const Wide& reach, std::size_t most_panels = FlowTable<std::vector<Wide>>::most_panels);
    ~SymbolicEvaluator();
    SymbolicEvaluator(SymbolicEvaluator&&) noexcept;

    [[nodiscard]] SymbolicPoint operator()(const Wide& t) const;
    // The exponents chi and the phases theta at t, and the outputs with given phases in their place.
    [[nodiscard]] std::vector<Wide> exponents(const Wide& t) const;
    [[nodiscard]] std::vector<Wide> phases(const Wide& t) const;
    [[nodiscard]] SymbolicPoint with_phases(const Wide& t, const std::vector<Wide>& theta) const;
    // Before `end`, within an eighth of it behind t, a phase is so large that arithmetic of this resolution
    // does not know it to known_radians: there emitted code, which keeps phases in pieces, ends.
    [[nodiscard]] bool loses_phase(const Wide& t, const Wide& end, const Wide& resolution) const;
    // The slow time up to which the solution is known, and whether that is less than was asked for.
    [[nodiscard]] Status construction_status() const;
    // The slow time that the tables cover: beyond, a status may say that there are no numbers, or none found.
    [[nodiscard]] const Wide& tabulated() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace resonform
