// SPDX-License-Identifier: GPL-3.0-or-later
// Part (b) of the certificate: the conditions on the exponents of normal form and map.
#pragma once

#include "certify/points/survey.hpp"
#include "certify/resonance.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <string>
#include <vector>

namespace resonform {

// All complaints are sentences; "" is none.

// One series for each variable, part n homogeneous of weight n; N from the weight of the mode, 0 (angles) or
// 1 on, the map from 1 on; nothing beyond M, no negative power of a generator that may vanish.
std::string shape_complaint(const NormalForm& normal_form, const NearIdentityMap& map, Surveyor& surveys);

// Every monomial of N is resonant, <alpha, lambda> = lambda_j (0 for other variables), and none of the map
// is; where the linear part is not semisimple, the condition of the inner product takes its place. A multiple
// of one frequency of an oscillator is decided by the exponents; else a divisor that vanishes at all samples
// is taken as zero. Precondition: shape_complaint() is empty.
std::string scan_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                           const std::vector<FrequencySample>& samples);

// From the complaints of parts (a) and (b).
void conclude(Certificate& certificate, const std::string& residual, const std::string& scan);

} // namespace resonform
