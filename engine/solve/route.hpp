// SPDX-License-Identifier: GPL-3.0-or-later
// The method of solution: by quadratures, in closed form, or as a slow flow.
#pragma once

#include "expand/expansion/graded_field.hpp"

namespace resonform {

// xi' = eps c
[[nodiscard]] bool has_explicit_law(const GradedField& field, const SlowVariable& slow);

// One small oscillator of weight 1 at most, at most one slow variable, xi' = eps*const, no angles, no
// functions in coefficients, style poincare, no `near`: else the solution is a slow flow.
[[nodiscard]] bool solves_by_quadratures(const GradedField& field);

} // namespace resonform
