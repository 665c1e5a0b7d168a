// SPDX-License-Identifier: GPL-3.0-or-later
// Inner-product normal form, for linear parts w' = lambda w + n w that are not semisimple (design 2.3). With
//
//   (L c)_j = D c_j + sum_ab n_ab w_b dc_j/dw_a - sum_k n_jk c_k         (modes; other variables: no n_jk)
//
// the homological equation is L c = R - N. Where D is not zero, N = 0 and c = sum_k (-L_n)^k D^(-k-1) R. On
// the monomials with D = 0, with <w^a, w^b> = a! delta_ab and n^T in place of n in the adjoint L*:
//
//   L* N = 0 (N in ker ad of A*),   c orthogonal to ker L,   so that N and c are the smallest
//
// (Elphick, Tirapegui, Brachet, Coullet, Iooss, Physica D 29 (1987) 95). Where n = 0 this is Poincare's.
#pragma once

#include "normalize/recursion/poincare.hpp"

namespace resonform {

// 1 <= through <= 99. The certificate is left empty.
Normalization normalize_inner_product(std::shared_ptr<const GradedField> field, int through,
                                      const NormalizeOptions& options = {});

} // namespace resonform
