// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the class template Evaluator of a program.
#pragma once

#include "emit/program/program.hpp"

#include <string>

namespace resonform {

std::string cpp_class(const Program& program);

} // namespace resonform
