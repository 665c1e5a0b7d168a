// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the user's files as identifiers of a programming language.
#pragma once

#include <string>

namespace resonform {

// "psi'" -> "psi_dot", "psi''_0" -> "psi_dot_dot_0", "phase.psi" -> "phase_psi"; all characters
// but letters and digits become underscores.
std::string identifier(const std::string& name);

} // namespace resonform
