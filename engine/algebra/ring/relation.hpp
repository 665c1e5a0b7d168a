// SPDX-License-Identifier: GPL-3.0-or-later
// One rewriting rule of a Ring: lead^degree -> value.
//
//   i^2 -> -1                      total: every exponent is brought into 0 ... degree - 1
//   g -> G^2                       total: g^-1 -> G^-2
//   xi^2 -> sigma^4 - r^2          only exponents >= degree are rewritten
#pragma once

#include "algebra/ring/fractions.hpp"
#include "algebra/ring/packing.hpp"
#include "algebra/ring/polynomial.hpp"

#include <vector>

namespace resonform {

struct Relation {
    int lead = 0;     // the generator that is rewritten
    int degree = 1;   // >= 1
    Polynomial value; // degree in `lead` < degree; one term without `lead` if total
    bool total = false;

    [[nodiscard]] bool applies(const Packing& packing, const Monomial& m) const {
        const int e = packing.exponent(m, lead);
        return e >= degree || (total && e < 0);
    }
};

// Whether no relation applies to any term.
bool is_reduced(const Packing& packing, const std::vector<Relation>& relations, const Fractions& f);
// Rewrites until no relation applies. The result is not canonical; exponents that overflow are refused.
Fractions rewrite(const Packing& packing, const std::vector<Relation>& relations, Fractions f);

} // namespace resonform
