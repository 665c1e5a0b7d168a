// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a scene whose solution is a slow flow (solve/flow/slow_flow.hpp):
//
//   construction:  start values -> a_j = u_j + i v_j, zeta, Z at T = 0;  the flow d(u, v, zeta)/dT, if it
//   moves call:          x_j + i y_j = (u_j + i v_j) e^{i theta_j};  outputs as real polynomials of all x_j,
//   y_j
#pragma once

#include "emit/program/program.hpp"

namespace resonform {

// Precondition: solution.flow. Errors: as build_program, and refused: oscillators of which some start from
// constants and others from physical values; a constant of a variable that has no mode of its own.
Program build_flow_program(const Solution& solution, const Scene& scene, const ProgramOptions& options);

} // namespace resonform
