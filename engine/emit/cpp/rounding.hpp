// SPDX-License-Identifier: GPL-3.0-or-later
// How far are outputs off because constants are rounded step by step, not once? First-order error analysis
// (N. J. Higham, Accuracy and Stability of Numerical Algorithms, chapter 3) at a sample of the arguments.
// Step k makes n_k independent errors of a unit u = 2^-digits. How far such an error changes an output is the
// logarithmic derivative of the output by the step, 2 where the output is a square of it:
//
//   rounding^2 = sum_k n_k (d log output/d log step_k)^2 u^2,   output: the sum of the sizes of its terms
//
// Constants of integrands and of a flow's rates count by what the integral over slow time 1 has of its value;
// rounding errors of single nodes average out in the sum and are not counted.
#pragma once

#include "emit/program/straight_line.hpp"

#include <vector>

namespace resonform {

// In units u: each step computed as it is, and each constant rounded once, whatever it is made of.
struct RoundingOfOutput {
    double stepwise = 0, once = 0;
};

// Of the outputs where eps is 1/1000 and the start that by default, and again where all that decays is gone.
std::vector<RoundingOfOutput> rounding_of_constants(const Program& program, StraightLine& code,
                                                    const std::vector<StraightLine::Value>& outputs);

// Whether constants in more digits are worth their time: without them an output loses more than others do
// without constants.
bool rounds_much(const std::vector<RoundingOfOutput>& roundings);

} // namespace resonform
