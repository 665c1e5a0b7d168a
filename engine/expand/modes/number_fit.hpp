// SPDX-License-Identifier: GPL-3.0-or-later
// Which systems can have their coefficients in numbers: those that the option --digits accepts, and for which
// messages may offer it.
#pragma once

#include "model/system/system_file.hpp"

#include <optional>

namespace resonform {

// Why --digits refuses a system, whatever values its parameters get; nullopt: it does not.
std::optional<Diagnostic> hindrance_to_numbers(const System& system);

} // namespace resonform
