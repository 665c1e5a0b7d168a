// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/start_constants.hpp"

#include "emit/program/scene_program.hpp"
#include "emit/program/start_map.hpp"

#include <algorithm>

namespace resonform {

Graph::Node StartConstants::input(const std::string& name, const std::string& meaning,
                                  const std::string& canonical) {
    return add_start_input(program_, scene_, names_, name, meaning, canonical);
}

// A fast variable starts from physical values if the scene gives its value, a drift likewise.
bool StartConstants::is_physical(std::size_t variable) const {
    return scene_.start_of(solution_.system().variables[variable].name) != nullptr;
}

void StartConstants::define_given(Surroundings& surroundings) {
    for (const ModeSolution& mode : solution_.modes) {
        if (is_physical(mode.variable)) continue;
        const std::string& variable = solution_.system().variables[mode.variable].name;
        surroundings.symbols[solution_.ring->generator(mode.amplitude).name] =
            input(mode.amplitude_name, "amplitude of the oscillation", "amplitude." + variable);
        phase_start_ = input(mode.phase_name, "its phase at t = 0", "phase." + variable);
    }
    for (const DriftSolution& drift : solution_.drift) {
        if (is_physical(drift.variable)) continue;
        const std::string& variable = solution_.system().variables[drift.variable].name;
        surroundings.symbols[solution_.ring->generator(drift.constant).name] =
            input(drift.constant_name, "constant of " + variable, "constant." + variable);
    }
}

Graph::Node StartConstants::define(Surroundings& surroundings) {
    define_given(surroundings);
    const auto physical = [&](const auto& part) { return is_physical(part.variable); };
    if (std::any_of(solution_.modes.begin(), solution_.modes.end(), physical) ||
        std::any_of(solution_.drift.begin(), solution_.drift.end(), physical))
        define_derived(initial_values(solution_), surroundings);
    return phase_start_;
}

// At the start quadratures vanish.
MomentPlan StartConstants::plan() const {
    return {program_.graph.rational(0), slow_starts_,
            [this](const Primitive&, Lowering&) { return program_.graph.rational(0); }};
}

// Start values of the states that the scene gives; those of an oscillator given by its constants are
// the solution at t = 0.
void StartConstants::define_physical_values(const InitialValues& values, Moment& start) {
    const FirstOrderSystem& system = *solution_.normalization->normal_form.field->first_order;
    const RingMap map = RingMap::by_name(solution_.ring, values.ring);
    const auto shift_of = [&](const State& state) {
        const GradedField& field = *solution_.normalization->normal_form.field;
        return map((*solution_.from_normal_form)(field.shift(state.variable, state.derivative)));
    };
    for (std::size_t k = 0; k < solution_.state.size(); ++k) {
        const std::string& name = solution_.state[k].name;
        if (!is_physical(system.state(name).variable)) continue;
        physical_[name] = input(name + "_0", name + " at t = 0", name);
        Graph::Node measured = physical_.at(name);
        if (const Polynomial shift = shift_of(system.state(name)); !shift.empty())
            measured =
                program_.graph.add({measured, program_.graph.negate(start.lowering.polynomial(shift))});
        start.lowering.define(values.start[k], measured, false);
    }
    for (std::size_t k = 0; k < solution_.state.size(); ++k) {
        const std::size_t variable = system.state(solution_.state[k].name).variable;
        const bool oscillator =
            std::any_of(solution_.modes.begin(), solution_.modes.end(),
                        [&](const ModeSolution& mode) { return mode.variable == variable; });
        if (!oscillator || is_physical(variable)) continue;
        const Polynomial value = map(solution_.state[k].value.total(solution_.state[k].value.through())) -
                                 shift_of(system.state(solution_.state[k].name));
        start.lowering.define(values.start[k], start.harmonics.value(value), false);
    }
}

void StartConstants::derive_oscillator(const InitialValues& values, Moment& start,
                                       Surroundings& surroundings) {
    Graph& graph = program_.graph;
    const std::string& name = solution_.ring->generator(solution_.modes.front().amplitude).name;
    const Graph::Node re = start.lowering.polynomial(values.w_real);
    const Graph::Node im = start.lowering.polynomial(values.w_imaginary);
    phase_start_ = graph.function(Graph::Op::atan2, {im, re});
    const Graph::Node radius = graph.function(Graph::Op::sqrt_sum_squares, {re, im});
    Graph::Node amplitude =
        graph.multiply({radius, graph.power(start.lowering.polynomial(values.leading_scale), -1)});
    const int substitutions = values.implicit ? solution_.truncation + 1 : 1;
    for (int step = 0; step < substitutions; ++step) {
        start.lowering.define(*values.ring->find(name), amplitude, false);
        amplitude = graph.multiply({radius, graph.power(start.lowering.polynomial(values.scale), -1)});
    }
    start.lowering.define(*values.ring->find(name), amplitude, false);
    surroundings.symbols[name] = amplitude;
    program_.names.push_back({solution_.modes.front().amplitude_name, amplitude});
    program_.names.push_back({solution_.modes.front().phase_name, phase_start_});
}

void StartConstants::define_derived(const InitialValues& values, Surroundings& surroundings) {
    Moment start(program_, solution_, values.ring, surroundings, plan());
    if (!solution_.modes.empty() && phase_start_ >= 0)
        start.harmonics.set_angle(
            *values.ring->find(solution_.ring->generator(solution_.modes.front().phase).name),
            program_.graph.function(Graph::Op::cos, {phase_start_}),
            program_.graph.function(Graph::Op::sin, {phase_start_}));
    define_physical_values(values, start);
    if (!solution_.modes.empty() && phase_start_ < 0) derive_oscillator(values, start, surroundings);
    for (std::size_t k = 0; k < solution_.drift.size(); ++k) {
        if (!is_physical(solution_.drift[k].variable)) continue;
        const Graph::Node constant = start.lowering.polynomial(values.drift[k]);
        surroundings.symbols[solution_.ring->generator(solution_.drift[k].constant).name] = constant;
        program_.names.push_back({solution_.drift[k].constant_name, constant});
    }
}

// (psi_0 - i psi'_0/omega)/eps
FlowUnit StartConstants::old_mode(const RealForm& real, FlowMoment& at) {
    Graph& graph = program_.graph;
    const Mode& mode = solution_.normalization->normal_form.field->modes.front();
    const std::string& name = solution_.system().variables[mode.variable].name;
    const Graph::Node scale = graph.power(program_.eps, -1),
                      period = graph.power(at.lowering.polynomial(real(mode.omega).re), -1);
    const auto measured = [&](const std::string& state, int derivative) {
        const Polynomial shift = solution_.normalization->normal_form.field->shift(mode.variable, derivative);
        return measured_from(graph, physical_.at(state), at.lowering, real, shift);
    };
    return {graph.multiply({scale, measured(name, 0)}),
            graph.negate(graph.multiply({scale, period, measured(name + "'", 1)}))};
}

// The new mode is C E F e^{i theta_0}: F must be close to 1, and the map must lead back to the start.
void StartConstants::require_map(const Surroundings& surroundings) {
    if (solution_.modes.empty()) return;
    Graph& graph = program_.graph;
    const ModeSolution& mode = solution_.modes.front();
    Moment start(program_, solution_, solution_.ring, surroundings, plan());
    const auto lowered = [&](const Polynomial& p) { return start.lowering.polynomial(p); };
    const Graph::Node factor = lowered(mode.factor.total(solution_.truncation));
    require_close_to_one(program_, factor, solution_.system().variables[mode.variable].name);
    const Graph::Node modulus =
        graph.multiply({surroundings.symbols.at(solution_.ring->generator(mode.amplitude).name),
                        lowered(mode.envelope), factor});
    StartPair pair;
    pair.from_constants = !is_physical(mode.variable);
    pair.now.modes = {{graph.multiply({modulus, graph.function(Graph::Op::cos, {phase_start_})}),
                       graph.multiply({modulus, graph.function(Graph::Op::sin, {phase_start_})})}};
    for (const auto& slow : slow_starts_) pair.now.slow.push_back(slow.second);
    const RealForm real(*solution_.normalization->normal_form.field);
    FlowMoment at(program_, real, surroundings, pair.now, false);
    pair.old = pair.now;
    if (!pair.from_constants) pair.old.modes = {old_mode(real, at)};
    for (const DriftSolution& drift : solution_.drift) {
        const bool physical = is_physical(drift.variable);
        const std::string& name = solution_.system().variables[drift.variable].name;
        pair.old.drift.push_back(physical ? physical_.at(name) : -1);
        const Polynomial value = drift.value.total(solution_.truncation);
        pair.now.drift.push_back(physical ? lowered(value) : -1);
        pair.drift_terms.emplace_back();
        for (std::size_t n = 0; physical && n < value.terms().size(); ++n)
            pair.drift_terms.back().push_back(lowered(Polynomial::from_terms({value.terms()[n]})));
    }
    require_near_identity(program_, solution_, real, surroundings, pair);
}

} // namespace resonform
