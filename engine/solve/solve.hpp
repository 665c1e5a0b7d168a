// SPDX-License-Identifier: GPL-3.0-or-later
// Normal form and map -> Solution.
#pragma once

#include "solve/solution.hpp"

#include <memory>

namespace resonform {

// Whether the solution is found by quadratures (solve/route.hpp) on times of order eps^-time_scale.
// Amplitudes that change are expanded in powers of T = eps t, which is large beyond 1/eps: on longer times
// quadratures are used for constant amplitudes only.
[[nodiscard]] bool solves_by_quadratures(const NormalForm& normal_form, int time_scale);

// Errors (refused): functions known by their names among the coefficients, a slow variable that does not
// move; by quadratures: an oscillator that is damped or grows at weight 0; else those of slow_flow().
Solution solve(std::shared_ptr<const Normalization> normalization, const SolveOptions& options);

} // namespace resonform
