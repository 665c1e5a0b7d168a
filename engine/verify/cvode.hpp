// SPDX-License-Identifier: GPL-3.0-or-later
// SUNDIALS CVODE (Adams with fixed-point iteration, BDF with Newton and a dense difference Jacobian).
#pragma once

#include "verify/integrate.hpp"

namespace resonform {

// Dense output by CVodeGetDky inside each step. The library's messages become `failure`.
IntegrationResult integrate_cvode(Method method, BoundTape<double> rates, const std::vector<double>& start,
                                  const std::vector<double>& times, double tolerance);

} // namespace resonform
