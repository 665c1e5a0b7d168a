// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments of an evaluator by the defaults of its scene.
#pragma once

#include "emit/program/program.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform {

// The defaults of parameters and start values at a given eps; NaN where a parameter has no default.
template <class Real> std::vector<Real> default_parameters(const Program& program, Real eps);
template <class Real>
std::vector<Real> default_start(const Program& program, Real eps, const std::vector<Real>& parameters);
// The slow time up to which the scene asks at a given eps, as emitted code has it by default.
template <class Real>
Real default_slow_time_end(const Program& program, Real eps, const std::vector<Real>& parameters);

// Arguments by name: of a parameter its own, of a start value that in [start], "amplitude.psi".
using GivenArguments = std::map<std::string, double>;

// The arguments of an evaluator: the given ones, and the scene's defaults for the others. Given names that
// the program does not use are ignored.
template <class Real> struct ProgramArguments { std::vector<Real> parameters, start; };
template <class Real>
ProgramArguments<Real> program_arguments(const Program& program, Real eps, const GivenArguments& given);

} // namespace resonform
