// SPDX-License-Identifier: GPL-3.0-or-later
// May the constants of the construction be computed in the real type itself? Powers and products of
// arguments leave its range sooner or later, and sums may cancel; this computes the allowed range of the
// arguments:
//
//   C^3/192 eps   ->   all steps lie within 2^-900 ... 2^900 where C and eps lie within 2^-223 ... 2^223
#pragma once

#include "emit/program/straight_line.hpp"

#include <vector>

namespace resonform {

struct ConstantRange {
    // True: each step is in the range of double and doubled precision while every argument in `limited` is 0
    // or of a size 2^-bound ... 2^bound, with bound at least 100 (1e30). False: use Scaled.
    bool native = true;
    int bound = 0;
    std::vector<Graph::Node> limited; // arguments that something is computed from, ascending
};

// For the constants listed and everything they are computed from.
ConstantRange constant_range(const StraightLine& code, const std::vector<StraightLine::Value>& constants);

} // namespace resonform
