// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of the near-identity map, through the same weight M. From z = w + h(w), X = Z + l(w):
//   w = z + g(z, zbar, eps; xi),   g = -h(z + g)        weight by weight: h starts at weight 2, so that
//   Z = X + m(z, zbar, eps; xi),   m = -l(z + g)        [h(z + g)]_n needs g only below weight n
#pragma once

#include "normalize/normal_form.hpp"

namespace resonform {

// The new variable minus the old one: g and m, in which the generators of the modes stand for the old
// variables z. Precondition: map.mode starts at weight 2.
NearIdentityMap invert(const NormalForm& normal_form, const NearIdentityMap& map);

// p(w + s, wbar + conj s, eps; xi) through a weight; shift[k] is the s of mode k.
Series compose(const GradedField& field, const Series& p, const std::vector<Series>& shift, int through);

} // namespace resonform
