// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of products of polynomials: where the time of the engine goes.
#pragma once

#include "algebra/packing.hpp"
#include "algebra/polynomial.hpp"

#include <utility>
#include <vector>

namespace resonform {

using Pairs = std::vector<std::pair<const Polynomial*, const Polynomial*>>;

// sum_k a_k b_k, collected, in any order, no relation applied. Exponents that overflow are refused.
std::vector<Term> collect_products(const Packing& packing, const Pairs& pairs);

} // namespace resonform
