// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers in place of parameters: --set g=1 r=4/5.
#pragma once

#include "model/system/system_file.hpp"

#include <string>
#include <vector>

namespace resonform {

// "g=1". Errors (bad_input, the place is `option`): no name or no value.
Setting read_setting(const std::string& text, const std::string& option);

// The system with the values put in: the parameters are gone from its equations and its table, and the
// settings are noted in it.
// Errors (bad_input, the place is `option`): no such parameter, one that is set twice, a value that is no
// expression in numbers, or that is outside what the file declares (positive, nonzero, [domain]).
System with_settings(System system, const std::vector<Setting>& settings, const std::string& option);

} // namespace resonform
