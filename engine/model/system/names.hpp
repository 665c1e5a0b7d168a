// SPDX-License-Identifier: GPL-3.0-or-later
// The names that a user may give, and those of the constants of a solution.
#pragma once

#include "model/system/system_file.hpp"

#include <string>
#include <vector>

namespace resonform {

bool is_identifier(const std::string& name); // [A-Za-z][A-Za-z0-9_]*, at most 60 characters
std::string identifier_rule(const std::string& what);
std::string identifier_hint();

bool is_mode(const std::string& name); // z1, z2, ...
// I, pi, E, eps, lambda, t, the modes z1, z2, ..., the functions, and the words of Python and SymPy.
bool is_reserved(const std::string& name);

// The constants that the solution of a variable has: fast: amplitude, phase; drift: constant.
std::vector<std::string> constant_kinds(Role role);

// "delta_x": x measured from its equilibrium.
std::string deviation_name(const std::string& variable);

} // namespace resonform
