// SPDX-License-Identifier: GPL-3.0-or-later
// Inverses of numbers made of roots: 1/(1 + sqrt(2)) = sqrt(2) - 1, an element of the ring, so that nothing
// has to be adjoined.
#pragma once

#include "algebra/ring/ring.hpp"

#include <optional>

namespace resonform {

// sqrt(2), sqrt(2 + sqrt(2)): nothing but numbers under the root.
bool is_numeric_root(const Ring& ring, GeneratorId id);

// 1/p for p = (invertible monomial) x (sum over numeric roots, nested ones and i included); nullopt if p is
// not of this kind, or has no inverse there (is zero, or a zero divisor where roots depend on one another).
// Cost: linear equations as many as the product of the indices of the roots, at most 64.
std::optional<Polynomial> inverse_in_number_field(const Ring& ring, const Polynomial& p);

} // namespace resonform
