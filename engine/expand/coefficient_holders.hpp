// SPDX-License-Identifier: GPL-3.0-or-later
// What can hold the coefficients of a system besides a ring: what the options that ask for it accept, and
// what messages may offer.
#pragma once

#include "expand/graded_field.hpp"

#include <optional>

namespace resonform {

// Why --digits refuses a system, whatever values its parameters get; nullopt: it does not.
std::optional<Diagnostic> hindrance_to_numbers(const System& system);

// Whether --coefficients graph takes it: style poincare, no root or function in the coefficients.
bool fits_graph(const GradedField& field);

} // namespace resonform
