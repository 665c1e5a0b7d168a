// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the start values of a scene scale with eps by the weights; else a ladder in eps is meaningless.
#pragma once

#include "model/system/scene_file.hpp"

#include <string>

namespace resonform {

// The weight k by which a start value of [start] scales, as eps^k: that of a fast variable; 0 of the others
// and of constants of the solution.
int start_weight(const System& system, const std::string& name);

// Whether [equilibrium] has this variable ("x"; the velocity "x'" is measured from 0), and the value there,
// with these values of slow variables. Precondition of rest_of(): it has.
bool rests_elsewhere(const System& system, const std::string& name);
GiNaC::ex rest_of(const System& system, const std::string& name, const GiNaC::exmap& slow);

// A variable of weight k must start at eps^k times a constant: fast variables at eps * constant, the
// others and the constants of the solution free of eps (design 2.5), all but for the equilibrium that they
// are measured from. Returns the complaint, or "".
std::string start_scaling_complaint(const Scene& scene);

} // namespace resonform
