// SPDX-License-Identifier: GPL-3.0-or-later
// The method of solution: by quadratures, in closed form, or as a slow flow.
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "solve/slow_law.hpp"

#include <optional>

namespace resonform {

// Of xi' = eps (a - b xi), over eps; nullopt: the law is another.
[[nodiscard]] std::optional<SlowPath> explicit_law(const GradedField& field, const SlowVariable& slow);

// One small oscillator of weight 1 at most, at most one slow variable of explicit law, no angles, no
// functions in coefficients, style poincare, no `near`: else the solution is a slow flow.
[[nodiscard]] bool solves_by_quadratures(const GradedField& field);

} // namespace resonform
