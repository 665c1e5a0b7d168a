// SPDX-License-Identifier: GPL-3.0-or-later
// From a normal form to its slow flow: the frame, the rates within it, and the states of the system.
#pragma once

#include "solve/flow/slow_flow.hpp"

namespace resonform {

// order: outputs are cut at eps^order; truncation: normal form and map are used through this weight.
// transients = false: the flow on the slow manifold z_s = 0. Outputs have no term with a damped mode, and no
// damped mode has a place in the frame; the state at the start has it all.
// Errors (refused): a mode that grows at eps = 0; couplings between modes of one eigenvalue; a monomial that
// is kept though its divisor is only near zero; modes in numbers.
SlowFlow slow_flow(const Normalization& normalization, int order, int truncation, bool transients = true);

} // namespace resonform
