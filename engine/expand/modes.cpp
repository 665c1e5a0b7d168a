// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes.hpp"

#include "model/canonical.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

using GiNaC::ex;

void check_order(const Variable& variable) {
    if (variable.order != 2)
        bad_input({"a fast variable obeys an equation of second order, an oscillator",
                   fmt::format("{} has order {}", variable.name, variable.order),
                   fmt::format("write an equation for {}'', or give {} the role slow or drift", variable.name,
                               variable.name),
                   variable.place});
}

void check_uncoupled(const FirstOrderSystem& system, const State& velocity,
                     const CoefficientRing& coefficients, const Place& place) {
    for (const State& other : system.states) {
        if (system.system->variables[other.variable].role != Role::fast) continue;
        const bool own = other.variable == velocity.variable;
        if (own && other.derivative == 0) continue;
        const ex coupling = coefficients.at_origin(velocity.rate.diff(other.symbol), place);
        if (coupling.is_zero()) continue;
        const std::string value = fmt::format("the coefficient of {} is {}", other.name, spell(coupling));
        if (own)
            refuse({"the linear part of a fast variable is an oscillator without damping", value,
                    "write the damping with a factor eps", place});
        refuse({"fast variables are not coupled in the linear part", value,
                "use normal coordinates, or write the coupling with a factor eps", place});
    }
}

void check_frequency(const ex& omega_squared, const Variable& fast, const System& system,
                     const Place& place) {
    if (provably_positive(omega_squared, system)) return;
    const std::string value = fmt::format("omega^2 = {} for {}", spell(omega_squared), fast.name);
    if (provably_positive(-omega_squared, system))
        bad_input({"the linear part of a fast variable pulls back to the origin", value,
                   "mend the sign, or shift the variable to a stable equilibrium", place});
    refuse({"the square of a frequency is proved to be positive", value,
            "declare what is positive: " + how_to_declare_positive(omega_squared), place});
}

} // namespace

Oscillator find_oscillator(const FirstOrderSystem& system, std::size_t variable,
                           const CoefficientRing& coefficients) {
    const Variable& fast = system.system->variables[variable];
    check_order(fast);
    const Place place = place_of(system.system->equations[variable].source);
    const State& position = system.states[system.index(variable, 0)];
    const State& velocity = system.states[system.index(variable, 1)];

    const ex force = coefficients.at_origin(velocity.rate, place);
    if (!force.is_zero())
        bad_input({"the origin of the fast variables is an equilibrium at eps = 0",
                   fmt::format("{}'' = {} there", fast.name, spell(force)),
                   fmt::format("shift {} to the equilibrium by a change of variable", fast.name), place});
    const ex slope = coefficients.at_origin(velocity.rate.diff(position.symbol), place);
    if (slope.is_zero())
        bad_input({"the linear part of a fast variable is an oscillator",
                   fmt::format("{}'' has no term linear in {}", fast.name, fast.name),
                   "give the variable another role, or write its restoring force", place});
    check_uncoupled(system, velocity, coefficients, place);
    const ex omega_squared = (-slope).normal();
    check_frequency(omega_squared, fast, *system.system, place);
    return {variable, omega_squared};
}

} // namespace resonform
