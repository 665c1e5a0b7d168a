// SPDX-License-Identifier: GPL-3.0-or-later
// The second route (design section 3): map and normal form are substituted into the ORIGINAL
// equations of the file at random points modulo several primes, and the normal form is scanned.
#pragma once

#include "normalize/normal_form.hpp"

#include <cstdint>

namespace resonform {

// Checks through normal_form.through. `seed` chooses points and primes; the default is fixed, so that
// the same input gives the same answer.
Certificate certify(const NormalForm& normal_form, const NearIdentityMap& map, std::uint64_t seed = 1);

} // namespace resonform
