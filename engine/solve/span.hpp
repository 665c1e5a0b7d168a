// SPDX-License-Identifier: GPL-3.0-or-later
// Exact linear algebra on polynomials as vectors over the rationals (monomials are the basis).
//
//   Span s; s.add(x + y); s.add(x - y);   s.decompose(4 x + z)  ->  coordinates (2, 2), remainder z
#pragma once

#include "algebra/ring/polynomial.hpp"

#include <map>
#include <vector>

namespace resonform {

class Span {
public:
    // The k-th polynomial added carries coordinate k; one that depends on earlier ones gets 0 always.
    void add(const Polynomial& p);

    struct Decomposition {
        std::vector<Rational> coordinates; // one per polynomial added
        Polynomial remainder;              // empty if and only if the target lies in the span
    };
    // target = sum_k coordinates[k] p_k + remainder; the remainder holds no leading monomial of the
    // echelon form, which makes the decomposition unique.
    [[nodiscard]] Decomposition decompose(Polynomial target) const;

private:
    struct Row {
        Polynomial vector; // leading coefficient 1
        std::vector<Rational> combination;
    };
    std::map<Monomial, Row> rows_; // by leading (greatest) monomial
    std::size_t count_ = 0;
};

} // namespace resonform
