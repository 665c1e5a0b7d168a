// SPDX-License-Identifier: GPL-3.0-or-later
// w = z + g(z, zbar, eps; xi): the inverse of the near-identity map, through the same weight; the
// drift: Z = X + m(z, zbar, eps; xi).
#pragma once

#include "normalize/normal_form.hpp"

namespace resonform {

// The new variable minus the old one, as functions of the old ones.
NearIdentityMap invert(const NormalForm& normal_form, const NearIdentityMap& map);

// p(w, wbar, ...) with w -> w + shift(w, ...) through a weight: substitution of a near-identity map.
Series compose(const GradedField& field, const Series& p, const std::vector<Series>& shift, int through);

} // namespace resonform
