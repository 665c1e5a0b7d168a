// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of polynomials where others are positive: by their factors, and of factors by eliminating
// variables (open_cells.hpp).
//
//   x^2 - x - 1 where x - 2 > 0   ->   positive        x^2 - 2*x*y + 2*y^2 where y > 0   ->   positive
//   x where x^2 - 2 > 0   ->   negative or positive    x^2 - 2*x*y + y^2   ->   zero or positive
#pragma once

#include "algebra/signs/eliminants.hpp"
#include "algebra/signs/sign_set.hpp"

#include <utility>
#include <vector>

namespace resonform {

class PolynomialSigns {
public:
    // variable^2 = above/below, in variables before it; the root is not negative.
    struct SquareRoot {
        slong variable;
        Packed above, below;
    };
    PolynomialSigns(const std::vector<Packed>& positive, std::vector<SquareRoot> roots);

    // The signs of p where all of `positive` are positive. Empty: one of these is a number that is not.
    SignSet of(const Packed& p);

private:
    struct Condition {
        Packed polynomial; // without squares
        std::vector<Packed> factors;
    };

    SignSet of_factor(const Packed& q);
    SignSet decide(const Packed& q, const std::vector<Packed>& own, SignSet signs);
    SignSet by_fewer_variables(const Packed& q);
    SignSet by_root(const Packed& q, const SquareRoot& root);
    [[nodiscard]] std::vector<const Condition*> linked_with(const Packed& q, bool through_others) const;
    bool vanishes_only_where_it_changes(const Packed& q);
    SignSet& learned(const Packed& q);
    void learn(const FactoredPolynomial& condition);

    std::vector<Condition> conditions_;
    std::vector<SquareRoot> roots_;
    std::vector<std::pair<Packed, SignSet>> learned_, decided_; // of irreducible ones
};

} // namespace resonform
