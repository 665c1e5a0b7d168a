// SPDX-License-Identifier: GPL-3.0-or-later
// The near-identity map y + c(y, eps) = Y solved for y at one point Y, through weight M, by substitutions
//
//   y <- Y - c(y, eps)          modes of lower weight first, slow variables and angles with these
//
// which is shorter than the inverse map (inverse_map.hpp) where that has many times the terms of c. Each
// substitution gains one or more weights, and needs c only through the weights that it makes right: of a
// cubic oscillator with M = 4, where c begins at weight 3, the first takes weight 3, the second 3 and 4.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace resonform {

// Of each series of the map: through which weight a substitution takes it; below 0: not at all.
struct SubstitutionStep {
    std::vector<int> mode, angle, slow;
};

// What is looked for.
struct SubstitutionFor {
    bool modes = true; // false: the new modes are given
    // A mode whose new value is 0: a state follows from it, and with that all old modes.
    std::optional<std::size_t> mode_at_zero = std::nullopt;
};
std::vector<SubstitutionStep> substitutions(const GradedField& field, const NearIdentityMap& map, int through,
                                            const SubstitutionFor& wanted);

} // namespace resonform
