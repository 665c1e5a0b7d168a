// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of CLN as integers of GMP and back, limb by limb. (CLN gives no access to limbs, GMP does.)
#pragma once

#include "algebra/number/number.hpp"

#include <gmpxx.h>

#include <cstddef>

namespace resonform {

mpz_class to_mpz(const Integer& value);

// The least significant limb first.
Integer from_limbs(const mp_limb_t* limbs, std::size_t count);

} // namespace resonform
