// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit first-order system: implicit equations solved for their highest derivatives, the
// rates of slow variables substituted.
//
//   psi'' (xi^2 + r^2) + ... = 0, xi' = eps v   ->   (psi)' = psi', (psi')' = -(...)/(xi^2 + r^2), ...
#pragma once

#include "model/system_file.hpp"

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
};

struct FirstOrderSystem {
    std::shared_ptr<const System> system;
    std::vector<State> states; // variables in file order, derivatives 0 ... order-1 of each

    [[nodiscard]] const State& state(const std::string& name) const;
    [[nodiscard]] std::size_t index(std::size_t variable, int derivative) const;
};

// Solves the equations, linear in all highest derivatives at once, for them; the determinant is
// tested. Errors (bad_input): an equation that is not linear in its highest derivative (names the
// term), a determinant that is zero.
FirstOrderSystem solve_for_highest(std::shared_ptr<const System> system);

// yes: e > 0 wherever parameters and slow variables lie in their declared domain (sums of products
// of positive symbols and even powers, declared expressions); unknown otherwise.
bool provably_positive(const GiNaC::ex& e, const System& system);

} // namespace resonform
