// SPDX-License-Identifier: GPL-3.0-or-later
// The phases and exponents of a slow flow as nodes, and its variables with them:
//
//   x_j + i y_j = (u_j + i v_j) e^{chi_j + i theta_j}
#pragma once

#include "emit/program/flow_moment.hpp"
#include "solve/solution.hpp"

#include <cstddef>
#include <string>

namespace resonform {

class FlowTurning {
public:
    // frame: at the values that `turned` gets. Preconditions: solution.flow; the program has no phases yet.
    FlowTurning(Program& program, FlowMoment& frame, const Solution& solution, const RealForm& real,
                const Surroundings& surroundings)
        : program_(program), frame_(frame), solution_(solution), flow_(*solution.flow),
          field_(*solution.normalization->normal_form.field), real_(real), surroundings_(surroundings) {}

    // Adds the phases, then the exponents, with the condition that their leading rates keep their signs.
    // start: the modes at t = 0.
    FlowValues turned(const FlowValues& within_frame, const FlowValues& start);

private:
    void add_phases(const FlowValues& start);
    [[nodiscard]] ProgramPhase phase(const std::string& name, const Polynomial& rate);
    void name_owners();
    void let_fade(std::size_t phase);
    void keep_sign(std::size_t mode, const FlowValues& start);
    void add_growth(std::size_t mode, const FlowValues& start);
    FlowUnit turned(FlowUnit unit, const FlowMode& mode, std::size_t variable);

    Program& program_;
    FlowMoment& frame_;
    const Solution& solution_;
    const SlowFlow& flow_;
    const GradedField& field_;
    const RealForm& real_;
    const Surroundings& surroundings_;
};

} // namespace resonform
