// SPDX-License-Identifier: GPL-3.0-or-later
// Solution and scene -> Program.
#pragma once

#include "emit/program/program.hpp"
#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"

namespace resonform {

// Errors: bad_input: an output that is no variable of the system, a fixed value outside its domain, an
// amplitude without a start value; refused: a division by zero or a root of a negative number among the
// fixed values, a function in a start value that emitted code does not know.
Program build_program(const Solution& solution, const Scene& scene, const ProgramOptions& options = {});

} // namespace resonform
