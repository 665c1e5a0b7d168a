// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of outputs by the graph as it is written: sum of |terms|.
#pragma once

#include "verify/evaluate/graph_walk.hpp"
#include "verify/evaluate/interpretation.hpp"

#include <vector>

namespace resonform {

// |value| of the symbols at a call; 1 for |cos| and |sin|.
template <class Real>
void set_symbol_bounds(const Program& program, const GraphWalk<Real>& walk, GraphWalk<Real>& bounds) {
    const auto size = [&](Graph::Node n) { bounds.set(n, math::magnitude(walk[n])); };
    for (const Graph::Node n : {program.eps, program.time, program.slow_time}) size(n);
    for (const std::vector<ProgramInput>* inputs : {&program.parameters, &program.start})
        for (const ProgramInput& input : *inputs) size(input.symbol);
    for (const ProgramFlow& variable : program.flow) size(variable.value);
    for (const ProgramTable& table : program.tables) size(table.value);
    for (const ProgramPhase& phase : program.phases)
        for (const Graph::Node n : phase.symbols()) bounds.set(n, phase.decays() ? Real(walk[n]) : Real(1));
}

// Of each output, from the nodes of a call.
template <class Real>
std::vector<Real> term_scales(const Interpretation& shared, const GraphWalk<Real>& walk) {
    const std::vector<Graph::Node> roots = values_of(shared.program->outputs);
    const NodesBehind behind(shared, roots);
    GraphWalk<Real> bounds(shared.program->graph);
    set_symbol_bounds(*shared.program, walk, bounds);
    walk.compute_scale(behind.constant, bounds);
    walk.compute_scale(behind.varying, bounds);
    std::vector<Real> scales;
    for (const Graph::Node root : roots) scales.push_back(bounds[root]);
    return scales;
}

} // namespace resonform
