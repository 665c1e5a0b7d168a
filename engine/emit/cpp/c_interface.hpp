// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface around an emitted class that emit_library promises, for double, long double, __float128.
#pragma once

#include "emit/program/program.hpp"

#include <string>
#include <string_view>

namespace resonform {

// evaluator: the qualified name of the class template; types: their letters.
std::string cpp_c_interface(const Program& program, const std::string& evaluator, std::string_view types);

} // namespace resonform
