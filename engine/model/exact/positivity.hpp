// SPDX-License-Identifier: GPL-3.0-or-later
// A sound prover of signs: what it says holds; "unknown" says nothing.
#pragma once

#include "model/system/system_file.hpp"

namespace resonform {

// true: e > 0 wherever parameters and slow variables lie in their declared domain (sums of products
// of positive symbols and even powers, positive functions, declared expressions, and these up to
// factors and addends proved positive; sums with roots by squares; all of one symbol or function; bounds of
// functions). false: not proved.
//   xi^2 + r^2, g/sqrt(xi^2 + r^2), exp(tau), sqrt(g^2 + r) - g, with r, g > 0;   2 + 2*tau where 1 + tau is
//   declared;   sin(tau) - 4*cos(tau) + 6
bool provably_positive(const GiNaC::ex& e, const System& system);

// true: e != 0 there, by the same reasoning, or since e = 0 would contradict what is declared; false: not
// proved.   tau where tau^2 - 2 is declared
bool provably_nonzero(const GiNaC::ex& e, const System& system);

} // namespace resonform
