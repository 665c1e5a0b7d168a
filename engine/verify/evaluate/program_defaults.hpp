// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments of an evaluator by the defaults of its scene.
#pragma once

#include "algebra/number/binary_parts.hpp"
#include "emit/program/program.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform {

// The numbers of a program's nodes, if they are known (Interpretation::numbers): exact ones count their
// references without locks, so that threads which share them need this.
using NodeNumbers = std::vector<BinaryParts>;

// The defaults of parameters and start values at a given eps; NaN where a parameter has no default.
template <class Real>
std::vector<Real> default_parameters(const Program& program, Real eps, const NodeNumbers* numbers = nullptr);
template <class Real>
std::vector<Real> default_start(const Program& program, Real eps, const std::vector<Real>& parameters,
                                const NodeNumbers* numbers = nullptr);
// The slow time up to which the scene asks at a given eps, as emitted code has it by default.
template <class Real>
Real default_slow_time_end(const Program& program, Real eps, const std::vector<Real>& parameters,
                           const NodeNumbers* numbers = nullptr);

// Arguments by name: of a parameter its own, of a start value that in [start], "amplitude.psi".
using GivenArguments = std::map<std::string, double>;

// The arguments of an evaluator: the given ones, and the scene's defaults for the others. Given names that
// the program does not use are ignored.
template <class Real> struct ProgramArguments { std::vector<Real> parameters, start; };
template <class Real>
ProgramArguments<Real> program_arguments(const Program& program, Real eps, const GivenArguments& given,
                                         const NodeNumbers* numbers = nullptr);

} // namespace resonform
