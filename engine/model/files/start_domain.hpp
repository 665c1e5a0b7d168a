// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that a motion begins where the system is declared to be defined.
#pragma once

#include "model/system/scene_file.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

// Checks the expressions of [domain] with the start values and [fix] put in; one that still holds a parameter
// is left to the evaluator. fix: the table [fix] of the scene, or nullptr.
// Errors (bad_input): one is negative, zero or not finite; the place is the start value in it, else the
// fixed one.
void check_start_domain(const Scene& scene, const TomlNode* fix);

} // namespace resonform
