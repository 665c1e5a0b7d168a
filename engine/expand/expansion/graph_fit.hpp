// SPDX-License-Identifier: GPL-3.0-or-later
// Which systems can have their coefficients in a graph: those that the option --coefficients graph accepts,
// and for which messages may offer it.
#pragma once

#include "expand/expansion/graded_field.hpp"

namespace resonform {

// Whether --coefficients graph takes it: style poincare, no root or function in the coefficients.
bool fits_graph(const GradedField& field);

} // namespace resonform
