// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial as its content times terms whose coefficients are coprime integers:
//
//   2/3 x - 4/5 y  ->  content 2/15,  terms 5 x, -6 y
#pragma once

#include "algebra/ring/polynomial.hpp"

#include <vector>

namespace resonform {

// p/content(p), in the order of p. No division of rational numbers, which would look for common factors
// again.
std::vector<Term> primitive_terms(const Polynomial& p);

} // namespace resonform
