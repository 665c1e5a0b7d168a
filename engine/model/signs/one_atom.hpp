// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of what is a rational function of one symbol or function alone, over all values that it may have.
//
//   x - 1 with x > 0 and x^2 - 2 > 0 declared      3*sin(u) + 4*cos(u) + 6      exp(2*u) - exp(u) + 1
#pragma once

#include "algebra/number/sign_set.hpp"
#include "model/system/system_file.hpp"

#include <optional>

namespace resonform {

// The signs of e over the declared domain: none that is missing occurs. nullopt: e is of several atoms, of
// none, of irrational numbers, or of roots; or the domain is empty. Precondition: e is real everywhere in it.
std::optional<SignSet> signs_of_one_atom(const GiNaC::ex& e, const System& system);

} // namespace resonform
