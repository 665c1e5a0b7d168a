// SPDX-License-Identifier: GPL-3.0-or-later
// The real form of a slow flow as nodes, at given values of its variables.
#pragma once

#include "emit/moment.hpp"
#include "solve/real_form.hpp"

#include <vector>

namespace resonform {

struct FlowUnit { // u + i v
    Graph::Node u = -1, v = -1;
};

// Modes (divided by eps^weight), angles, slow variables and drifts, in the order of the field.
struct FlowValues {
    std::vector<FlowUnit> modes, angles;
    std::vector<Graph::Node> slow, drift;
};

class FlowMoment {
public:
    using Unit = FlowUnit;
    // named: what is under roots gets names for readers.
    FlowMoment(Program& program, const RealForm& real, const Surroundings& surroundings,
               const FlowValues& values, bool named);

    Lowering lowering;
};

// p/eps^power, every term of which has that power at least.
Polynomial over_eps(const RealForm& real, const Polynomial& p, int power);

} // namespace resonform
