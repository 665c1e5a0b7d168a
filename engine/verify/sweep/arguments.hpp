// SPDX-License-Identifier: GPL-3.0-or-later
// The axes of a sweep as arguments of a scene's evaluator.
#pragma once

#include "emit/program/program.hpp"
#include "verify/evaluate/program_defaults.hpp"
#include "verify/sweep/grid.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace resonform {

// Refuses, before anything is derived, axes that no evaluator of the scene has. Errors (bad_input): no axis
// eps, or values of it outside of 1e-12 ... 0.5; a name under [fix].
void require_axes(const SweepGrid& grid, const Scene& scene);

// Of each axis, its place among eps, the parameters and the start values of the program, in this order.
// Errors (bad_input): a name that is none of them; a parameter without a value.
std::vector<std::size_t> places_of_axes(const SweepGrid& grid, const Program& program, const Scene& scene);

// "eps", "g", "amplitude.psi": the argument's name whatever the system calls it.
std::string canonical_name(const Program& program, std::size_t place);

// The arguments of point i, eps among them, by these names. places: those of places_of_axes.
GivenArguments arguments_at(const SweepGrid& grid, std::uint64_t i, const Program& program,
                            const std::vector<std::size_t>& places);

} // namespace resonform
