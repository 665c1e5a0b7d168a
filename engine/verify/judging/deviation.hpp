// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted minus direct, at every time of a reference.
#pragma once

#include "verify/judging/trial.hpp"

#include <string>
#include <vector>

namespace resonform {

struct Deviation {
    std::vector<std::vector<double>> error; // [output][point]; infinite where the evaluator refuses
    int digits = 0;                         // of the arithmetic used
    std::vector<double> floor;              // its rounding, per output
    std::vector<double> rounding;           // that of long double
    Status refused = Status::ok;            // the first refusal
    std::string refusal;                    // the same with its cause and time
};

// Long double where its rounding is a hundred times below the largest errors, otherwise Float128. rounding:
// that of long double, where it is known; to find it takes longer than all the rest.
Deviation deviation(const Trial& trial, const TrialPoint& at, const Reference& reference,
                    std::vector<double> rounding = {});

// The largest |error|, peaks between even points refined by the parabola through their neighbours. `even`:
// the indices of points that are evenly spread.
double largest(const std::vector<double>& error, const std::vector<std::size_t>& even);
// sqrt of the mean of error^2 over the interval (trapezoidal rule over the even points).
double root_mean_square(const std::vector<double>& error, const std::vector<std::size_t>& even);

} // namespace resonform
