// SPDX-License-Identifier: GPL-3.0-or-later
// The names that [start] of a scene may give: physical values ("xi", "psi", "psi'", "x") and the
// constants of the solution, by canonical name ("amplitude.psi") or by the system's notation (C_delta).
#pragma once

#include "model/system/system_file.hpp"

#include <string>
#include <vector>

namespace resonform {

// "C_delta" -> "amplitude.psi"; canonical names stay; anything else is "".
std::string canonical_start(const std::string& name, const System& system);

// The name a user of this system would write: "amplitude.psi" -> "C_delta".
std::string user_start(const std::string& canonical, const System& system);

// Every name that [start] accepts, the notation's instead of the canonical one where it has one.
std::vector<std::string> start_names(const System& system);

} // namespace resonform
