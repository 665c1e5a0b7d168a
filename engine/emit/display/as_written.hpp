// SPDX-License-Identifier: GPL-3.0-or-later
// An equation of the file for print, in the user's own order of terms and factors (GiNaC keeps none).
#pragma once

#include "emit/display/display.hpp"
#include "model/system/system_file.hpp"

#include <string>
#include <vector>

namespace resonform {

struct WrittenEquation {
    DisplaySum left, right;
};

// Values stand in place of the parameters that are set.
// Precondition: text and values were read without an error (model/text/expression.hpp).
WrittenEquation as_written(const Equation& equation, const std::vector<Setting>& settings = {});

// A text in the notation of the file with each parameter that is set replaced by its value, in parentheses.
std::string with_values(const std::string& text, const SourceText& source,
                        const std::vector<Setting>& settings);

} // namespace resonform
