// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a slow flow: its rates are those of the normal form, each mode in its frame, and its
// outputs and states are those of the map (certify/restated.hpp).
#pragma once

#include "solve/solution.hpp"

#include <string>

namespace resonform {

// "" if all of it holds, or if the solution is in closed form. Errors (refused): those of certify().
std::string flow_complaint(const Solution& solution);

} // namespace resonform
