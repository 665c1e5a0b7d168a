// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/equilibrium_shift.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/substitution.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

class EquilibriumShift {
public:
    explicit EquilibriumShift(const FirstOrderSystem& from)
        : from_(from), system_(*from.system), motion_(motion_of(from)) {
        for (const Equilibrium& at : system_.equilibrium) shift(at);
    }

    FirstOrderSystem result() const {
        FirstOrderSystem to = from_;
        to.about_equilibrium = true;
        for (State& state : to.states) {
            const auto own = shifts_.find(state.symbol);
            const bool highest = state.derivative + 1 == variable(state).order;
            if (own != shifts_.end()) state.shift = in_new(own->second, state.variable);
            if (own != shifts_.end() && highest)
                state.rate = in_new(state.rate - shifts_.at(variable(state).jet.back()), state.variable);
            else if (own == shifts_.end())
                state.rate = in_new(state.rate, state.variable);
            require_known_velocity(state);
        }
        System system = system_;
        for (std::size_t v = 0; v < system.variables.size(); ++v)
            system.equations[v].residual = in_new(system.equations[v].residual, v);
        if (system.hamiltonian && is_fixed())
            system.hamiltonian->energy = in_new(system.hamiltonian->energy, 0);
        else
            system.hamiltonian.reset(); // a moving equilibrium: the variables are canonical no longer
        to.system = std::make_shared<const System>(std::move(system));
        return to;
    }

private:
    [[nodiscard]] const Variable& variable(const State& state) const {
        return system_.variables[state.variable];
    }

    // x = c + new, x' = c' + new', ... with c' along the motion, in old variables.
    void shift(const Equilibrium& at) {
        ex derivative = at.value;
        for (const GiNaC::symbol& jet : system_.variables[at.variable].jet) {
            const GiNaC::symbol fresh(jet.get_name());
            shifts_[jet] = derivative;
            old_[jet] = fresh + derivative;
            named_[fresh] = jet;
            derivative = along(derivative, motion_);
        }
    }

    [[nodiscard]] bool is_fixed() const {
        return std::all_of(shifts_.begin(), shifts_.end(), [&](const auto& entry) {
            return std::none_of(from_.states.begin(), from_.states.end(),
                                [&](const State& s) { return entry.second.has(s.symbol); });
        });
    }

    // An expression in old variables, in the new ones.
    [[nodiscard]] ex in_new(const ex& e, std::size_t of) const {
        const auto value = where_regular([&] { return put_through(e, old_); });
        const Place place = place_of(system_.equilibrium.front().source);
        if (!value)
            bad_input({"the equations have values where [equilibrium] says",
                       "the equation of " + system_.variables[of].name + " is divided by zero there",
                       "correct the equilibrium", place});
        if (!*value)
            refuse({"an equilibrium moves with slow variables that do not depend on its own velocity",
                    "the equation of " + system_.variables[of].name,
                    "write the equations in first order, with the velocity as a variable", place});
        return put(**value, named_);
    }

    // The velocity of an oscillator about a moving equilibrium is measured from that of the equilibrium.
    void require_known_velocity(const State& state) const {
        if (state.derivative == 0) return;
        for (const State& other : from_.states)
            if (variable(other).role != Role::slow && state.shift.has(other.symbol))
                refuse(
                    {"the velocity of an equilibrium is a function of slow variables and parameters, where "
                     "the equation is of second order or higher",
                     "that of " + variable(state).name + " depends on " + other.name,
                     "write the equations in first order, with the velocity as a variable",
                     place_of(system_.equilibrium.front().source)});
    }

    const FirstOrderSystem& from_;
    const System& system_;
    std::vector<TimeDerivative> motion_; // of the states
    GiNaC::exmap shifts_; // jet -> the old variable minus the new one, as a function of old variables
    GiNaC::exmap old_;    // jet -> itself by a new symbol
    GiNaC::exmap named_;  // the new symbol -> jet
};

} // namespace

std::shared_ptr<const FirstOrderSystem> about_equilibrium(std::shared_ptr<const FirstOrderSystem> system) {
    if (system->system->equilibrium.empty() || system->about_equilibrium) return system;
    return std::make_shared<const FirstOrderSystem>(EquilibriumShift(*system).result());
}

} // namespace resonform
