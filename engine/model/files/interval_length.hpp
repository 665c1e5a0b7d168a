// SPDX-License-Identifier: GPL-3.0-or-later
// How long the interval of verification is, and how fast it grows as eps -> 0: exp(1/eps) is beyond every
// floating-point number, its logarithm is not.
#pragma once

#include "model/system/scene_file.hpp"

#include <optional>

namespace resonform {

// The range in which evaluators tabulate and integrations start.
constexpr double shortest_interval = 1e-200, longest_interval = 1e200;

// Of an expression in eps, [fix] put in, at one eps: 0 and infinity where a double cannot hold it, NaN where
// it is not a positive number (a parameter is left, it is negative, it has a pole there).
double length_at(const Scene& scene, const GiNaC::ex& interval, const Rational& eps);

// The interval of the scene; infinite beyond the doubles.
// Errors (bad_input, at verify.interval): not a positive number there, shorter than shortest_interval.
double interval_length(const Scene& scene, const Rational& eps);

// Errors: the same, and longer than longest_interval.
double bounded_interval_length(const Scene& scene, const Rational& eps);

// The least p for which interval eps^p stays bounded as eps -> 0, held as weights are, or one more where it
// grows between powers as eps^-1 log(1/eps) does; none: faster than every power, or it cannot be told.
std::optional<int> growth_power(const Scene& scene, const GiNaC::ex& interval);

} // namespace resonform
