// SPDX-License-Identifier: GPL-3.0-or-later
// The modes that a user gives in [modes], proved: A T = T Lambda, T invertible, frequencies positive.
#pragma once

#include "expand/modes/mode_blocks.hpp"
#include "expand/modes/modes.hpp"

namespace resonform {

// `states`: the fast ones; a: the linear part over them. The rows are those of the inverse of T.
// Precondition: system.system->modes is not empty.
// Errors: bad_input: a residual A u - lambda u that is not zero, columns that are linearly dependent, a pair
// given by its second mode; refused: a residual that can be told neither zero nor nonzero, a determinant or
// a frequency whose sign is not proved.
ModalBasis given_modal_basis(const FirstOrderSystem& system, std::vector<std::size_t> states, const Matrix& a,
                             const CoefficientRing& coefficients);

} // namespace resonform
