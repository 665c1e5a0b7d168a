// SPDX-License-Identifier: GPL-3.0-or-later
// Which systems can have their coefficients in numbers: what the option that asks for it accepts, and what
// messages may offer.
#pragma once

#include "model/system/system_file.hpp"

#include <optional>

namespace resonform {

// Why --digits refuses a system, whatever values its parameters get; nullopt: it does not.
std::optional<Diagnostic> hindrance_to_numbers(const System& system);

} // namespace resonform
