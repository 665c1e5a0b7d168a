// SPDX-License-Identifier: GPL-3.0-or-later
// An equation of the file for print, in the user's own order of terms and factors (GiNaC keeps none).
#pragma once

#include "emit/display.hpp"
#include "model/system_file.hpp"

namespace resonform {

struct WrittenEquation {
    DisplaySum left, right;
};

// Precondition: the text was read without an error (model/expression.hpp).
WrittenEquation as_written(const Equation& equation);

} // namespace resonform
