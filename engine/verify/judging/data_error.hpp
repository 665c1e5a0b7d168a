// SPDX-License-Identifier: GPL-3.0-or-later
// What data leave open of a motion. The ladder is against the equation with the spline through all samples;
// that the true function is another one shows where samples are left out:
//
//   data error of x = max |x - x'|,   x' the motion with the spline through every other sample
//
// Its largest part is that of the phase, (1/eps) int (omega - omega') dT, which grows as eps falls. Of a
// smooth function it is about 2^(d+1) times the error of the whole spline, of noise as large as that.
#pragma once

#include "verify/judging/judge.hpp"
#include "verify/judging/trial.hpp"

#include <vector>

namespace resonform {

// Of each output of the trial, at this eps; empty: the scene has no data, or too few to leave some out.
std::vector<DataError> data_errors(const Trial& trial, const Rational& eps);

} // namespace resonform
