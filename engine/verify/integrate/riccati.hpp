// SPDX-License-Identifier: GPL-3.0-or-later
// A rival for single linear oscillators whose cost does not grow with the frequency: adaptive Riccati defect
// correction, an own short implementation of the published method (F. Agocs and A. Barnett, SIAM J. Numer.
// Anal. 62 (2024) 295-321).
#pragma once

#include "verify/integrate/linear_oscillator.hpp"

#include <memory>

namespace resonform {

// Each step is as long as its coefficients are resolved on 32 nodes and the iterations reach the tolerance
// (verify/integrate/oscillator_step.hpp); below a wave it is collocation that makes it.
// Precondition: rates have a Jacobian, and are those of the oscillator.
std::unique_ptr<Integrator> make_riccati(RightHandSide rates, LinearOscillator oscillator,
                                         const Start& start);

} // namespace resonform
