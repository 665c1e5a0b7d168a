// SPDX-License-Identifier: GPL-3.0-or-later
// The order of GivenNumbers::numbers: for each mode and each of its `states` fast states three numbers.
#pragma once

#include <cstddef>

namespace resonform {

enum class NumberOf : std::size_t { column, conjugate_column, row };

inline std::size_t number_index(std::size_t mode, std::size_t state, std::size_t states, NumberOf what) {
    return 3 * (mode * states + state) + static_cast<std::size_t>(what);
}

} // namespace resonform
