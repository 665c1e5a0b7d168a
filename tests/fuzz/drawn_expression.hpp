// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, coefficients and functions as a user writes them, drawn by chance.
#pragma once

#include "fuzz/draw.hpp"

#include <string>
#include <vector>

namespace resonform::test {

// 1 to 20 digits.
std::string decimal(Draw& draw, double low, double high);

// As it may stand in an equation or, in quotes, under [fix]: a decimal, or one in four exact, as "sqrt(2)".
std::string number(Draw& draw, double low, double high);

// What a coefficient may depend on: filled by who declares it.
struct Names {
    std::vector<std::string> slow;      // of any sign
    std::vector<std::string> positive;  // slow variables and parameters, declared positive
    std::vector<std::string> free;      // parameters of any sign
    std::vector<std::string> functions; // "f(s)", declared positive
};

// f(a) for a slow variable, a parameter or a product of them, by one of some thirty forms; positive: by one
// that is positive for all values. "" if there is nothing to depend on.
std::string drawn_function(Draw& draw, const Names& names, bool positive);

// +-number, one in four times a parameter, one in three times a function.
std::string drawn_coefficient(Draw& draw, const Names& names, double low, double high);

} // namespace resonform::test
