// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations over expressions, by elimination with pivots that are proved to differ from zero.
#pragma once

#include "expand/modes/mode_blocks.hpp"
#include "expand/ring/complex_expression.hpp"

#include <optional>

namespace resonform {

// The inverse of a square matrix; nothing if no pivot of some column is proved nonzero.
std::optional<Matrix> inverse(Matrix a);

// v with a v = right, over complex numbers; nothing as above.
std::optional<std::vector<Complex>> solve_linear(std::vector<std::vector<Complex>> a,
                                                 std::vector<Complex> right);

} // namespace resonform
