// SPDX-License-Identifier: GPL-3.0-or-later
// Where the solution of a scene starts: its constants, from start values as the scene gives them, through the
// inverse map at its full weight where they are physical ones (solve/initial_values.hpp).
#pragma once

#include "model/system/scene_file.hpp"
#include "runtime/status.hpp"
#include "solve/solution.hpp"
#include "verify/symbolic/ring.hpp"

#include <array>
#include <memory>
#include <vector>

namespace resonform {

// A divisor that moves: |D|^2 -+ both parts of its rate must be > 0 (emit/program/layers.hpp).
struct SymbolicLayer {
    SymbolicSum divisor, rate;

    [[nodiscard]] std::array<Wide, 4> margins(const SymbolicValues<Wide>& values) const {
        const WideComplex d = value_of(divisor, values), change = value_of(rate, values);
        const Wide square = d.re * d.re + d.im * d.im;
        return {square + change.re, square - change.re, square + change.im, square - change.im};
    }
};

struct SymbolicStart {
    Status status = Status::ok;
    std::vector<Wide> slow;         // in the order of the solution's slow variables
    std::vector<WideComplex> modes; // of a slow flow: z_j/eps^weight
    // By how much the terms of the sum from which a mode starts, in their norm, are larger than it: 1 for an
    // oscillator, but those of two real modes of one variable may cancel.
    std::vector<Wide> mode_spreads;
    std::vector<Wide> angles; // of a slow flow; of a closed solution with an oscillator: theta_0
    Wide amplitude = 0;       // of that oscillator
    struct Sum {
        Wide value = 0, scale = 0;
    };
    std::vector<Sum> drifts; // constants of the drifts
};

class SymbolicStartFinder {
public:
    virtual ~SymbolicStartFinder() = default;
    [[nodiscard]] virtual SymbolicStart at(const SymbolicInputs& inputs) const = 0;
};

// ring: of the solution; for a slow flow, of the normal form.
std::unique_ptr<SymbolicStartFinder> closed_start(const Solution& solution, const Scene& scene,
                                                  const SymbolicRing& ring);
std::unique_ptr<SymbolicStartFinder> flow_start_finder(const Solution& solution, const Scene& scene,
                                                       const SymbolicRing& ring);

} // namespace resonform
