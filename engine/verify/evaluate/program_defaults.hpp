// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments of an evaluator by the defaults of its scene.
#pragma once

#include "emit/program/program.hpp"

#include <vector>

namespace resonform {

// The defaults of parameters and start values at a given eps; NaN where a parameter has no default.
template <class Real> std::vector<Real> default_parameters(const Program& program, Real eps);
template <class Real>
std::vector<Real> default_start(const Program& program, Real eps, const std::vector<Real>& parameters);
// The slow time up to which the scene asks at a given eps, as emitted code has it by default.
template <class Real>
Real default_slow_time_end(const Program& program, Real eps, const std::vector<Real>& parameters);

} // namespace resonform
