// SPDX-License-Identifier: GPL-3.0-or-later
// From a normal form to its slow flow: the frame, the rates within it, and the states of the system.
#pragma once

#include "solve/flow/slow_flow.hpp"

namespace resonform {

// order: outputs are cut at eps^order; truncation: normal form and map are used through this weight.
// Errors (refused): a mode that grows at eps = 0; couplings between modes of one eigenvalue; a monomial that
// is kept though its divisor is only near zero; modes in numbers.
SlowFlow slow_flow(const Normalization& normalization, int order, int truncation);

} // namespace resonform
