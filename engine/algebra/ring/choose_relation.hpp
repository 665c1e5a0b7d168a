// SPDX-License-Identifier: GPL-3.0-or-later
// How sigma^k = radicand becomes a rewriting rule (which one and why: RingBuilder::freeze).
#pragma once

#include "algebra/ring/relation.hpp"
#include "algebra/ring/ring.hpp"

#include <optional>
#include <vector>

namespace resonform {

// The rule for the root `id`, given those chosen before (which `ring` already applies). Every rule is
// a true identity. Leads are distinct, and "the value of this rule holds the lead of that one" is free
// of cycles: in the lexicographic order it gives, the leading terms lead^degree are pairwise coprime,
// so that the rules are a Groebner basis, rewriting ends, and forms are unique. nullopt: no such rule
// was found, which only costs canonical forms.
std::optional<Relation> choose_relation(const Ring& ring, const std::vector<Relation>& before,
                                        GeneratorId id);

// The same for p = 0 (sin^2 + cos^2 - 1, reduced), solved for the highest power of one of the candidates.
std::optional<Relation> solve_for_one_of(const Ring& ring, const std::vector<Relation>& before,
                                         const Polynomial& p, const std::vector<GeneratorId>& candidates);

} // namespace resonform
