// SPDX-License-Identifier: GPL-3.0-or-later
// From the linear part of a system to its modes.
#pragma once

#include "expand/modes/modes.hpp"

namespace resonform {

// The modes that the user gives, proved; else closed forms: blocks of at most two states, larger ones whose
// characteristic polynomial falls into factors with closed roots, triangular couplings between blocks. Only
// the vanishing symbols of `coefficients` are used; it need not be frozen. Errors: bad_input: a force at the
// origin, division by an expression that is zero; refused: a block without closed roots, a sign that is not
// proved, a linear part that is not semisimple where the style of the system is not inner_product. Those of
// given modes: expand/modes/given_modes.hpp. With System::digits blocks without closed roots have numeric
// modes (expand/modes/numeric_modes.hpp).
ModalBasis find_modes(const FirstOrderSystem& system, const CoefficientRing& coefficients);

} // namespace resonform
