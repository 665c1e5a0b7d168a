// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers in place of parameters: --set g=1 r=4/5, and [fix] of a scene.
#pragma once

#include "model/system/scene_file.hpp"

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

// Whether the parameter has a value in it by a setting.
bool is_set(const System& system, const std::string& parameter);

// The system of a scene with the values of [fix] put in. Errors: those of with_settings.
std::shared_ptr<const System> system_with_fix(const Scene& scene);
// The scene about this system: its start values and its interval have the values put in, too.
Scene with_fix_put_in(Scene scene);

} // namespace resonform
