// SPDX-License-Identifier: GPL-3.0-or-later
// The values that keys of a system or scene file may hold, checked: each function returns the value or throws
// bad_input with the key, the value found and the type or range wanted.
#pragma once

#include "model/text/expression.hpp"
#include "model/text/toml_tree.hpp"

#include <string>
#include <vector>

namespace resonform {

// Errors: not a table; a key that is not among `known` (with the nearest known).
void check_keys(const TomlNode& table, const std::vector<std::string>& known);
void check_table(const TomlNode& node);

std::string string_of(const TomlNode& node);
// Words for a reader, as one line fit to be printed: in a terminal, a comment, a page.
std::string line_of(const TomlNode& node);
bool boolean_of(const TomlNode& node);
int integer_of(const TomlNode& node, int lowest, int highest);
// Exact: a TOML number as it is spelled, or a string such as "1/3".
Rational number_of(const TomlNode& node);
// A TOML number as it is spelled, or a string read over `scope`.
GiNaC::ex expression_of(const TomlNode& node, const Scope& scope);

// The message of one node: its text is the value, its place the place.
[[noreturn]] void bad_value(const TomlNode& node, const std::string& rule, const std::string& hint);

} // namespace resonform
