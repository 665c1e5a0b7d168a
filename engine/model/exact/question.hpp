// SPDX-License-Identifier: GPL-3.0-or-later
// Is an expression zero in the domain of a system? Asked once more in exact form (form.hpp), where two
// spellings of the same functions and roots become the same polynomial.
//
//   is (1 - w)^(3/2) - (1 - w)^(1/2) + w*(1 - w)^(1/2) zero?           yes
#pragma once

#include "model/system/system_file.hpp"
#include "model/text/zero_test.hpp"

namespace resonform {

// In the domain of the system; where vanishes(e) does not know, by the relations of functions and roots.
Zero vanishes(const GiNaC::ex& e, const System& system);

} // namespace resonform
