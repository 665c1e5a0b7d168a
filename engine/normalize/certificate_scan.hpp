// SPDX-License-Identifier: GPL-3.0-or-later
// Part (b) of the certificate: what can be read off the exponents of normal form and map.
#pragma once

#include "algebra/modular.hpp"
#include "normalize/normal_form.hpp"

#include <string>
#include <vector>

namespace resonform {

// All complaints are sentences; "" is none.

// One series for each variable, part n homogeneous of weight n, N from weight 1, h from 2 and l from 1 on,
// nothing beyond M, no negative power of what may vanish.
std::string shape_complaint(const NormalForm& normal_form, const NearIdentityMap& map);

// The frequencies at one random point modulo a prime.
struct FrequencySample {
    PrimeField field;
    std::vector<Residue> omega; // of each mode
};

// Every monomial of N is resonant, <alpha, lambda> = lambda_j (0 for slow and drift variables), and none of
// h, l is. With one oscillator the exponents decide; with several, a divisor that vanishes at all
// samples is taken as zero. Precondition: shape_complaint() is empty.
std::string scan_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                           const std::vector<FrequencySample>& samples);

} // namespace resonform
