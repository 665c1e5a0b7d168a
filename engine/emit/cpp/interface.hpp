// SPDX-License-Identifier: GPL-3.0-or-later
// The public part of an emitted class: Parameters, Start, Values, constructors, calls.
#pragma once

#include "emit/cpp/plan.hpp"

#include <string>

namespace resonform {

std::string cpp_interface(CppPlan& plan);

} // namespace resonform
