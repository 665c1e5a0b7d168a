// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit first-order system: implicit equations solved for their highest derivatives, the
// rates of slow variables substituted.
//
//   psi'' (xi^2 + r^2) + ... = 0, xi' = eps v   ->   (psi)' = psi', (psi')' = -(...)/(xi^2 + r^2), ...
#pragma once

#include "model/exact/substitution.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/system/system_file.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct State {
    std::string name;     // "psi", "psi'"
    std::size_t variable; // index into system.variables
    int derivative;       // 0 for psi, 1 for psi'
    GiNaC::symbol symbol; // the jet symbol
    GiNaC::ex rate;       // in states, parameters and eps only
    GiNaC::ex shift = 0;  // what the user's variable is more than this state (equilibrium_shift.hpp)
};

struct FirstOrderSystem {
    std::shared_ptr<const System> system;
    std::vector<State> states;      // variables in file order, derivatives 0 ... order-1 of each
    bool about_equilibrium = false; // states of [equilibrium] are measured from there

    [[nodiscard]] const State& state(const std::string& name) const;
    [[nodiscard]] std::size_t index(std::size_t variable, int derivative) const;
};

// The states with their rates, for along().
std::vector<TimeDerivative> motion_of(const FirstOrderSystem& system);

// Solves the equations for the highest derivatives: an equation with a single unknown one is solved for it,
// and the result is put into the others (so xi' = eps v may stand squared elsewhere); the equations left are
// solved together as a linear system. No rate holds a highest derivative.
// Errors: bad_input: an equation that is not linear in them (marks the derivative), one that holds
// none, a determinant that is zero; refused: a coefficient that can be told neither zero nor nonzero.
FirstOrderSystem solve_for_highest(std::shared_ptr<const System> system);

} // namespace resonform
