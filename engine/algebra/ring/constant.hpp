// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of a ring that do not depend on a variable.
#pragma once

#include "algebra/ring/ring.hpp"

namespace resonform {

// Whether p holds nothing but parameters and roots of constants.
[[nodiscard]] bool is_constant(const Ring& ring, const Polynomial& p);

} // namespace resonform
