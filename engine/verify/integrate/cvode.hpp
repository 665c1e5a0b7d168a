// SPDX-License-Identifier: GPL-3.0-or-later
// SUNDIALS CVODE (Adams with fixed-point iteration, BDF with Newton and a dense difference Jacobian).
#pragma once

#include "verify/integrate/integrator.hpp"

namespace resonform {

// Dense output by CVodeGetDky inside each step. The library's messages become `failure`.
std::unique_ptr<Integrator> make_cvode(Method method, RightHandSide rates, const Start& start);

} // namespace resonform
