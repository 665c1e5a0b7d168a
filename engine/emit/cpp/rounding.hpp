// SPDX-License-Identifier: GPL-3.0-or-later
// How far are outputs off because constants are rounded step by step, not once? First-order error analysis
// (N. J. Higham, Accuracy and Stability of Numerical Algorithms, chapter 3) at one sample of the arguments:
// each step adds a unit u = 2^-digits, and an error counts in a sum by the share of its term:
//
//   c = a b d, x = c T + y   ->   two steps of c, less the one that is left: |c T|/(|c T| + |y|) u
#pragma once

#include "emit/program/straight_line.hpp"

#include <vector>

namespace resonform {

// The largest such error of the outputs, in units u of the sum of the sizes of their terms, where eps is
// 1/1000 and the start that by default.
double rounding_of_constants(const Program& program, StraightLine& code,
                             const std::vector<StraightLine::Value>& outputs);

} // namespace resonform
