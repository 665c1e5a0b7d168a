// SPDX-License-Identifier: GPL-3.0-or-later
// The times at which a formula is compared with direct integration.
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "model/system/scene_file.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

// Evenly spread over [from, interval], both ends included; points >= 2.
std::vector<double> even_times(double interval, std::size_t points, double from = 0);

struct SampleTimes {
    std::vector<double> all;       // ascending, both ends of the interval included
    std::vector<std::size_t> even; // which of them are evenly spread
    double first = 0;              // the least above 0
};

// Half of the points even over [from, interval]; a quarter in geometric progression from each end, the first
// 10^-3/rate or 10^-9 of the length away, whichever is smaller: an error that lives in a layer at an end is
// met at every length of the layer. Times that coincide are counted once. points >= 8, rate >= 0.
SampleTimes crowded_times(double interval, std::size_t points, double rate, double from = 0);

// The largest |lambda| of the linear part, or frequency of an angle, where the motion starts; 0: there is
// none that is a number. Precondition: [fix] gives every parameter.
double largest_rate(const GradedField& field, const Scene& scene, const Rational& eps);

// Whether Re lambda of some mode is positive where the motion starts, declared or as [fix] and [start] have
// it.
bool grows_at_start(const GradedField& field, const Scene& scene, const Rational& eps);

// The decimal digits that direct integration through the interval loses beside modes that decay first and
// grow later: int |Re lambda| dt/ln 10, with slow variables that move evenly. 0: there are none.
double digits_lost(const GradedField& field, const Scene& scene, const Rational& eps);

// 20/min |Re lambda| of the modes that are damped, at the start: where modes decay, errors are judged apart
// up to there. 0: none decays, or the scene is without transients.
double layer_length(const GradedField& field, const Scene& scene, const Rational& eps);

// Where a solution without transients may be judged: there the slowest of them, from amplitudes of order 1
// with its rate at the start, has become 10^-3 eps^{N+1}. 0: nothing is left out, or, beside modes that grow,
// the integration starts on the manifold.
double layer_end(const GradedField& field, const Scene& scene, const Rational& eps);

// The interval of the scene; beside modes that grow only up to where the fastest has grown by e^3, with its
// rate at the start: whatever is neglected grows likewise, and direct integration judges nothing beyond.
double judged_interval(const GradedField& field, const Scene& scene, const Rational& eps);

} // namespace resonform
