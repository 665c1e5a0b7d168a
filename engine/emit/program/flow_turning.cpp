// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_turning.hpp"

#include "emit/display/identifier.hpp"
#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

std::string numbered(const char* name, std::size_t k, std::size_t count) {
    return count == 1 ? name : fmt::format("{}_{}", name, k + 1);
}

} // namespace

FlowValues FlowTurning::turned(const FlowValues& within_frame) {
    add_phases();
    FlowValues result;
    result.slow = within_frame.slow;
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        result.modes.push_back(turned(within_frame.modes[k], flow_.modes[k], field_.modes[k].variable));
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        result.angles.push_back(turned(within_frame.angles[k], flow_.angles[k], field_.angles[k].variable));
    return result;
}

// One cosine and one sine for every frequency, one exponential for every decay.
void FlowTurning::add_phases() {
    Graph& graph = program_.graph;
    for (std::size_t p = 0; p < flow_.phases.size(); ++p) {
        ProgramPhase turning = phase(numbered("theta", p, flow_.phases.size()), flow_.phases[p]);
        turning.cosine = graph.symbol("cos " + turning.name);
        turning.sine = graph.symbol("sin " + turning.name);
        program_.phases.push_back(std::move(turning));
    }
    for (std::size_t p = 0; p < flow_.decays.size(); ++p) {
        ProgramPhase decaying = phase(numbered("chi", p, flow_.decays.size()), flow_.decays[p]);
        decaying.exponential = graph.symbol("exp " + decaying.name);
        program_.phases.push_back(std::move(decaying));
    }
    for (const Mode& mode : field_.modes)
        if (mode.is_damped()) keep_decaying(-mode.growth);
    for (std::size_t p = 0; p < flow_.phases.size(); ++p) let_fade(p);
}

void FlowTurning::let_fade(std::size_t phase) {
    for (const FlowMode& angle : flow_.angles)
        if (angle.phase == phase) return;
    std::vector<Graph::Node> with;
    for (const FlowMode& mode : flow_.modes) {
        if (mode.phase != phase) continue;
        if (!mode.decay) return;
        const Graph::Node exponential = program_.phases[flow_.phases.size() + *mode.decay].exponential;
        if (std::find(with.begin(), with.end(), exponential) == with.end()) with.push_back(exponential);
    }
    program_.phases[phase].fades_with = std::move(with);
}

ProgramPhase FlowTurning::phase(const std::string& name, const Polynomial& rate) {
    Graph& graph = program_.graph;
    const Graph::Node over_time = frame_.lowering.polynomial(real_(rate).re);
    program_.names.push_back({name + "_dot", over_time});
    return {name, graph.rational(0), graph.multiply({graph.power(program_.eps, -1), over_time}), -1, -1, -1,
            {}};
}

void FlowTurning::keep_decaying(const Polynomial& damping) {
    const Graph::Node node = frame_.lowering.polynomial(real_(damping).re);
    if (!signs_of(program_.graph, node, surroundings_.positive).is_positive())
        program_.positive.push_back({node, quantity(*field_.ring, damping)});
}

FlowUnit FlowTurning::turned(FlowUnit unit, const FlowMode& mode, std::size_t variable) {
    Graph& graph = program_.graph;
    if (mode.decay) {
        const Graph::Node factor = program_.phases[flow_.phases.size() + *mode.decay].exponential;
        unit = {graph.multiply({unit.u, factor}), graph.multiply({unit.v, factor})};
    }
    if (mode.phase) {
        const Graph::Node c = program_.phases[*mode.phase].cosine, s = program_.phases[*mode.phase].sine;
        unit = {graph.add({graph.multiply({unit.u, c}), graph.negate(graph.multiply({unit.v, s}))}),
                graph.add({graph.multiply({unit.u, s}), graph.multiply({unit.v, c})})};
    }
    const std::string name = identifier(field_.system().variables[variable].name);
    program_.names.push_back({"re_" + name, unit.u});
    if (mode.phase) program_.names.push_back({"im_" + name, unit.v}); // of a real mode it is 0
    return unit;
}

} // namespace resonform
