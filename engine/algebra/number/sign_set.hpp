// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of a polynomial in one variable where conditions hold: exact, by Sturm's theorem.
//
//   x - 1 where x > 0, x^2 - 2 > 0   ->   positive            x - 2 where x > 0   ->   all three
#pragma once

#include "algebra/number/number.hpp"

#include <vector>

namespace resonform {

using UnivariatePolynomial = std::vector<Rational>; // of 1, x, x^2, ...

struct SignSet {
    bool negative = false, zero = false, positive = false;

    [[nodiscard]] bool empty() const { return !negative && !zero && !positive; }
    void insert(int sign) { (sign < 0 ? negative : sign > 0 ? positive : zero) = true; }
};

struct SignCondition { // p > 0, or p >= 0
    UnivariatePolynomial polynomial;
    bool strict = true;
};

// Of p at the real x at which all conditions hold; empty: at none do they.
// Cost: that of separating the real roots of the product of all polynomials.
SignSet signs_where(const UnivariatePolynomial& p, const std::vector<SignCondition>& conditions);

} // namespace resonform
