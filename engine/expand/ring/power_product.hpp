// SPDX-License-Identifier: GPL-3.0-or-later
// A power of a coefficient function as a product of powers of irreducible bases:
//
//   sqrt(g*sqrt(xi^2 + r^2)/(xi^2 + r^2))  ->  g^(1/2) * (xi^2 + r^2)^(-1/4)
//   (4 + 4*tau^2)^(-1/2)                   ->  1/2 * (1 + tau^2)^(-1/2)
//
// The bases become the invertible generators of the coefficient ring.
#pragma once

#include "algebra/number/number.hpp"
#include "expand/ring/coefficient_domain.hpp"
#include "model/text/diagnostic.hpp"

#include <ginac/ginac.h>

#include <vector>

namespace resonform {

struct PowerFactor {
    GiNaC::ex base;    // a symbol, a positive integer, or an expanded primitive sum
    Rational exponent; // fractional only where the base is proved positive
};

struct PowerProduct {
    Rational number = 1;
    std::vector<PowerFactor> factors; // equal bases are not merged; order is arbitrary
};

// base^exponent for a base in parameters, slow variables and symbols of functions.
// Errors: bad_input where the base is identically zero and the exponent negative; refused where a
// fractional power of a base not proved positive, or a negative power of one not proved non-zero, is
// asked for. `place` is put into the message.
PowerProduct split_power(const GiNaC::ex& base, const Rational& exponent, const CoefficientDomain& domain,
                         const Place& place);

// The hint where e is not proved to be positive: the declaration to write into the system file.
std::string how_to_make_positive(const GiNaC::ex& e);

} // namespace resonform
