// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/system/scene_file.hpp"
#include "normalize/recursion/normal_form.hpp"

namespace resonform {

// Errors (refused): the values under [fix] make a divisor zero that was divided by. The message names its
// monomial and the combination of frequencies: D(z1^2) of z3 = I*(2*w1 - w2).
void require_divisors(const Normalization& normalization, const Scene& scene);

} // namespace resonform
