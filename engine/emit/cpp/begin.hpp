// SPDX-License-Identifier: GPL-3.0-or-later
// What an emitted evaluator does before any time is known: it checks its arguments but for eps, computes the
// constants from them, and tells whether the solution may start there.
#pragma once

#include "emit/cpp/plan.hpp"

#include <string>

namespace resonform {

// The member `begin`.
std::string cpp_begin(const CppPlan& plan);

// The emitted call that computes the constants in the type of `target`; the code before it has checked the
// arguments.
std::string cpp_constants_call(const CppPlan& plan, const std::string& which, const std::string& target);

} // namespace resonform
