// SPDX-License-Identifier: GPL-3.0-or-later
// The public part of an emitted class: Parameters, Start, Values, constructors, calls.
#pragma once

#include "emit/cpp/further.hpp"
#include "emit/cpp/plan.hpp"

#include <string>
#include <vector>

namespace resonform {

std::string cpp_interface(CppPlan& plan, const std::vector<PlannedFurther>& further);

// Tables of the members of Parameters and Start and of the arrays of Members that belong to them.
std::string cpp_fields(const CppPlan& plan);

// The arrays of Members besides eps: those of Parameters, then those of Start.
std::vector<std::string> cpp_argument_arrays(const CppPlan& plan);

// A member `head`(t, low, values) that computes the results of `type` by `function`.
std::string cpp_call(const std::string& head, const std::string& type, const std::string& function,
                     const std::vector<CppResult>& list);

} // namespace resonform
