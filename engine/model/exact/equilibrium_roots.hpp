// SPDX-License-Identifier: GPL-3.0-or-later
// Where several expressions vanish together, as closed forms: one unknown after the other is taken from an
// expression that is linear in it, or that factors into parts of degree 1 and 2 in it.
//
//   { x - x^3 }, x   ->   { x: -1 }, { x: 0 }, { x: 1 }
#pragma once

#include "model/system/system_file.hpp"

#include <vector>

namespace resonform {

struct RootsOfForces {
    const System& system; // its domain has the signs by which divisors and radicands are judged
    std::vector<GiNaC::ex> forces;
    std::vector<GiNaC::symbol> unknowns;
    std::vector<Place> places; // of each unknown, for messages

    // Every way to give the unknowns values. Expressions that were not needed may be left nonzero.
    // Errors (refused): an expression of another kind; a divisor that is not proved nonzero; a discriminant
    // without a proved sign.
    [[nodiscard]] std::vector<GiNaC::exmap> find() const;
};

} // namespace resonform
