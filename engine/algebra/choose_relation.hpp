// SPDX-License-Identifier: GPL-3.0-or-later
// How sigma^k = radicand is read as a rewriting rule (RingBuilder::freeze says which and why).
#pragma once

#include "algebra/relation.hpp"
#include "algebra/ring.hpp"

#include <optional>
#include <vector>

namespace resonform {

// The rule for the root `id`, given those chosen before (which `ring` already applies). Every rule is
// a true identity. The rules end and give unique forms because their leads are distinct and no rule's
// value holds the lead of an earlier rule of several terms: they are a Groebner basis in a
// lexicographic order (leading terms pairwise coprime). nullopt: no sound rule was found, which only
// costs canonical forms.
std::optional<Relation> choose_relation(const Ring& ring, const std::vector<Relation>& before,
                                        GeneratorId id);

} // namespace resonform
