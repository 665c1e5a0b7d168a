// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that a scene gives by data, in a program.
#pragma once

#include "emit/program/program.hpp"

namespace resonform {

// Fills Program::data. Errors (refused): data stand at a slow variable whose motion is not even: nothing
// knows beforehand when it passes their breakpoints.
void find_data(Program& program);

} // namespace resonform
