// SPDX-License-Identifier: GPL-3.0-or-later
// Derived expressions as a user would write them, always in the same order: terms by what moves in them
// (accelerations, velocities, functions, coordinates), each with one coefficient.
//
//   "(xi^2 + r^2)*phi'' + xi*xi'*phi' + g*r*sin(phi) - g*xi*cos(phi)"
#pragma once

#include "model/exact/form.hpp"

#include <string>

namespace resonform {

std::string written(ExactForm& form, const GiNaC::ex& e);

} // namespace resonform
