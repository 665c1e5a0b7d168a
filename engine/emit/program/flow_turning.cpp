// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_turning.hpp"

#include "emit/display/identifier.hpp"
#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/program/corrections.hpp"
#include "emit/program/passage.hpp"
#include "solve/flow/passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {

namespace {

std::string numbered(const char* name, std::size_t k, std::size_t count) {
    return count == 1 ? name : fmt::format("{}_{}", name, k + 1);
}

} // namespace

FlowValues FlowTurning::turned(const FlowValues& within_frame, const FlowValues& start) {
    add_phases(start);
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        if (const FlowMode& mode = flow_.modes[k]; (mode.grows && !mode.is_left_out) || mode.either)
            add_growth(k, start);
    FlowValues result;
    result.slow = within_frame.slow;
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        result.modes.push_back(turned(within_frame.modes[k], flow_.modes[k], field_.modes[k].variable));
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        result.angles.push_back(turned(within_frame.angles[k], flow_.angles[k], field_.angles[k].variable));
    return result;
}

// One cosine and one sine for every frequency, one exponential for every decay.
void FlowTurning::add_phases(const FlowValues& start) {
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
    name_owners();
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        if (field_.modes[k].is_damped() && !flow_.modes[k].passes) keep_sign(k, start);
    for (std::size_t p = 0; p < flow_.phases.size(); ++p) let_fade(p);
}

// Which modes and angles a phase or an exponent is of, in words.
void FlowTurning::name_owners() {
    const auto add = [&](std::optional<std::size_t> phase, std::size_t first, const std::string& owner) {
        if (!phase) return;
        std::string& of = program_.phases[first + *phase].of;
        of += (of.empty() ? "" : ", ") + owner;
    };
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const Mode& mode = field_.modes[k];
        const std::string owner = mode.name + " of " + field_.system().variables[mode.variable].name;
        add(flow_.modes[k].phase, 0, owner);
        add(flow_.modes[k].decay, flow_.phases.size(), owner);
    }
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        add(flow_.angles[k].phase, 0, field_.angles[k].name);
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
    return {
        name, graph.rational(0), graph.multiply({graph.power(program_.eps, -1), over_time}), -1, -1, -1, {},
        -1};
}

// That which is declared, or that of the start.
void FlowTurning::keep_sign(std::size_t mode, const FlowValues& start) {
    const Polynomial rate = flow_.modes[mode].leading_rate(field_.modes[mode]);
    const Polynomial own = real_(rate).re;
    Graph::Node node = frame_.lowering.polynomial(own);
    if (flow_.modes[mode].either) {
        FlowMoment at_start(program_, real_, surroundings_, start, false);
        node = program_.graph.multiply({at_start.lowering.polynomial(own), node});
    }
    if (!signs_of(program_.graph, node, surroundings_.positive).is_positive())
        program_.positive.push_back({node, quantity(*field_.ring, rate)});
}

// Of z = eps^w a e^chi + ... errors of weight N + 1 grow likewise, and so do the neglected powers of z: with
// r the ratio of one power in the map to the one before, digits are left while both are below a thousandth,
//
//   eps^{N+1} e^chi <= 10^-3 eps^w,   (r e^chi)^N <= 10^-3
//
// The bounds of e^{-chi} that follow, added: g. What may decay, too, has its digits while e^chi <= 1,
// whatever g is: e^chi <= 1 + 1/g. Where Re lambda changes its sign, more is asked.
void FlowTurning::add_growth(std::size_t mode, const FlowValues& start) {
    Graph& graph = program_.graph;
    const FlowMode& own = flow_.modes[mode];
    ProgramPhase& phase = program_.phases[flow_.phases.size() + *own.decay];
    FlowMoment at(program_, real_, surroundings_, start, false);
    const Graph::Node ratio =
        corrections_of(program_, solution_, surroundings_, mode, start.modes,
                       [&](const Polynomial& p) { return at.lowering.polynomial(real_(p).re); });
    const int weight = field_.ring->generator(field_.modes[mode].z).weight, order = solution_.order;
    const Graph::Node allowed = graph.rational(1000);
    const Graph::Node linear = graph.multiply({allowed, graph.power(program_.small, order + 1 - weight)});
    Graph::Node bound =
        graph.add({linear, graph.multiply({ratio, order == 1 ? allowed : graph.root(allowed, order)})});
    if (own.either) bound = graph.multiply({bound, graph.power(graph.add({graph.rational(1), bound}), -1)});
    phase.growth = phase.growth < 0 ? bound : graph.add({phase.growth, bound});
    if (own.passes && moves_slowly(field_, field_.modes[mode].growth))
        for (std::vector<Graph::Node>& either :
             precision_of(program_, solution_, real_, {mode, ratio, phase.exponential}, frame_, at))
            phase.precision.push_back(std::move(either));
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
