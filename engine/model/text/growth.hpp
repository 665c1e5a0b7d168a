// SPDX-License-Identifier: GPL-3.0-or-later
// Upper bounds for the size of an expression, known before anything is evaluated, so that
// ((2^1000)^1000)^1000 is refused instead of computed.
#pragma once

#include <ginac/ginac.h>

namespace resonform {

// Bounds for the expanded form: its number of terms, its degree, and the size in bits of the largest
// number in it. Doubles, because the bounds themselves may be astronomic.
struct Growth {
    double terms = 1;
    double degree = 0;
    double bits = 0;
    double depth = 0; // levels of the expression as it stands, known after of_substitution
};

Growth of_sum(const Growth& a, const Growth& b);
Growth of_product(const Growth& a, const Growth& b);
Growth of_power(const Growth& base, double exponent);

// The growth of e when `symbol` is replaced by something of the growth `value`.
Growth of_substitution(const GiNaC::ex& e, const GiNaC::symbol& symbol, const Growth& value);
Growth of_expression(const GiNaC::ex& e);
// Terms of the exact form: sines and cosines, circular or hyperbolic, of sums are taken apart, too.
double terms_in_exact_form(const GiNaC::ex& e);
Growth growth_of_number(const GiNaC::numeric& n);

} // namespace resonform
