// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of products of polynomials as fractions: the engine spends most of its time here.
#pragma once

#include "algebra/ring/fractions.hpp"
#include "algebra/ring/packing.hpp"

#include <vector>

namespace resonform {

// sum_k c_k a_k b_k of operands with different monomials each: different monomials in an order of no meaning,
// no zero, not reduced. No relation is applied. With the packing of the monomials large sums are collected in
// two threads, where the machine has them.
Fractions sum_of_products(const std::vector<FractionProduct>& products, const Packing* packing = nullptr);

// The same terms, with equal monomials added in the same way.
Fractions collected(const Fractions& f);

// Exponents that could overflow in one product are refused.
void require_safe(const Packing& packing, const std::vector<FractionProduct>& products);

} // namespace resonform
