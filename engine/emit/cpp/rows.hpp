// SPDX-License-Identifier: GPL-3.0-or-later
// Text of the rows that outputs are sums of (runtime/rows.hpp), and of the atoms that they are made of.
#pragma once

#include "emit/cpp/plan.hpp"

#include <string>
#include <vector>

namespace resonform {

// The member `terms` of Rows.
std::string cpp_terms(const CppPlan& plan);

// Where calls sum rows: the member row_list of the class, else "".
std::string cpp_row_list(const CppPlan& plan);

// Statements of `outputs` that set the array `sums` to the outputs at the arguments `a`.
std::vector<std::string> cpp_sums(const CppPlan& plan);

// Statements that return an array of `type` with these values; where a loop walks the constants, those among
// them in runs.
std::vector<std::string> cpp_return_list(const CppPlan& plan, const std::string& type,
                                         const std::vector<StraightLine::Value>& values,
                                         const std::vector<std::string>& texts);

} // namespace resonform
