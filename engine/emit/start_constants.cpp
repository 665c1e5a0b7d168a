// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/start_constants.hpp"

#include "emit/scene_program.hpp"

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

// Start values of the states that the scene gives; those of an oscillator given by its constants are
// the solution at t = 0.
void StartConstants::define_physical_values(const InitialValues& values, Moment& start) {
    const FirstOrderSystem& system = *solution_.normalization->normal_form.field->first_order;
    const RingMap map = RingMap::by_name(solution_.ring, values.ring);
    for (std::size_t k = 0; k < solution_.state.size(); ++k) {
        const std::string& name = solution_.state[k].name;
        if (is_physical(system.state(name).variable))
            start.lowering.define(values.start[k], input(name + "_0", name + " at t = 0", name), false);
    }
    for (std::size_t k = 0; k < solution_.state.size(); ++k) {
        const std::size_t variable = system.state(solution_.state[k].name).variable;
        const bool oscillator =
            std::any_of(solution_.modes.begin(), solution_.modes.end(),
                        [&](const ModeSolution& mode) { return mode.variable == variable; });
        if (!oscillator || is_physical(variable)) continue;
        const Polynomial value = map(solution_.state[k].value.total(solution_.state[k].value.through()));
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
    MomentPlan plan;
    plan.slow_time = program_.graph.rational(0);
    plan.slow_variables = slow_starts_;
    plan.quadrature = [this](const Primitive&, Lowering&) { return program_.graph.rational(0); };
    Moment start(program_, solution_, values.ring, surroundings, plan);
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

} // namespace resonform
