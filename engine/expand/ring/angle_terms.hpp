// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments of functions as sums of rational multiples, and what the cosine and sine of a sum are.
#pragma once

#include "algebra/number/number.hpp"

#include <ginac/ginac.h>

#include <vector>

namespace resonform {

bool is_rational_number(const GiNaC::ex& e);

// factor * part
struct Multiple {
    Rational factor;
    GiNaC::ex part;
};
Multiple one_multiple(const GiNaC::ex& term);
// Of a sum, its terms that are not 0.
std::vector<Multiple> multiples(const GiNaC::ex& sum);

// Of one angle.
struct CosineSine {
    GiNaC::ex cosine, sine;
};
CosineSine sum_of(const CosineSine& a, const CosineSine& b);

} // namespace resonform
