// SPDX-License-Identifier: GPL-3.0-or-later
// Names that a page prints besides those of the file.
#pragma once

#include "model/system/system_file.hpp"

#include <string>

namespace resonform {

// Has a parameter, variable, function or constant of the system this name?
bool is_taken(const System& system, const std::string& name);

// `wanted` if it is not taken, else wanted + "_new" ...
std::string free_name(const System& system, const std::string& wanted);

} // namespace resonform
