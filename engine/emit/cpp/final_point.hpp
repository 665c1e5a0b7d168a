// SPDX-License-Identifier: GPL-3.0-or-later
// The member at_end of an emitted evaluator: one point without tables.
#pragma once

#include "emit/cpp/plan.hpp"

#include <string>

namespace resonform {

// The public function.
std::string cpp_at_end(const CppPlan& plan);

// What it calls, besides `begin` and the functions of emit/cpp/stages.hpp.
std::string cpp_course(const CppPlan& plan);

} // namespace resonform
