// SPDX-License-Identifier: GPL-3.0-or-later
// What an evaluator computes once: the struct of its constants, the function that computes them, that which
// keeps those of any range, and the conditions on the start.
#pragma once

#include "emit/cpp/plan.hpp"

#include <string>

namespace resonform {

std::string cpp_constants(CppPlan& plan);

} // namespace resonform
