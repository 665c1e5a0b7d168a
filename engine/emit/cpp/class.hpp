// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the class template Evaluator of a program.
#pragma once

#include "emit/cpp/further.hpp"
#include "emit/cpp/lies.hpp"

#include <string>
#include <vector>

namespace resonform {

// With formulas that go further, it estimates errors. lies: where its coefficients are to be planted.
std::string cpp_class(const Program& program, const std::vector<CppFurther>& further = {},
                      CppLies* lies = nullptr);

} // namespace resonform
