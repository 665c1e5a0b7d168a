// SPDX-License-Identifier: GPL-3.0-or-later
// Exact division of Laurent polynomials, no relation applied:
//   (xi^3 + xi r^2) / (xi^2 + r^2) = xi;   xi / (xi^2 + r^2) = nullopt
#pragma once

#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/ring.hpp"

#include <optional>

namespace resonform {

// p/q if q (not zero) divides p among the Laurent polynomials in the generators of the ring.
std::optional<Polynomial> divide_exactly(const Ring& ring, const Polynomial& p, const Polynomial& q);

} // namespace resonform
