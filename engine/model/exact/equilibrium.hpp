// SPDX-License-Identifier: GPL-3.0-or-later
// [equilibrium] of a system: values that are given are checked, "solve" is solved for, in the equations at
// eps = 0 with the slow variables frozen and all fast variables that are not named at 0.
//
//   c' = s - (s + kappa)*c,  c = "solve"     ->  c = s/(s + kappa)      where s + kappa is proved nonzero
//   x'' = x - x^3,           x = "solve"     ->  refused: x = -1, 0 or 1
#pragma once

#include "model/system/system_file.hpp"

namespace resonform {

// Afterwards every Equilibrium has a value that is proved to be real, and to make the rates of the fast
// variables zero. Solved for are linear equations, and factors of degree 1 and 2 in one variable.
// Errors: bad_input if a given value is no equilibrium, or if there is none to be found; refused if a zero
// test stays undecided, a divisor is not proved nonzero or a radicand not proved positive, if there are
// several solutions, or if an equation is of another kind; and those of solve_for_highest().
void settle_equilibrium(System& system);

} // namespace resonform
