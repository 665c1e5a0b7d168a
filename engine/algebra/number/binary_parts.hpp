// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers as unevaluated sums of doubles with a power of two, for real types of any precision and
// range.
#pragma once

#include "algebra/number/number.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

// value = 2^exponent * (sum of parts, each the double next to what the ones before leave), at most `count`;
// seven, 371 bits, are enough for 100 decimal digits:
//
//   1/3, 2   ->   {0.333..., 1.85...e-17}, 0       2^5000/3, 1   ->   {0.666...}, 4999
//
// The exponent is 0 where all parts are ordinary doubles without one. No zeros among the parts.
struct BinaryParts {
    std::vector<double> parts;
    int exponent = 0;
};

BinaryParts binary_parts(const Rational& value, std::size_t count = 7);

} // namespace resonform
