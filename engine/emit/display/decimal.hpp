// SPDX-License-Identifier: GPL-3.0-or-later
// Rational numbers as decimal ones, rounded to a number of significant digits.
//
//   2/3 with 6 digits: 0.666667     1/2: 0.5     1/30000000: 3.33333e-8
#pragma once

#include "algebra/number/number.hpp"

#include <string>

namespace resonform {

// value >= 0. A number that is shorter is written as it is. Numbers below 10^-5, and those with more digits
// before the point than asked for, have an exponent.
std::string decimal(const Rational& value, int digits);
// The same with "\cdot 10^{-8}" as exponent.
std::string decimal_latex(const Rational& value, int digits);

} // namespace resonform
