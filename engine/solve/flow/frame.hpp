// SPDX-License-Identifier: GPL-3.0-or-later
// From a normal form to its slow flow: the frame, the rates within it, and the states of the system.
#pragma once

#include "normalize/recursion/normal_form.hpp"
#include "solve/flow/slow_flow.hpp"
#include "solve/flow/solve_options.hpp"

namespace resonform {

// Outputs are cut at eps^order; normal form and map are used through the weight `truncation`.
// transients = false: the flow on the slow manifold z_s = 0. Outputs have no term with a damped mode, and no
// damped mode has a place in the frame; the state at the start has it all. growing = project: likewise of the
// modes that grow, without which the state at the start is, too. at_zero: likewise of this mode.
// Errors (refused): couplings between modes of one eigenvalue; a monomial that is kept though its divisor is
// only near zero; modes in numbers; a start that cannot be projected, because an angle would move; a mode at
// 0 that others drive. bad_input: a mode at 0 that is none, or oscillates.
SlowFlow slow_flow(const Normalization& normalization, const SolveOptions& options);

} // namespace resonform
