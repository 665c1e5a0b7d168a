// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the equations against the roles of the variables.
#include "algebra/number/error.hpp"
#include "expand/expansion/expansion.hpp"
#include "model/exact/question.hpp"
#include "model/text/canonical.hpp"

#include <fmt/format.h>

namespace resonform {

using GiNaC::ex;

void Expansion::check_drifts() const {
    for (const State& state : first_order_->states)
        for (const Variable& v : system_.variables)
            if (v.role == Role::drift && state.rate.has(v.jet.front()))
                bad_input({"nothing depends on a drift variable",
                           fmt::format("the equation of {} contains {}", variable_of(state).name, v.name),
                           fmt::format("give {} the role slow", v.name), place_of_equation(state.variable)});
}

bool Expansion::occurs(Role role, const ex& e) const {
    for (const State& state : first_order_->states)
        if (variable_of(state).role == role && e.has(state.symbol)) return true;
    return false;
}

// A slow variable is driven by fast variables, angles and driven slow variables in its rate.
void Expansion::find_driven() {
    driven_.assign(system_.variables.size(), false);
    bool found = true;
    while (found) {
        found = false;
        for (const State& state : first_order_->states) {
            if (variable_of(state).role != Role::slow || driven_[state.variable]) continue;
            bool driven = occurs(Role::fast, state.rate) || occurs(Role::angle, state.rate);
            for (const State& other : first_order_->states)
                driven = driven || (driven_[other.variable] && state.rate.has(other.symbol));
            driven_[state.variable] = driven;
            found = found || driven;
        }
    }
}

void Expansion::check_slow_rate(const State& state) const {
    const Place place = place_of_equation(state.variable);
    const Variable& variable = variable_of(state);
    const ex rest = coefficients_.at_origin(state.rate, place);
    if (!rest.is_zero() && vanishes(rest, system_) == Zero::unknown)
        refuse(Reason::undecided,
               {fmt::format("the rate of a {} variable is proved to vanish at eps = 0",
                            to_string(variable.role)),
                fmt::format("{}' = {} there, which may be zero", variable.name, spell(rest)),
                "write it as 0 if it is zero, or in a simpler form", place});
    if (!rest.is_zero())
        bad_input({fmt::format("the rate of a {} variable vanishes with eps{}", to_string(variable.role),
                               variable.role == Role::drift ? " and the fast variables" : ""),
                   fmt::format("{}' = {}", variable.name, spell(state.rate)),
                   "write the rate with a factor eps", place});
    if (variable.role == Role::slow && !driven_[state.variable] && !state.rate.is_polynomial(system_.eps))
        refuse({"the rate of a slow variable is a polynomial in eps",
                fmt::format("{}' = {}", variable.name, spell(state.rate)), "expand the rate in powers of eps",
                place});
}

} // namespace resonform
