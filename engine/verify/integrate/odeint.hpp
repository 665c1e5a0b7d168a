// SPDX-License-Identifier: GPL-3.0-or-later
// Boost.odeint: Dormand-Prince 5(4) and Bulirsch-Stoer with their own dense output, Fehlberg 7(8) stepping to
// every time.
#pragma once

#include "verify/integrate/integrator.hpp"

namespace resonform {

std::unique_ptr<Integrator> make_odeint(Method method, RightHandSide rates, const Start& start);

} // namespace resonform
