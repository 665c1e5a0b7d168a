// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of an emitted class that do its arithmetic: constants, integrands of tables, rates of
// phases, outputs.
#pragma once

#include "emit/cpp/plan.hpp"

#include <string>

namespace resonform {

std::string cpp_stages(CppPlan& plan);

} // namespace resonform
