// SPDX-License-Identifier: GPL-3.0-or-later
// A monomial with its coefficient.
#pragma once

#include "algebra/number/number.hpp"
#include "algebra/ring/monomial.hpp"

namespace resonform {

struct Term {
    Monomial monomial;
    Rational coefficient;

    friend bool operator==(const Term& a, const Term& b) {
        return a.monomial == b.monomial && a.coefficient == b.coefficient;
    }
};

} // namespace resonform
