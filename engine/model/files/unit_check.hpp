// SPDX-License-Identifier: GPL-3.0-or-later
// Do the units of a mechanism fit together? Units that are not given are found from its expressions.
//
//   z' = eps*(x'*y - y'*x) with x, y, z in m: eps is in 1/m
#pragma once

#include "model/files/dimension.hpp"
#include "model/system/mechanism.hpp"

namespace resonform {

// [relations] k = "J*c/m"
struct GivenRelation {
    const Parameter* parameter;
    Written value; // in parameters and eps
};

// Checks sums, arguments of functions, energies and forces, relations, and expressions declared positive. A
// file without units is not checked. Returns the units that the file does not give, but determines: { "eps",
// "1/m" }, in the order of the file. Errors (bad_input): a term whose unit is not that of the others; the
// argument of a function with a unit; an energy or a force whose unit is not that of energies or forces.
std::vector<std::pair<std::string, std::string>> check_units(const Mechanism& mechanism, const System& system,
                                                             const std::vector<GivenRelation>& relations);

} // namespace resonform
