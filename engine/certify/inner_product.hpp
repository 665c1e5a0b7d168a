// SPDX-License-Identifier: GPL-3.0-or-later
// Part (b) of the certificate where the linear part lambda w + n w is not semisimple. On the monomials with
// D = 0, with <w^a, w^b> = a! delta_ab:
//
//   L* N = 0,   (L* f)_j = sum_ab n_ab w_a df_j/dw_b - sum_k n_kj f_k       (for variables that are no modes:
//               without the second sum)
//   h is orthogonal to the kernel of L: the vector of a! h_a is a combination of the rows of L
//
// checked on residues at the sample points: with L written out on all monomials of equal degrees, without the
// operator, the blocks and the linear algebra of the normaliser.
#pragma once

#include "certify/resonance.hpp"

namespace resonform {

std::string inner_product_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                                    const std::vector<FrequencySample>& samples, const Resonance& resonance);

// How many bits the minors of L add to the coefficients (bound.hpp): by Hadamard's bound for the largest
// block. 0 where the linear part is semisimple.
double inner_product_bits(const NormalForm& normal_form, const NearIdentityMap& map);

} // namespace resonform
