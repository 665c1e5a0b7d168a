// SPDX-License-Identifier: GPL-3.0-or-later
// Do the units of a mechanism fit together? Units that are not given are found from its expressions.
//
//   z' = eps*(x'*y - y'*x) with x, y, z in m: eps is in 1/m
#pragma once

#include "model/dimension.hpp"
#include "model/mechanism.hpp"

namespace resonform {

// Sums, arguments of functions, energies and forces. A file without units is not checked.
// Errors (bad_input): a term whose unit is not that of the others; the argument of a function with a unit;
// what is not the energy or the force that it should be.
void check_units(const Mechanism& mechanism, const System& system);

} // namespace resonform
