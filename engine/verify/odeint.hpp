// SPDX-License-Identifier: GPL-3.0-or-later
// Boost.odeint: Dormand-Prince 5(4) with its own dense output, Fehlberg 7(8) stepping to every time.
#pragma once

#include "verify/integrate.hpp"

namespace resonform {

IntegrationResult integrate_odeint(Method method, BoundTape<double> rates, const std::vector<double>& start,
                                   const std::vector<double>& times, double tolerance);

} // namespace resonform
